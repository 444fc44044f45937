#pragma once
// CSV as lines of cells. For this room only.

#include <string>
#include <string_view>
#include <vector>

#include "keys/document.hpp"

namespace floes {

struct CsvLine {
    int number = 0;                  ///< in the text, from 1
    std::vector<std::string> cells;  ///< without quotes and outer blanks
};

/// The lines with anything in them (RFC 4180, also with bare line feeds, and with a byte order mark before). A quoted
/// cell ends on its line. Throws InputError for a quote that does not end.
std::vector<CsvLine> csv_lines(std::string_view text, const std::string& file);

/// A cell as a number if it is one, else as text.
Value number_or_words(const std::string& cell);

}  // namespace floes
