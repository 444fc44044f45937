#pragma once
// CSV as lines of cells.

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace floes {

struct CsvLine {
    int number = 0;                  ///< in the text, from 1
    std::vector<std::string> cells;  ///< without quotes and outer blanks
};

/// The lines with anything in them (RFC 4180, also with bare line feeds, and with a byte order mark before), of which
/// the first names columns. A quoted cell ends on its line. Where the first line has semicolons and no comma, cells are
/// divided by these and numbers have decimal commas, as spreadsheets write them in many countries; they are points in
/// the cells given back. Throws InputError for a quote that does not end and for a column that is there twice.
std::vector<CsvLine> csv_lines(std::string_view text, const std::string& file);

/// The number that a cell is from end to end; none where it is something else.
std::optional<double> number_in(std::string_view cell);

/// The cells of a line as written, for a message.
std::string joined(const CsvLine& line);

}  // namespace floes
