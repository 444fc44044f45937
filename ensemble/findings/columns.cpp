#include "findings/columns.hpp"

#include <algorithm>

namespace floes {

namespace {

constexpr std::size_t gap = 2;

std::string spaces(std::size_t width, const std::string& beside) {
    return std::string(width - std::min(width, places(beside)), ' ');
}

}  // namespace

std::size_t places(const std::string& text) {
    return static_cast<std::size_t>(std::ranges::count_if(text, [](char byte) { return (byte & 0xC0) != 0x80; }));
}

std::string columns(const std::vector<std::vector<std::string>>& rows, int width) {
    std::vector<std::size_t> widths(rows.front().size(), 0);
    for (const auto& row : rows) {
        for (std::size_t i = 0; i < row.size(); ++i) widths[i] = std::max(widths[i], places(row[i]));
    }
    std::string text;
    for (std::size_t first = 1; first < widths.size();) {
        std::size_t taken = widths[0];
        std::size_t last = first;
        while (last < widths.size() &&
               (last == first || taken + gap + widths[last] <= static_cast<std::size_t>(std::max(width, 0)))) {
            taken += gap + widths[last++];
        }
        if (first > 1) text += "\n";
        for (std::size_t r = 0; r < rows.size(); ++r) {
            std::string line = rows[r][0] + spaces(widths[0], rows[r][0]);
            for (std::size_t i = first; i < last; ++i) {
                line += std::string(gap, ' ') + spaces(widths[i], rows[r][i]) + rows[r][i];
            }
            text += line.substr(0, line.find_last_not_of(' ') + 1) + "\n";
            if (r == 0) text += std::string(taken, '-') + "\n";
        }
        first = last;
    }
    return text;
}

}  // namespace floes
