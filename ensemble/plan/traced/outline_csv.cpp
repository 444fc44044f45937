#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <set>
#include <sstream>
#include <string_view>

#include "core/error.hpp"
#include "core/utf8.hpp"
#include "traced/traced_file.hpp"

namespace floes {
namespace {

std::string_view trimmed(std::string_view text) {
    constexpr std::string_view blank = " \t\r";
    const std::size_t first = text.find_first_not_of(blank);
    if (first == std::string_view::npos) return {};
    return text.substr(first, text.find_last_not_of(blank) + 1 - first);
}

std::vector<std::string_view> cells_of(std::string_view line) {
    std::vector<std::string_view> cells;
    for (std::size_t from = 0;;) {
        const std::size_t comma = line.find(',', from);
        cells.push_back(trimmed(line.substr(from, comma - from)));
        if (comma == std::string_view::npos) return cells;
        from = comma + 1;
    }
}

double number_of(std::string_view cell, const std::string& where) {
    double number = 0;
    const auto [end, error] = std::from_chars(cell.data(), cell.data() + cell.size(), number);
    if (error != std::errc() || end != cell.data() + cell.size() || !std::isfinite(number))
        throw InputError(fmt::format("{}: {:?} is not a finite number", where, beginning(cell, 40)));
    return number;
}

}  // namespace

std::vector<TracedFloe> read_outline_csv(const std::string& text, const std::string& file) {
    if (!is_utf8(text)) throw InputError(fmt::format("{}: this is no text in UTF-8; save it as such", file));
    std::vector<TracedFloe> floes;
    std::set<std::string> names;
    std::istringstream lines(text.substr(text.starts_with("\xEF\xBB\xBF") ? 3 : 0));
    bool header = false;
    std::size_t corners = 0;
    int number = 0;
    for (std::string line; std::getline(lines, line);) {
        ++number;
        if (trimmed(line).empty()) continue;
        const std::string where = fmt::format("{}:{}", file, number);
        const std::vector<std::string_view> cells = cells_of(line);
        if (!header) {
            if (cells != std::vector<std::string_view>{"floe", "x", "y"})
                throw InputError(
                    fmt::format("{}: {:?} is not the header of a file of outlines; write floe,x,y and "
                                "below it a line for each corner",
                                where, beginning(trimmed(line), 60)));
            header = true;
            continue;
        }
        if (cells.size() != 3 || cells[0].empty())
            throw InputError(fmt::format("{}: {:?} is not a corner; write the floe's name, x and y", where,
                                         beginning(trimmed(line), 60)));
        const Corner corner{number_of(cells[1], where), 0.0 - number_of(cells[2], where)};
        if (floes.empty() || floes.back().name != cells[0]) {
            const std::string name(cells[0]);
            if (!names.insert(name).second)
                throw InputError(
                    fmt::format("{}: floe {} comes again after another one; keep the corners of a floe "
                                "together, and give each floe a name of its own",
                                where, name));
            if (floes.size() == most_outlines)
                throw InputError(
                    fmt::format("{}: the file has more than {} outlines; take a part of it", where, most_outlines));
            floes.push_back({name, where, {}, {}});
        }
        if (++corners > most_file_corners)
            throw InputError(
                fmt::format("{}: the file has more than {} corners; simplify its outlines", where, most_file_corners));
        floes.back().ring.push_back(corner);
    }
    if (!header)
        throw InputError(fmt::format("{}: the file is empty; write floe,x,y and a line for each corner", file));
    return floes;
}

}  // namespace floes
