#pragma once
// A table for people, and how it is laid out as text and as HTML.

#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace floes {

/// What stands in one place of a table.
struct Cell {
    Cell(std::string text) : value(std::move(text)) {}  // NOLINT: a text is a cell
    Cell(const char* text) : value(text) {}             // NOLINT
    Cell(std::string text, std::string beside) : value(std::move(text)), range(std::move(beside)) {}
    Cell(std::string text, std::string beside, std::string below)
        : value(std::move(text)), range(std::move(beside)), further(std::move(below)) {}

    std::string value;
    std::optional<std::string> range = {};    ///< beside the value; on a page below it
    std::optional<std::string> further = {};  ///< below that; on a page alone
};

/// Rows are equally long, the first one is the heading, and the first cell of each is its label.
using Table = std::vector<std::vector<Cell>>;

/// As text, each column as wide as it needs to be: labels flush left, the others flush right. Columns beyond `width`
/// characters come in tables below, labels repeated. A range is a column of its own where the heading has one, else it
/// follows the value. Letters outside ASCII take one place each.
std::string text_columns(const Table& table, int width);

/// As text, all columns equally wide: values flush right, ranges behind them flush left. As many columns side by side
/// as `width` holds, at least one; the others in panels below, separated by an empty line, with labels and heading
/// repeated.
std::string text_panels(const Table& table, int width);

/// As HTML that scrolls sideways where it must. Ranges stand below their values in small letters.
std::string html_table(const Table& table);

/// Characters on the screen, one for each letter.
std::size_t text_width(std::string_view text);

/// The text with what HTML would take for markup replaced.
std::string html_escaped(std::string_view text);

}  // namespace floes
