#pragma once
// Results as rows under columns, sections of them with sentences and figures, and the writers of text, CSV and JSON.
// Pages are written by who shows them.

#include <algorithm>
#include <concepts>
#include <cstdint>
#include <limits>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include "statistics/distributions.hpp"
#include "tables/figure.hpp"
#include "tables/table.hpp"
#include "tables/units.hpp"

namespace floes {

// What stands in one place of a table: a number, with its interval or without, words, or nothing.

/// No value: left out of JSON, empty in CSV.
struct Absent {};
/// Undefined: null in JSON, empty in CSV, for people `why` in a few words, "–" without; like a number that is not
/// finite.
struct Undefined {
    std::string why = {};
};

/// A value with its 95 % interval; NaN where undefined.
struct Estimate {
    double value = std::numeric_limits<double>::quiet_NaN();
    double low = std::numeric_limits<double>::quiet_NaN();
    double high = std::numeric_limits<double>::quiet_NaN();
    bool said = true;  ///< false: the interval would say nothing, so people see "–"; programs get it all the same

    /// What stands behind "±".
    double longer_side() const { return std::max(high - value, value - low); }
    friend Estimate operator*(double factor, const Estimate& one) {
        return {factor * one.value, factor * one.low, factor * one.high, one.said};
    }
};

/// An interval without a value of its own, such as that of one further run.
struct Bracket {
    Limits limits{};
    bool said = true;
};

/// What programs call something, and what people do: "k17", "thickness 0.02 m". Without a name it is undefined for
/// programs.
struct Named {
    std::string name;
    std::string label;
};

/// One value. true and false are 1 and 0 in CSV.
class Datum {
  public:
    Datum(Absent none);            // NOLINT: implicit, so that any of these is a value
    Datum(Undefined none);         // NOLINT
    Datum(bool value);             // NOLINT
    Datum(double value);           // NOLINT
    Datum(Estimate estimate);      // NOLINT
    Datum(Bracket bracket);        // NOLINT
    Datum(Named named);            // NOLINT
    Datum(std::string text);       // NOLINT
    Datum(std::string_view text);  // NOLINT
    Datum(const char* text);       // NOLINT
    Datum(std::int64_t count);     // NOLINT
    template <std::integral Count>
    Datum(Count count) : Datum(static_cast<std::int64_t>(count)) {}  // NOLINT

    Datum(const Datum& other);
    Datum(Datum&& other) noexcept;
    Datum& operator=(const Datum& other);
    Datum& operator=(Datum&& other) noexcept;
    ~Datum();

    const auto& get() const { return value_; }

  private:
    std::variant<Absent, Undefined, bool, std::int64_t, double, Estimate, Bracket, Named, std::string> value_;
};

/// The value, or Undefined.
Datum if_known(bool known, Datum value);
/// A value with limits that were found apart from it.
Estimate within(double value, const Limits& limits, bool said = true);
/// Values of any kinds, one after another.
template <class... Values>
std::vector<Datum> row_of(Values&&... values) {
    return {Datum(std::forward<Values>(values))...};
}

// Records for programs: the same values as CSV and as JSON, under the names of their columns.

struct DataRows {
    std::string place;                          ///< in JSON: of the list, or of the object; empty: the root
    std::vector<std::string> names;             ///< of the columns; of a list of plain values one, "."
    std::vector<std::vector<Datum>> rows = {};  ///< each as long as names
    bool object = false;                        ///< one record, an object of JSON and no list
    bool in_csv = true;
    bool in_json = true;
};

/// A header line and a line for each record (RFC 4180), numbers with all digits; empty if the records are not for CSV.
std::string csv(const DataRows& records);

/// All of them in one JSON document, names in order; ends in a newline. If two write to one place, the later one wins.
std::string json(std::span<const DataRows> records);

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
    double limit =
        std::numeric_limits<double>::quiet_NaN();  ///< of its values, drawn where they are; NaN: there is none
};

struct Results {
    /// For whom a row is: `folded` rows are closed at first on a page, `on_page` rows are left out of text, and rows
    /// `for_programs` are not shown to people.
    enum class For : std::uint8_t { everybody, folded, on_page, programs, people };
    /// How people see it: rows as rows; rows side by side as columns, as many as fit; rows whose estimates a page draws
    /// too, each column to its own scale; or not at all.
    enum class View : std::uint8_t { rows, side_by_side, drawn, none };

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

    /// A further column, with what `value` makes of each of `all`, of which there are as many as for other columns.
    template <class Row>
    void add_column(ResultColumn about, const std::vector<Row>& all, const auto& value) {
        columns.push_back(std::move(about));
        rows.resize(all.size());
        rows_for.resize(all.size(), For::everybody);
        for (std::size_t k = 0; k < all.size(); ++k) rows[k].emplace_back(value(all[k]));
    }

    bool empty() const { return rows.empty(); }
    /// Whether people see any of its columns.
    bool for_people() const;
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
    Results made{.place = std::move(place), .columns = program_columns(keys)};
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

/// A finding as output.
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
