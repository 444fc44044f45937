#pragma once
// What stands in one place of a table: a number, with its interval or without, words, or nothing.

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

}  // namespace floes
