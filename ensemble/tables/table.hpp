#pragma once
// A table for people and its layout as text and as HTML.

#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace floes {

/// One cell of a table.
struct Cell {
    Cell(std::string text) : value(std::move(text)) {}  // NOLINT: a text is a cell
    Cell(const char* text) : value(text) {}             // NOLINT
    Cell(std::string text, std::string beside) : value(std::move(text)), range(std::move(beside)) {}

    std::string value;
    std::optional<std::string> range = {};  ///< after the value; on a page below it
};

/// Rows have equal length. The first row is the heading, and the first cell of each row is its label.
using Table = std::vector<std::vector<Cell>>;

/// As text, each column as wide as needed: labels flush left, the others flush right. Columns that exceed `width`
/// characters go to further tables below, with labels repeated. A range follows its value. Letters outside ASCII count
/// as one character.
std::string text_columns(const Table& table, int width);

/// As text, all columns equally wide: values flush right, then ranges flush left. As many columns side by side as fit
/// into `width`, at least one; the others in panels below, separated by an empty line, with labels and heading
/// repeated.
std::string text_panels(const Table& table, int width);

/// As HTML that scrolls sideways if necessary. Ranges are in small print below their values.
std::string html_table(const Table& table);

/// Width on the screen in characters.
std::size_t text_width(std::string_view text);

/// The text with lines of at most `width` characters, broken at spaces; not wider than people like to read. Lines that
/// begin with a space are commands to copy, and stand as they are; what two spaces part from such a command goes to a
/// line of its own where there is no room for it.
std::string wrapped(std::string_view text, int width);

}  // namespace floes
