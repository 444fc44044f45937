#pragma once
// Results: rows of values under columns, each column said once. What people read as text, on a page or in a workbook,
// and what programs read as CSV and JSON follow from it:
//
//     Results results{.place = "fatigue/cases",
//                     .columns = {{"case", "case"},
//                                 {"runs", "runs"},
//                                 {.key = "cycles", .words = "cycles per hour", .unit = "h-1", .decimals = 0},
//                                 {.key = "equivalent_range", .words = "equivalent range", .unit = "N"}}};
//     results.add({"stiff", 12, 340.0, Estimate{21.2, 18.4, 24.0}});
//
// A value and its interval are one cell for people, and the columns KEY, KEY_low and KEY_high for programs.

#include <cstdint>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "tables/data_rows.hpp"
#include "tables/table.hpp"
#include "tables/units.hpp"

namespace floes {

struct ResultColumn {
    /// What the values are; programs need to know it before they see one.
    enum class Holds { values, estimates, brackets };
    /// How people see an estimate: "17.3 [16.4, 18.2]", "17.3 ± 0.9" or, of a difference, "+5.0 ± 1.1".
    enum class Form { bracket, plus_minus, difference };

    std::string key = {};    ///< in CSV, JSON and workbooks; empty: for people alone
    std::string words = {};  ///< its heading for people, without the unit; empty: for programs alone
    std::string unit = "1";  ///< SI, as Units takes it; empty: that of the heading above the row
    Holds holds = Holds::values;
    Form form = Form::bracket;
    int decimals = -1;  ///< shown; -1: those that give the largest value of the column about four digits, three with ±
    int digits = 0;     ///< shown in each cell on its own, significant ones; 0: by `decimals`
    bool p = false;     ///< a probability of a test: "0.034", "<0.001"
};

struct Results {
    /// For whom a row is: `folded` rows are closed at first on a page, `on_page` rows are left out of text, and rows
    /// `for_programs` are not shown to people.
    enum class For : std::uint8_t { everybody, folded, on_page, programs, people };
    /// How people see it: rows as rows; rows side by side as columns, as many as fit; or not at all.
    enum class View : std::uint8_t { rows, side_by_side, none };

    std::string place = {};  ///< in JSON: of the list, "design/loads", or of the object; empty: the root
    std::vector<ResultColumn> columns = {};
    View view = View::rows;
    bool object = false;                        ///< one row, an object of JSON and no list
    bool in_csv = true;                         ///< false: in JSON and on the screen only
    bool in_json = true;                        ///< false: in CSV and on the screen only
    std::vector<std::vector<Datum>> rows = {};  ///< each as long as the columns
    std::vector<For> rows_for = {};

    /// As many values as columns.
    void add(std::vector<Datum> row, For whom = For::everybody);
    /// A line of words above the rows that follow, for people. `unit`: of their values in columns that have none.
    void add_heading(std::string words, For whom = For::everybody, std::string unit = {});

    bool empty() const { return rows.empty(); }
    /// What stands in a row under a key. Throws RunError where there is no such column.
    const Datum& at(std::size_t row, std::string_view key) const;
    /// The same as a number: the value of an estimate; NaN of what is none.
    double number(std::size_t row, std::string_view key) const;
    /// The same as programs call it; empty of what is no words.
    std::string name(std::size_t row, std::string_view key) const;
};

/// An object of JSON, for programs alone.
Results object(std::string place, std::vector<std::pair<std::string, Datum>> values);

/// Columns for programs alone: "base axis from to".
std::vector<ResultColumn> program_columns(std::string_view keys);
/// A list for programs alone, with what `values` makes of each row: a Datum for each key.
template <class Row>
Results list(std::string place, std::string_view keys, const std::vector<Row>& rows, auto values) {
    Results made{.place = std::move(place), .columns = program_columns(keys), .view = Results::View::none};
    for (const Row& row : rows) made.add(values(row));
    return made;
}

/// One list after another: of columns, and of the values under them.
std::vector<ResultColumn> operator+(std::vector<ResultColumn> first, const std::vector<ResultColumn>& second);
std::vector<Datum> operator+(std::vector<Datum> first, const std::vector<Datum>& second);

/// The columns and rows that people see in text and first on a page.
Table shown_table(const Results& results, const Units& units, Results::For whom = Results::For::everybody);

/// The columns and rows for programs: an estimate is three columns, a bracket two.
DataRows data_rows(const Results& results);

/// One quantity over two others: a line for each value of `down` and a cell for each of `across`, in the order of the
/// rows, for people alone; `cells`: keys of the columns that are put beside each other in a cell's place.
Results pivot(const Results& results, std::string_view down, std::string_view across,
              const std::vector<std::string>& cells);

/// What one cell shows: a number in the unit of its column with so many decimals.
Cell shown_cell(const Datum& value, const ResultColumn& column, int decimals, const Units& units);

}  // namespace floes
