#pragma once
// Columns of text side by side, as many as a width holds, the others in panels below.

#include <string>
#include <vector>

namespace floes {

/// What a column shows on one line: a value, flush right, and its range behind it, flush left.
struct Cell {
    std::string value;
    std::string range;
};

struct Line {
    std::string label;
    std::vector<Cell> cells;  ///< one a column; equally many on every line
};

/// The lines as text, the first one being the header and repeated on every panel; at least one column a panel, however
/// narrow `width` (characters) is. Panels are separated by an empty line. Letters outside ASCII take one place each.
std::string panels(const std::vector<Line>& lines, int width);

}  // namespace floes
