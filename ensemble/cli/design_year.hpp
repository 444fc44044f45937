#pragma once
// floes design --regimes: the loads of a year.

#include <string>
#include <vector>

#include "findings/design_load.hpp"

namespace floes {

struct YearOptions {
    std::string file;     ///< the campaign file
    std::string regimes;  ///< TOML, or CSV by its name
    DesignLoadRequest load;
    std::vector<double> per_year{1e-2, 1e-4};
    std::string format = "table";
    std::string output;  ///< .html, .svg or .xlsx by its name; empty: none
    bool automatic_window = false;
    bool next = false;
    std::string program;
};

/// Prints the answer and writes the output. Throws InputError as find_year() and read_regimes() do.
void tell_year(const YearOptions& options);

}  // namespace floes
