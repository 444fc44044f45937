#include <algorithm>

#include "tables/table.hpp"

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

/// One text for each column.
std::vector<std::vector<std::string>> texts_of(const Table& table) {
    std::vector<std::vector<std::string>> rows;
    for (const std::vector<Cell>& cells : table) {
        std::vector<std::string>& row = rows.emplace_back();
        for (std::size_t k = 0; k < cells.size(); ++k) {
            const Cell& cell = cells[k];
            row.push_back(cell.value);
            if (table.front()[k].range)
                row.push_back(cell.range.value_or(""));
            else if (cell.range)
                row.back() += " " + *cell.range;
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

}  // namespace floes
