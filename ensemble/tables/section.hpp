#pragma once
// A finding as output: results, sentences and figures, and the writers of text, CSV and JSON. Pages are written by who
// shows them.

#include <span>
#include <string>
#include <vector>

#include "tables/data_rows.hpp"
#include "tables/figure.hpp"
#include "tables/results.hpp"
#include "tables/table.hpp"

namespace floes {

struct Section {
    std::string title = {};               ///< a line of its own; empty: the section belongs to the one before
    std::string before = {};              ///< between title and tables; where there is none, it says why
    std::vector<Results> results = {};    ///< tables for people and records for programs, in order
    std::string after = {};               ///< below the tables: the meaning of their columns
    std::vector<std::string> notes = {};  ///< below that, sentences, each on a line of its own
    std::string missing = {};  ///< a sentence if the file lacks the data; for CSV and JSON it goes to standard error
    std::vector<Figure> figures = {};  ///< below all this, on a page only
};

/// For people: the sections in order, separated by an empty line. No line is wider than `width` if possible, sentences
/// and tables alike.
std::string text(std::span<const Section> sections, int width, const Units& units = {});

/// The records that are for CSV, each with its own header line, separated by an empty line.
std::string csv(std::span<const Section> sections);

/// All records in one document.
std::string json(std::span<const Section> sections);

/// The records of a section, for a workbook.
std::vector<DataRows> records_of(const Section& section);

}  // namespace floes
