#pragma once
// Texts of other programs as lines, and CSV as lines of cells.

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace floes {

/// Without line ends (LF, CR LF or CR) and without a byte order mark before the first.
std::vector<std::string_view> lines_of(std::string_view text);

struct CsvLine {
    int number = 0;                  ///< in the text, from 1
    std::vector<std::string> cells;  ///< without quotes and outer blanks
};

/// The lines with anything in them, of which the first names columns: CSV after RFC 4180 as programs write it, in UTF-8
/// with or without a byte order mark, lines ended by line feeds, carriage returns or both. A quoted cell ends on its
/// line. Cells are divided by what a first line "sep=;" names; else by commas, or by semicolons or tabs where the
/// header has no comma. With semicolons numbers have decimal commas, as spreadsheets write them in many countries; they
/// are points in the cells given back. Empty cells behind the last column are none. Throws InputError, beginning with
/// `file`, for other encodings, a quote that does not end, a decimal comma beside tabs, and a column that has no name
/// or is there twice.
std::vector<CsvLine> csv_lines(std::string_view text, const std::string& file);

/// The finite number that a cell is from end to end, also as +10, 10. or 1e1; none where it is something else.
std::optional<double> number_in(std::string_view cell);

/// The cells of a line as written, for a message.
std::string joined(const CsvLine& line);

}  // namespace floes
