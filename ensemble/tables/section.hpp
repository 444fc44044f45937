#pragma once
// A finding as it is told: a table and words for people, records for programs, and the four ways to write it.

#include <span>
#include <string>
#include <vector>

#include "tables/records.hpp"
#include "tables/table.hpp"

namespace floes {

struct Section {
    enum class Layout { columns, panels };

    std::string before = {};  ///< stands above the table: the title, an empty line
    Table table = {};         ///< empty: there is nothing to show, and `before` says why
    std::string after = {};   ///< stands below the table: what its columns mean
    std::vector<Records> records = {};
    Layout layout = Layout::columns;
    std::string missing = {};  ///< a sentence where the file lacks what the finding is made of; programs get it aside
};

/// For people, no line wider than `width` where that can be: the sections in order, an empty line between two.
std::string text(std::span<const Section> sections, int width);

/// The records that are for CSV, each with its own header line, an empty line between two.
std::string csv(std::span<const Section> sections);

/// All records in one document.
std::string json(std::span<const Section> sections);

}  // namespace floes
