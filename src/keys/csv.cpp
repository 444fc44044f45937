#include "keys/csv.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "core/error.hpp"
#include "core/text.hpp"
#include "keys/meant.hpp"

namespace floes {

namespace {

/// Without outer blanks; a tab may be what divides cells, and is none then.
std::string_view without_blanks(std::string_view text, char divider = ',') {
    return trimmed(text, divider == '\t' ? " " : " \t");
}

/// "sep=;", which spreadsheets write and read as the first line; nothing for any other line.
std::optional<char> named_divider(std::string_view line) {
    if (line.size() != 5) return {};
    const bool named = (line.starts_with("sep=") || line.starts_with("SEP=")) && line[4] != '"';
    return named ? std::optional(line[4]) : std::nullopt;
}

/// What divides the cells of a header: a semicolon or a tab where it has no comma.
char divider_of(std::string_view header) {
    bool quoted = false;
    char divider = ',';
    for (const char c : header) {
        if (c == '"') quoted = !quoted;
        if (quoted) continue;
        if (c == ',') return ',';
        if (c == ';' || (c == '\t' && divider == ',')) divider = c;
    }
    return divider;
}

std::string_view name_of(char divider) {
    return divider == ',' ? "comma" : divider == ';' ? "semicolon" : divider == '\t' ? "tab" : "divider";
}

/// The cells of one line.
class CellReader {
  public:
    CellReader(std::string_view line, char divider, std::string where)
        : line_(line), divider_(divider), where_(std::move(where)) {}

    std::vector<std::string> read() {
        std::vector<std::string> cells;
        for (bool more = true; more;) {
            line_ = without_blanks(line_, divider_);
            cells.push_back(line_.starts_with('"') ? take_quoted(more) : take_plain(more));
        }
        return cells;
    }

  private:
    /// Takes the cell and its divider off the line. `more`: whether a divider followed.
    std::string take_plain(bool& more) {
        const std::size_t end = line_.find(divider_);
        std::string cell(without_blanks(line_.substr(0, end), divider_));
        more = end != std::string_view::npos;
        line_.remove_prefix(more ? end + 1 : line_.size());
        if (divider_ == ',') return cell;
        std::string pointed = with_decimal_point(cell);
        if (pointed.empty()) return cell;
        // With semicolons a comma is the decimal sign; with tabs it may as well divide thousands.
        if (divider_ != ';') throw InputError("{}: {} has a comma; write {}, with a point", where_, cell, pointed);
        return pointed;
    }

    std::string take_quoted(bool& more) {
        std::string cell;
        std::size_t at = 1;
        while (true) {
            const std::size_t quote = line_.find('"', at);
            if (quote == std::string_view::npos)
                throw InputError("{}: a quoted cell does not end on its line; close it with \"", where_);
            cell += line_.substr(at, quote - at);
            at = quote + 1;
            if (!line_.substr(at).starts_with('"')) break;
            cell += '"';
            ++at;
        }
        line_ = without_blanks(line_.substr(at), divider_);
        more = line_.starts_with(divider_);
        if (!more && !line_.empty())
            throw InputError("{}: a {} is missing after the quoted cell \"{}\"", where_, name_of(divider_), cell);
        line_.remove_prefix(more ? 1 : 0);
        if (divider_ != ';') return cell;
        std::string pointed = with_decimal_point(cell);
        return pointed.empty() ? cell : pointed;
    }

    std::string_view line_;
    char divider_;
    std::string where_;
};

/// A column that two have is read once and lost once, and one that nobody named is whatever a program wrote there.
void refuse_columns(const CsvLine& header, const std::string& file) {
    for (std::size_t k = 0; k < header.cells.size(); ++k) {
        const std::string& name = header.cells[k];
        if (number_in(name)) continue;  // no header
        if (name.empty())
            throw InputError("{}:{}: column {} has no name; name it, or leave it out, as pandas does with index=False",
                             file, header.number, k + 1);
        const auto before = header.cells.begin() + static_cast<std::ptrdiff_t>(k);
        if (std::find(header.cells.begin(), before, name) != before)
            throw InputError("{}:{}: the column {} is there twice; leave one of the two out", file, header.number,
                             name);
    }
}

/// Takes off empty cells behind the columns, as spreadsheets write them.
void drop_empty_ends(std::vector<CsvLine>& lines) {
    std::vector<std::string>& header = lines.front().cells;
    while (header.back().empty()) header.pop_back();
    for (CsvLine& line : lines)
        while (line.cells.size() > header.size() && line.cells.back().empty()) line.cells.pop_back();
}

}  // namespace

std::vector<std::string_view> lines_of(std::string_view text) {
    constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF";
    if (text.starts_with(byte_order_mark)) text.remove_prefix(byte_order_mark.size());
    std::vector<std::string_view> lines;
    while (!text.empty()) {
        const std::size_t end = std::min(text.find_first_of("\r\n"), text.size());
        lines.push_back(text.substr(0, end));
        text.remove_prefix(end);
        text.remove_prefix(text.starts_with("\r\n") ? 2 : std::min<std::size_t>(1, text.size()));
    }
    return lines;
}

std::vector<CsvLine> csv_lines(std::string_view text, const std::string& file) {
    if (is_utf16(text)) throw InputError("{}: this is text in UTF-16; save it in UTF-8", file);
    if (!is_utf8(text)) throw InputError("{}: this is no text in UTF-8; save it as such", file);
    std::optional<char> divider;
    std::vector<CsvLine> lines;
    int number = 0;
    for (const std::string_view line : lines_of(text)) {
        ++number;
        if (without_blanks(line).empty()) continue;
        if (!divider) {
            divider = named_divider(line);
            if (divider) continue;
            divider = divider_of(line);
        }
        CsvLine made{number, CellReader(line, *divider, fmt::format("{}:{}", file, number)).read()};
        if (std::ranges::all_of(made.cells, &std::string::empty)) continue;
        lines.push_back(std::move(made));
    }
    if (lines.empty()) return lines;
    drop_empty_ends(lines);
    refuse_columns(lines.front(), file);
    return lines;
}

std::optional<double> number_in(std::string_view cell) {
    if (cell.starts_with('+') && !cell.starts_with("+-")) cell.remove_prefix(1);
    double number = 0;
    const char* const end = cell.data() + cell.size();
    const auto [stop, fault] = std::from_chars(cell.data(), end, number);
    const bool whole = fault == std::errc{} && stop == end && std::isfinite(number);
    return whole ? std::optional(number) : std::nullopt;
}

std::string joined(const CsvLine& line) {
    return fmt::format("{}", fmt::join(line.cells, ","));
}

}  // namespace floes
