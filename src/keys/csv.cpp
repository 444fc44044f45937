#include "keys/csv.hpp"

#include <algorithm>
#include <charconv>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "core/error.hpp"
#include "keys/meant.hpp"

namespace floes {

namespace {

std::string_view without_blanks(std::string_view text) {
    const std::size_t first = text.find_first_not_of(" \t\r");
    if (first == std::string_view::npos) return {};
    return text.substr(first, text.find_last_not_of(" \t\r") - first + 1);
}

/// The cell that the line begins with; takes it and its `comma` off the line. `more`: whether a comma followed.
std::string take_cell(std::string_view& line, const std::string& where, char comma, bool& more) {
    line = without_blanks(line);
    std::string cell;
    if (!line.starts_with('"')) {
        const std::size_t end = line.find(comma);
        cell = without_blanks(line.substr(0, end));
        more = end != std::string_view::npos;
        line.remove_prefix(more ? end + 1 : line.size());
        return cell;
    }
    std::size_t at = 1;
    while (true) {
        const std::size_t quote = line.find('"', at);
        if (quote == std::string_view::npos)
            throw InputError(fmt::format("{}: a quoted cell does not end on its line; close it with \"", where));
        cell += line.substr(at, quote - at);
        at = quote + 1;
        if (!line.substr(at).starts_with('"')) break;
        cell += '"';
        ++at;
    }
    line = without_blanks(line.substr(at));
    more = line.starts_with(comma);
    if (!more && !line.empty())
        throw InputError(fmt::format("{}: a {} is missing after the quoted cell \"{}\"", where,
                                     comma == ',' ? "comma" : "semicolon", cell));
    line.remove_prefix(more ? 1 : 0);
    return cell;
}

/// 0,5 becomes 0.5; what is no such number stays.
void take_decimal_comma(std::string& cell) {
    if (std::string pointed = with_decimal_point(cell); !pointed.empty()) cell = std::move(pointed);
}

/// One of the two would be read and the other lost.
void refuse_doubled_columns(const CsvLine& header, const std::string& file) {
    for (std::size_t k = 0; k < header.cells.size(); ++k) {
        const std::string& name = header.cells[k];
        if (name.empty() || number_in(name)) continue;  // no header
        const auto before = header.cells.begin() + static_cast<std::ptrdiff_t>(k);
        if (std::find(header.cells.begin(), before, name) != before)
            throw InputError(fmt::format("{}:{}: the column {} is there twice; leave one of the two out", file,
                                         header.number, name));
    }
}

}  // namespace

std::vector<CsvLine> csv_lines(std::string_view text, const std::string& file) {
    constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF";
    if (text.starts_with(byte_order_mark)) text.remove_prefix(byte_order_mark.size());
    const std::string_view first = text.substr(0, text.find('\n', text.find_first_not_of(" \t\r\n")));
    const char comma =
        first.find(';') != std::string_view::npos && first.find(',') == std::string_view::npos ? ';' : ',';
    std::vector<CsvLine> lines;
    for (int number = 1; !text.empty(); ++number) {
        const std::size_t end = text.find('\n');
        std::string_view line = text.substr(0, end);
        text.remove_prefix(end == std::string_view::npos ? text.size() : end + 1);
        if (without_blanks(line).empty()) continue;
        CsvLine& made = lines.emplace_back(CsvLine{number, {}});
        for (bool more = true; more;)
            made.cells.push_back(take_cell(line, fmt::format("{}:{}", file, number), comma, more));
        if (comma == ';') std::ranges::for_each(made.cells, take_decimal_comma);
    }
    if (!lines.empty()) refuse_doubled_columns(lines.front(), file);
    return lines;
}

std::optional<double> number_in(std::string_view cell) {
    double number = 0;
    const char* const end = cell.data() + cell.size();
    const auto [stop, fault] = std::from_chars(cell.data(), end, number);
    return fault == std::errc{} && stop == end ? std::optional(number) : std::nullopt;
}

std::string joined(const CsvLine& line) {
    return fmt::format("{}", fmt::join(line.cells, ","));
}

}  // namespace floes
