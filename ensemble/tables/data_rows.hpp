#pragma once
// What stands in one place of a table: a number, with its interval or without, words, or nothing.

#include <concepts>
#include <cstdint>
#include <functional>
#include <limits>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include "statistics/distributions.hpp"

namespace floes {

/// No value: left out of JSON, empty in CSV.
struct Absent {};
/// Undefined: null in JSON, empty in CSV, "–" for people; like a number that is not finite.
struct Undefined {};

/// A value with its 95 % interval; NaN where undefined.
struct Estimate {
    double value = std::numeric_limits<double>::quiet_NaN();
    double low = std::numeric_limits<double>::quiet_NaN();
    double high = std::numeric_limits<double>::quiet_NaN();
    bool said = true;  ///< false: the interval would say nothing, so people see "–"; programs get it all the same
};

/// An interval without a value of its own, such as that of one further run.
struct Bracket {
    Limits limits{};
    bool said = true;
};

/// What programs call something, and what people do: "k17", "thickness 0.02 m".
struct Named {
    std::string name;
    std::string label;
};

/// One value. true and false are 1 and 0 in CSV.
class Datum {
  public:
    Datum(Absent none) : value_(none) {}                         // NOLINT: implicit, so that any of these is a value
    Datum(Undefined none) : value_(none) {}                      // NOLINT
    Datum(bool value) : value_(value) {}                         // NOLINT
    Datum(double value) : value_(value) {}                       // NOLINT
    Datum(Estimate estimate) : value_(estimate) {}               // NOLINT
    Datum(Bracket bracket) : value_(bracket) {}                  // NOLINT
    Datum(Named named) : value_(std::move(named)) {}             // NOLINT
    Datum(std::string text) : value_(std::move(text)) {}         // NOLINT
    Datum(std::string_view text) : value_(std::string{text}) {}  // NOLINT
    Datum(const char* text) : value_(std::string{text}) {}       // NOLINT
    template <std::integral Count>
    Datum(Count count) : value_(static_cast<std::int64_t>(count)) {}  // NOLINT

    const auto& get() const { return value_; }

  private:
    std::variant<Absent, Undefined, bool, std::int64_t, double, Estimate, Bracket, Named, std::string> value_;
};

/// The value, or Undefined.
Datum if_known(bool known, Datum value);

// Records for programs: the same values as CSV and as JSON, under the names of their columns.

/// Where a value is written.
struct Names {
    std::string csv;   ///< column; empty: not in CSV
    std::string json;  ///< place in the record's object, "interval/low"; ".": the record itself; empty: not in JSON
};

/// A column of records: its names, and how a row gives its value.
template <class Row>
struct DataColumn {
    /// One name for both.
    DataColumn(std::string name, std::function<Datum(const Row&)> of) : names{name, name}, value(std::move(of)) {}
    DataColumn(Names both, std::function<Datum(const Row&)> of) : names(std::move(both)), value(std::move(of)) {}

    Names names;
    std::function<Datum(const Row&)> value;
};

struct DataRows {
    enum class Shape { list, object };

    std::string place;  ///< in JSON: of the list, or of the object if there is one record; empty: the root
    std::vector<Names> names;
    std::vector<std::vector<Datum>> rows;  ///< each as long as names
    Shape shape = Shape::list;
};

template <class Row>
DataRows make_rows(std::string place, std::span<const Row> rows, const std::vector<DataColumn<Row>>& columns) {
    DataRows records{std::move(place), {}, {}};
    for (const DataColumn<Row>& column : columns) records.names.push_back(column.names);
    for (const Row& row : rows) {
        std::vector<Datum>& values = records.rows.emplace_back();
        values.reserve(columns.size());
        for (const DataColumn<Row>& column : columns) values.push_back(column.value(row));
    }
    return records;
}

/// An object of JSON.
template <class Row>
DataRows make_object(std::string place, const Row& row, const std::vector<DataColumn<Row>>& columns) {
    DataRows records = make_rows(std::move(place), std::span<const Row>(&row, 1), columns);
    records.shape = DataRows::Shape::object;
    return records;
}

/// A list of values in JSON.
template <class Element>
DataRows make_list(std::string place, const std::vector<Element>& values) {
    return make_rows<Element>(std::move(place), values,
                              {{Names{"", "."}, [](const Element& value) { return Datum(value); }}});
}

/// The same records for CSV or JSON only.
DataRows csv_only(DataRows records);
DataRows json_only(DataRows records);

/// A header line and a line for each record (RFC 4180), numbers with all digits; empty if no column is for CSV.
std::string csv(const DataRows& records);

/// All of them in one JSON document, names in order; ends in a newline. If two write to one place, the later one wins.
std::string json(std::span<const DataRows> records);

}  // namespace floes
