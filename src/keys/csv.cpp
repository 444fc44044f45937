#include "keys/csv.hpp"

#include <charconv>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "core/error.hpp"

namespace floes {

namespace {

std::string_view without_blanks(std::string_view text) {
    const std::size_t first = text.find_first_not_of(" \t\r");
    if (first == std::string_view::npos) return {};
    return text.substr(first, text.find_last_not_of(" \t\r") - first + 1);
}

/// The cell that the line begins with; takes it and its comma off the line. `more`: whether a comma followed.
std::string take_cell(std::string_view& line, const std::string& where, bool& more) {
    line = without_blanks(line);
    std::string cell;
    if (!line.starts_with('"')) {
        const std::size_t comma = line.find(',');
        cell = without_blanks(line.substr(0, comma));
        more = comma != std::string_view::npos;
        line.remove_prefix(more ? comma + 1 : line.size());
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
    more = line.starts_with(',');
    if (!more && !line.empty())
        throw InputError(fmt::format("{}: a comma is missing after the quoted cell \"{}\"", where, cell));
    line.remove_prefix(more ? 1 : 0);
    return cell;
}

}  // namespace

std::vector<CsvLine> csv_lines(std::string_view text, const std::string& file) {
    constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF";
    if (text.starts_with(byte_order_mark)) text.remove_prefix(byte_order_mark.size());
    std::vector<CsvLine> lines;
    for (int number = 1; !text.empty(); ++number) {
        const std::size_t end = text.find('\n');
        std::string_view line = text.substr(0, end);
        text.remove_prefix(end == std::string_view::npos ? text.size() : end + 1);
        if (without_blanks(line).empty()) continue;
        CsvLine& made = lines.emplace_back(CsvLine{number, {}});
        for (bool more = true; more;) made.cells.push_back(take_cell(line, fmt::format("{}:{}", file, number), more));
    }
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
