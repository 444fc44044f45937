#pragma once
// Records as a workbook of Excel and LibreOffice (.xlsx): a sheet for each list. The door to libxlsxwriter.

#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "tables/section.hpp"
#include "tables/units.hpp"

namespace floes {

struct Sheet {
    std::string name;  ///< at most 31 characters, none of []:*?/\ among them
    DataRows records;  ///< the columns that are for CSV
};

/// The first sheet, for people: sentences, and a table in the units of the campaign with formatted numbers, each
/// estimate beside the half of its interval, and a chart of the estimates that share the unit of the first.
struct FrontSheet {
    std::string name;
    std::vector<std::string> above;
    Results table;
    std::vector<std::string> below;
};

/// Writes the front, where there is one, then the sheets that have columns, each with a fixed header line that filters.
/// Numbers are numbers, and what is undefined is an empty cell. Throws RunError where the file cannot be written, and
/// InputError where a list is longer than a sheet.
void write_workbook(const std::filesystem::path& path, std::span<const Sheet> sheets, const Units& units = {},
                    const FrontSheet* front = nullptr);

}  // namespace floes
