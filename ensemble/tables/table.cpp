#include "tables/table.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "core/text.hpp"

namespace floes {

namespace {

constexpr std::size_t column_gap = 2;
constexpr std::size_t panel_gap = 3;

std::string spaces(std::size_t width, const std::string& beside) {
    return std::string(width - std::min(width, text_width(beside)), ' ');
}

std::string without_trailing_spaces(const std::string& line) {
    return line.substr(0, line.find_last_not_of(' ') + 1);
}

/// Values flush right, then their ranges flush left: a cell is one text, and no line parts the two.
std::vector<std::vector<std::string>> texts_of(const Table& table) {
    std::vector<std::vector<std::string>> rows(table.size());
    for (std::size_t k = 0; k < table.front().size(); ++k) {
        std::size_t range_width = 0;
        for (std::size_t r = 1; r < table.size(); ++r)
            range_width = std::max(range_width, text_width(table[r][k].range.value_or("")));
        for (std::size_t r = 0; r < table.size(); ++r) {
            const Cell& cell = table[r][k];
            const std::string range = cell.range.value_or("");
            std::string& text = rows[r].emplace_back(cell.value);
            const bool aligned = r > 0 && k > 0 && range_width > 0;
            if (aligned || !range.empty()) text += " " + range;
            if (aligned) text += spaces(range_width, range);
        }
    }
    return rows;
}

struct PanelWidths {
    std::size_t label = 0;
    std::size_t value = 0;
    std::size_t range = 0;

    explicit PanelWidths(const Table& table) {
        for (const std::vector<Cell>& row : table) {
            label = std::max(label, text_width(row.front().value));
            for (std::size_t k = 1; k < row.size(); ++k) {
                value = std::max(value, text_width(row[k].value));
                range = std::max(range, text_width(row[k].range.value_or("")));
            }
        }
    }
    std::size_t column() const { return panel_gap + value + 1 + range; }
};

std::string panel_line(const std::vector<Cell>& row, const PanelWidths& widths, std::size_t first, std::size_t last) {
    std::string text = row.front().value + spaces(widths.label, row.front().value);
    for (std::size_t k = first; k < last; ++k) {
        const std::string range = row[k].range.value_or("");
        text += std::string(panel_gap, ' ') + spaces(widths.value, row[k].value) + row[k].value + ' ' + range +
                spaces(widths.range, range);
    }
    return without_trailing_spaces(text) + "\n";
}

}  // namespace

std::size_t text_width(std::string_view text) {
    // UTF-8 continuation bytes have no width.
    return static_cast<std::size_t>(std::ranges::count_if(text, [](char byte) { return (byte & 0xC0) != 0x80; }));
}

std::string text_columns(const Table& table, int width) {
    const std::vector<std::vector<std::string>> rows = texts_of(table);
    std::vector<std::size_t> widths(rows.front().size(), 0);
    for (const auto& row : rows) {
        for (std::size_t i = 0; i < row.size(); ++i) widths[i] = std::max(widths[i], text_width(row[i]));
    }
    std::string text;
    for (std::size_t first = 1; first < widths.size();) {
        std::size_t taken = widths[0];
        std::size_t last = first;
        while (last < widths.size() &&
               (last == first || taken + column_gap + widths[last] <= static_cast<std::size_t>(std::max(width, 0)))) {
            taken += column_gap + widths[last++];
        }
        if (first > 1) text += "\n";
        for (std::size_t r = 0; r < rows.size(); ++r) {
            std::string line = rows[r][0] + spaces(widths[0], rows[r][0]);
            for (std::size_t i = first; i < last; ++i) {
                line += std::string(column_gap, ' ') + spaces(widths[i], rows[r][i]) + rows[r][i];
            }
            text += without_trailing_spaces(line) + "\n";
            if (r == 0) text += std::string(taken, '-') + "\n";
        }
        first = last;
    }
    return text;
}

std::string text_panels(const Table& table, int width) {
    const PanelWidths widths{table};
    const std::size_t columns = table.front().size();
    const std::size_t room = static_cast<std::size_t>(std::max(width, 0));
    const std::size_t abreast = std::max<std::size_t>(1, (room - std::min(room, widths.label)) / widths.column());
    std::string text;
    for (std::size_t first = 1; first < columns; first += abreast) {
        const std::size_t last = std::min(columns, first + abreast);
        if (first > 1) text += "\n";
        text += panel_line(table.front(), widths, first, last);
        text += std::string(widths.label + (last - first) * widths.column(), '-') + "\n";
        for (std::size_t r = 1; r < table.size(); ++r) text += panel_line(table[r], widths, first, last);
    }
    return text;
}

std::string html_table(const Table& table) {
    std::string rows;
    for (const std::vector<Cell>& row : table) {
        const char* kind = rows.empty() ? "th" : "td";
        rows += "<tr>";
        for (const Cell& cell : row) {
            std::string content = (cell.value.starts_with("  ") ? "&emsp;" : "") + markup_escaped(cell.value);
            if (cell.range) content += fmt::format("<br><small>{}</small>", markup_escaped(*cell.range));
            rows += fmt::format("<{0}>{1}</{0}>", kind, content);
        }
        rows += "</tr>\n";
    }
    return "<div class=\"wide\"><table>" + rows + "</table></div>\n";
}

namespace {

constexpr int widest_prose = 110;

void wrap_line(std::string_view line, std::size_t width, std::string& out) {
    std::size_t taken = 0;
    while (!line.empty()) {
        const std::size_t end = std::min(line.find(' '), line.size());
        const std::string_view word = line.substr(0, end);
        const std::size_t length = text_width(word);
        if (taken > 0 && taken + 1 + length > width) {
            out += '\n';
            taken = 0;
        }
        if (taken > 0) {
            out += ' ';
            ++taken;
        }
        out += word;
        taken += length;
        line.remove_prefix(std::min(end + 1, line.size()));
    }
}

/// A command, and behind two spaces or more what it does.
void add_command(std::string_view line, std::size_t width, std::string& out) {
    const std::size_t command = line.find_first_not_of(' ');
    const std::size_t gap = command == std::string_view::npos ? command : line.find("  ", command);
    if (text_width(line) <= width || gap == std::string_view::npos) {
        out += line;
        return;
    }
    out += line.substr(0, gap);
    out += "\n" + std::string(command + 2, ' ');
    out += line.substr(std::min(line.find_first_not_of(' ', gap), line.size()));
}

}  // namespace

std::string wrapped(std::string_view text, int width) {
    const auto room = static_cast<std::size_t>(std::clamp(width, 1, widest_prose));
    std::string out;
    while (!text.empty()) {
        const std::size_t end = text.find('\n');
        const std::string_view line = text.substr(0, end);
        if (line.starts_with(' ')) {
            add_command(line, room, out);
        } else {
            wrap_line(line, room, out);
        }
        if (end == std::string_view::npos) break;
        out += '\n';
        text.remove_prefix(end + 1);
    }
    return out;
}

}  // namespace floes
