#pragma once
// A finding as output: a table and notes for people, records for programs, and the writers of both.

#include <span>
#include <string>
#include <vector>

#include "tables/data_rows.hpp"
#include "tables/table.hpp"

namespace floes {

struct Section {
    enum class Layout { columns, panels };

    std::string before = {};  ///< above the table: the title, an empty line
    Table table = {};         ///< empty if there is nothing to show; `before` then says why
    std::string after = {};   ///< below the table: the meaning of its columns
    std::vector<DataRows> records = {};
    Layout layout = Layout::columns;
    std::string missing = {};  ///< a sentence if the file lacks the data; for CSV and JSON it goes to standard error
};

/// For people: the sections in order, separated by an empty line. No line is wider than `width` if possible.
std::string text(std::span<const Section> sections, int width);

/// The records that are for CSV, each with its own header line, separated by an empty line.
std::string csv(std::span<const Section> sections);

/// All records in one document.
std::string json(std::span<const Section> sections);

}  // namespace floes
