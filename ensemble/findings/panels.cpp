#include "findings/panels.hpp"

#include <algorithm>

#include "findings/columns.hpp"

namespace floes {

namespace {

constexpr std::size_t gap = 3;  // characters before a column

std::string spaces(std::size_t width, const std::string& beside) {
    return std::string(width - std::min(width, places(beside)), ' ');
}

struct Widths {
    std::size_t label = 0;
    std::size_t value = 0;
    std::size_t range = 0;

    explicit Widths(const std::vector<Line>& lines) {
        for (const Line& line : lines) {
            label = std::max(label, places(line.label));
            for (const Cell& cell : line.cells) {
                value = std::max(value, places(cell.value));
                range = std::max(range, places(cell.range));
            }
        }
    }
    std::size_t column() const { return gap + value + 1 + range; }
};

std::string row(const Line& line, const Widths& widths, std::size_t first, std::size_t last) {
    std::string text = line.label + spaces(widths.label, line.label);
    for (std::size_t index = first; index < last; ++index) {
        const Cell& cell = line.cells[index];
        text += std::string(gap, ' ') + spaces(widths.value, cell.value) + cell.value + ' ' + cell.range +
                spaces(widths.range, cell.range);
    }
    return text.substr(0, text.find_last_not_of(' ') + 1) + "\n";
}

}  // namespace

std::string panels(const std::vector<Line>& lines, int width) {
    const Widths widths{lines};
    const std::size_t columns = lines.front().cells.size();
    const std::size_t room = static_cast<std::size_t>(std::max(width, 0));
    const std::size_t abreast = std::max<std::size_t>(1, (room - std::min(room, widths.label)) / widths.column());
    std::string text;
    for (std::size_t first = 0; first < columns; first += abreast) {
        const std::size_t last = std::min(columns, first + abreast);
        if (first > 0) text += "\n";
        text += row(lines.front(), widths, first, last);
        text += std::string(widths.label + (last - first) * widths.column(), '-') + "\n";
        for (std::size_t index = 1; index < lines.size(); ++index) text += row(lines[index], widths, first, last);
    }
    return text;
}

}  // namespace floes
