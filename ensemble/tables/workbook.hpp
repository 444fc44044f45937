#pragma once
// Records as a workbook of Excel and LibreOffice (.xlsx): a sheet for each list. The door to libxlsxwriter.

#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "tables/data_rows.hpp"

namespace floes {

struct Sheet {
    std::string name;  ///< at most 31 characters, none of []:*?/\ among them
    DataRows records;  ///< the columns that are for CSV
};

/// Writes the sheets that have columns, each with a fixed header line that filters. Numbers are numbers, and what is
/// undefined is an empty cell. Throws RunError where the file cannot be written, and InputError where a list is longer
/// than a sheet.
void write_workbook(const std::filesystem::path& path, std::span<const Sheet> sheets);

}  // namespace floes
