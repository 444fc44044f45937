#include "tables/section.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <ranges>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <nlohmann/json.hpp>

#include "core/contract.hpp"
#include "core/error.hpp"

namespace floes {

namespace {

struct Field {
    std::string operator()(const auto&) const { return ""; }  // none, or an estimate, which has columns of its own
    std::string operator()(bool value) const { return value ? "1" : "0"; }
    std::string operator()(std::int64_t value) const { return fmt::format("{}", value); }
    std::string operator()(double value) const { return std::isfinite(value) ? fmt::format("{}", value) : ""; }
    std::string operator()(const Named& one) const { return (*this)(one.name); }
    /// Quoted if a comma, a quote or a line end would be misread.
    std::string operator()(const std::string& text) const {
        if (text.find_first_of(",\"\r\n") == std::string::npos) return text;
        std::string quoted;
        for (const char letter : text) quoted.append(letter == '"' ? 2 : 1, letter);
        return fmt::format("\"{}\"", quoted);
    }
};

}  // namespace

Datum::Datum(Absent none) : value_(none) {}
Datum::Datum(Undefined none) : value_(none) {}
Datum::Datum(bool value) : value_(value) {}
Datum::Datum(double value) : value_(value) {}
Datum::Datum(Estimate estimate) : value_(estimate) {}
Datum::Datum(Bracket bracket) : value_(bracket) {}
Datum::Datum(Named named) : value_(std::move(named)) {}
Datum::Datum(std::string text) : value_(std::move(text)) {}
Datum::Datum(std::string_view text) : value_(std::string{text}) {}
Datum::Datum(const char* text) : value_(std::string{text}) {}
Datum::Datum(std::int64_t count) : value_(count) {}
Datum::Datum(const Datum& other) = default;
Datum::Datum(Datum&& other) noexcept = default;
Datum& Datum::operator=(const Datum& other) = default;
Datum& Datum::operator=(Datum&& other) noexcept = default;
Datum::~Datum() = default;

Datum if_known(bool known, Datum value) {
    if (!known) return Undefined{};
    return value;
}

Estimate within(double value, const Limits& limits, bool said) {
    return {value, limits.low, limits.high, said};
}

std::string csv(const DataRows& records) {
    std::string text;
    if (!records.in_csv) return text;
    for (const std::string& name : records.names) text += Field{}(name) + ",";
    text.back() = '\n';  // in place of the last comma
    for (const std::vector<Datum>& row : records.rows) {
        for (const Datum& value : row) text += std::visit(Field{}, value.get()) + ",";
        text.back() = '\n';
    }
    return text;
}

namespace {

using Json = nlohmann::ordered_json;  // keeps the order of names

struct ToJson {
    Json operator()(const auto&) const { return nullptr; }
    Json operator()(bool value) const { return value; }
    Json operator()(std::int64_t value) const { return value; }
    Json operator()(double value) const { return std::isfinite(value) ? Json(value) : Json(nullptr); }
    Json operator()(const Named& one) const { return one.name; }
    Json operator()(const std::string& text) const { return text; }
};

/// The element "a/0/b" of `parent`, created if absent.
Json& at(Json& parent, const std::string& place) {
    return place.empty() || place == "." ? parent : parent[Json::json_pointer("/" + place)];
}

void put(Json& record, const std::vector<std::string>& names, const std::vector<Datum>& row) {
    for (std::size_t k = 0; k < names.size(); ++k)
        if (!std::holds_alternative<Absent>(row[k].get())) at(record, names[k]) = std::visit(ToJson{}, row[k].get());
}

void add(Json& document, const DataRows& records) {
    if (!records.in_json) return;
    Json& place = at(document, records.place);
    if (records.object) {
        put(place, records.names, records.rows.front());
        return;
    }
    if (place.is_null()) place = Json::array();
    for (std::size_t k = 0; k < records.rows.size(); ++k) put(place[k], records.names, records.rows[k]);
}

}  // namespace

std::string json(std::span<const DataRows> records) {
    Json document = Json::object();
    for (const DataRows& one : records) add(document, one);
    return document.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

namespace {

/// Decimals that give a quantity as large as `largest` about four digits.
int decimals_for(double largest) {
    return largest >= 1000 ? 0 : largest >= 100 ? 1 : largest >= 1 ? 2 : 4;
}

/// About three digits.
int few_decimals(double largest) {
    return largest >= 100 ? 0 : largest >= 1 ? 1 : largest >= 0.1 ? 2 : largest > 0 ? 3 : 1;
}

/// The magnitude that decides decimals; 0 of what is no number.
struct Magnitude {
    double operator()(double value) const { return std::isfinite(value) ? std::abs(value) : 0; }
    /// For a difference near 0 the width of its interval.
    double operator()(const Estimate& one) const {
        return std::max((*this)(one.value), one.said ? (*this)(0.5 * (one.high - one.low)) : 0);
    }
    double operator()(const Bracket& one) const { return std::max((*this)(one.limits.low), (*this)(one.limits.high)); }
    double operator()(const auto&) const { return 0; }
};

bool is_heading(const Results& results, std::size_t row) {
    return results.rows[row].size() == 1 && results.columns.size() > 1;
}

/// For a column in the rows [first, end).
int decimals_of(const Results& results, std::size_t column, const std::string& unit, const Units& units,
                std::size_t first, std::size_t end) {
    if (const int fixed = results.columns[column].decimals; fixed >= 0) return fixed;
    if (unit == "share") return 1;
    double largest = 0;
    for (std::size_t r = first; r < end; ++r)
        if (!is_heading(results, r))
            largest = std::max(largest, std::visit(Magnitude{}, results.rows[r][column].get()));
    largest *= units.of(unit).factor;
    return results.columns[column].form == ResultColumn::Form::bracket ? decimals_for(largest) : few_decimals(largest);
}

std::string without_minus_zero(std::string text) {
    return text.find_first_of("123456789") == std::string::npos && text.starts_with('-') ? text.substr(1) : text;
}

struct ToCell {
    const ResultColumn& column;
    int decimals;
    double factor;

    std::string number(double value) const {
        if (!std::isfinite(value)) return "–";
        if (column.p) return value < 0.001 ? "<0.001" : fmt::format("{:.3f}", value);
        return column.digits > 0 ? significant(factor * value, column.digits)
                                 : without_minus_zero(fmt::format("{:.{}f}", factor * value, decimals));
    }
    std::string limits(double low, double high, bool said) const {
        return said && (std::isfinite(low) || std::isfinite(high)) ? fmt::format("[{}, {}]", number(low), number(high))
                                                                   : "–";
    }
    Cell operator()(Absent) const { return ""; }
    Cell operator()(const Undefined& one) const {
        if (!one.why.empty()) return one.why;
        return column.holds == ResultColumn::Holds::values ? Cell{"–"} : Cell{"–", ""};
    }
    Cell operator()(bool value) const { return value ? "yes" : "no"; }
    Cell operator()(std::int64_t value) const { return fmt::format("{}", value); }
    Cell operator()(double value) const { return number(value); }
    std::string plus_minus(const Estimate& one) const {
        if (!std::isfinite(one.value)) return "–";
        const bool sign = column.form == ResultColumn::Form::difference && one.value >= 0;
        const std::string text = (sign ? "+" : "") + number(one.value);
        if (one.low == one.high) return text + " in all";
        return fmt::format("{} ± {}", text, one.said ? number(one.longer_side()) : "–");
    }
    Cell operator()(const Estimate& one) const {
        if (column.form != ResultColumn::Form::bracket) return plus_minus(one);
        return {number(one.value), std::isfinite(one.value) ? limits(one.low, one.high, one.said) : ""};
    }
    Cell operator()(const Bracket& one) const { return {"", limits(one.limits.low, one.limits.high, one.said)}; }
    Cell operator()(const Named& one) const { return one.label; }
    Cell operator()(const std::string& text) const { return text; }
};

/// A number in the unit of its column with so many decimals.
Cell shown_cell(const Datum& value, const ResultColumn& column, int decimals, const Units& units) {
    return std::visit(ToCell{column, decimals, units.of(column.unit).factor}, value.get());
}

struct ToData {
    std::vector<Datum>& row;
    ResultColumn::Holds holds;

    void operator()(Absent none) const { fill(none); }
    void operator()(Undefined none) const { fill(none); }
    void operator()(const Estimate& one) const { row.insert(row.end(), {one.value, one.low, one.high}); }
    void operator()(const Bracket& one) const { row.insert(row.end(), {one.limits.low, one.limits.high}); }
    void operator()(const Named& one) const { row.push_back(if_known(!one.name.empty(), one.name)); }
    void operator()(const auto& value) const { row.emplace_back(value); }

    void fill(Datum none) const {
        constexpr std::size_t places[]{1, 3, 2};
        row.insert(row.end(), places[static_cast<std::size_t>(holds)], none);
    }
};

struct ToNumber {
    double operator()(double value) const { return value; }
    double operator()(std::int64_t value) const { return static_cast<double>(value); }
    double operator()(const Estimate& one) const { return one.value; }
    double operator()(const auto&) const { return std::nan(""); }
};

struct ToName {
    std::string operator()(const Named& one) const { return one.name; }
    std::string operator()(const std::string& text) const { return text; }
    std::string operator()(const auto&) const { return ""; }
};

bool is_for(Results::For row, Results::For reader) {
    return row == reader || (reader == Results::For::everybody && row == Results::For::people);
}

struct ShownColumn {
    std::size_t at;
    ResultColumn about;  ///< with the unit of the heading above
    int decimals;
};

/// Rows as lines, with a heading.
Table lines_of(const Results& results, const Units& units, Results::For whom) {
    const std::size_t rows = results.rows.size();
    Table table(1);
    std::vector<ShownColumn> shown;
    for (std::size_t k = 0; k < results.columns.size(); ++k) {
        const ResultColumn& column = results.columns[k];
        if (column.words.empty()) continue;
        shown.push_back({k, column, decimals_of(results, k, column.unit, units, 0, rows)});
        table.front().emplace_back(units.heading(column.words, column.unit));
    }
    for (std::size_t r = 0; r < rows; ++r) {
        if (!is_for(results.rows_for[r], whom)) continue;
        std::vector<Cell>& line = table.emplace_back();
        if (!is_heading(results, r)) {
            for (const auto& [at, about, decimals] : shown)
                line.push_back(shown_cell(results.rows[r][at], about, decimals, units));
            continue;
        }
        const auto& heading = std::get<Named>(results.rows[r].front().get());  // named by its unit
        line.assign(shown.size(), "");
        line.front() = units.heading(heading.label, heading.name);
        std::size_t end = r + 1;
        while (end < rows && !is_heading(results, end)) ++end;
        for (auto& [at, about, decimals] : shown) {
            if (!results.columns[at].unit.empty()) continue;
            about.unit = heading.name;
            decimals = decimals_of(results, at, about.unit, units, r + 1, end);
        }
    }
    return table;
}

Table transposed(const Table& lines) {
    Table turned(lines.front().size());
    for (const std::vector<Cell>& line : lines)
        for (std::size_t k = 0; k < line.size(); ++k) turned[k].push_back(line[k]);
    return turned;
}

std::size_t column_of(const Results& results, std::string_view key) {
    const auto found = std::ranges::find(results.columns, key, &ResultColumn::key);
    if (found == results.columns.end()) throw RunError(fmt::format("results without a column {}", key));
    return static_cast<std::size_t>(found - results.columns.begin());
}

/// What tells values of a column apart.
std::string words_of(const Results& results, std::size_t column, const std::vector<Datum>& row) {
    constexpr int decimals = 9;
    return shown_cell(row[column], results.columns[column], decimals, Units{}).value;
}

/// Each word once, in the order of the rows.
std::vector<std::string> words_in(const Results& results, std::size_t column) {
    std::vector<std::string> words;
    for (const std::vector<Datum>& row : results.rows) {
        std::string one = words_of(results, column, row);
        if (std::ranges::find(words, one) == words.end()) words.push_back(std::move(one));
    }
    return words;
}

}  // namespace

void Results::add(std::vector<Datum> row, For whom) {
    if (row.size() != columns.size())
        throw RunError(fmt::format("{} has a row of {} values under {} columns", place, row.size(), columns.size()));
    rows.push_back(std::move(row));
    rows_for.push_back(whom);
}

const Datum& Results::at(std::size_t row, std::string_view key) const {
    FLOES_EXPECTS(row < rows.size());
    return rows.at(row).at(column_of(*this, key));
}

bool Results::for_people() const {
    return view != View::none && std::ranges::any_of(columns, [](const auto& one) { return !one.words.empty(); });
}

double Results::number(std::size_t row, std::string_view key) const {
    return std::visit(ToNumber{}, at(row, key).get());
}

std::string Results::name(std::size_t row, std::string_view key) const {
    return std::visit(ToName{}, at(row, key).get());
}

void Results::add_heading(std::string words, For whom, std::string unit) {
    rows.push_back({Datum(Named{std::move(unit), std::move(words)})});
    rows_for.push_back(whom == For::everybody ? For::people : whom);
}

Results object(std::string place, std::vector<std::pair<std::string, Datum>> values) {
    Results made{.place = std::move(place), .object = true, .in_csv = false};
    std::vector<Datum> row;
    for (auto& [key, value] : values) {
        made.columns.push_back({.key = std::move(key)});
        row.push_back(std::move(value));
    }
    made.add(std::move(row));
    return made;
}

std::vector<ResultColumn> program_columns(std::string_view keys) {
    std::vector<ResultColumn> columns;
    for (const auto key : std::views::split(keys, ' ')) columns.push_back({std::string(key.begin(), key.end())});
    return columns;
}

std::vector<ResultColumn> operator+(std::vector<ResultColumn> first, const std::vector<ResultColumn>& second) {
    first.insert(first.end(), second.begin(), second.end());
    return first;
}

std::vector<Datum> operator+(std::vector<Datum> first, const std::vector<Datum>& second) {
    first.insert(first.end(), second.begin(), second.end());
    return first;
}

Table shown_table(const Results& results, const Units& units, Results::For whom) {
    if (!results.for_people()) return {};
    Table lines = lines_of(results, units, whom);
    if (lines.size() == 1) return {};
    return results.view == Results::View::side_by_side ? transposed(lines) : lines;
}

DataRows data_rows(const Results& results) {
    DataRows records{.place = results.place,
                     .names = {},
                     .object = results.object,
                     .in_csv = results.in_csv,
                     .in_json = results.in_json};
    std::vector<std::size_t> shown;
    for (std::size_t k = 0; k < results.columns.size(); ++k) {
        const ResultColumn& one = results.columns[k];
        if (one.key.empty()) continue;
        shown.push_back(k);
        if (one.holds != ResultColumn::Holds::brackets) records.names.push_back(one.key);
        if (one.holds == ResultColumn::Holds::values) continue;
        records.names.push_back(one.key + "_low");
        records.names.push_back(one.key + "_high");
    }
    for (std::size_t r = 0; r < results.rows.size(); ++r) {
        if (is_heading(results, r) || results.rows_for[r] == Results::For::people) continue;
        std::vector<Datum>& row = records.rows.emplace_back();
        for (const std::size_t k : shown) std::visit(ToData{row, results.columns[k].holds}, results.rows[r][k].get());
        if (row.size() != records.names.size())
            throw RunError(fmt::format("{} has values that are not what their columns hold", results.place));
    }
    return records;
}

Results pivot(const Results& results, std::string_view down, std::string_view across,
              const std::vector<std::string>& cells) {
    const std::size_t line_at = column_of(results, down);
    const std::size_t side_at = column_of(results, across);
    const std::vector<std::string> lines = words_in(results, line_at);
    const std::vector<std::string> sides = words_in(results, side_at);
    Results turned{.columns = {results.columns[line_at]}};
    turned.columns.front().key.clear();
    for (const std::string& side : sides)
        for (const std::string& key : cells) {
            ResultColumn column = results.columns[column_of(results, key)];
            column.key.clear();
            column.words = cells.size() == 1 ? side : side + ": " + column.words;
            turned.columns.push_back(std::move(column));
        }
    for (const std::string& line : lines) {
        std::vector<Datum> row(turned.columns.size(), Undefined{});
        for (const std::vector<Datum>& from : results.rows) {
            if (words_of(results, line_at, from) != line) continue;
            row.front() = from[line_at];
            const auto side =
                static_cast<std::size_t>(std::ranges::find(sides, words_of(results, side_at, from)) - sides.begin());
            for (std::size_t k = 0; k < cells.size(); ++k)
                row[1 + side * cells.size() + k] = from[column_of(results, cells[k])];
        }
        turned.add(std::move(row));
    }
    return turned;
}

namespace {

/// Each part ends in a newline.
std::string joined(const std::vector<std::string>& parts) {
    return fmt::format("{}", fmt::join(parts, "\n"));
}

std::string results_text(const Results& results, int width, const Units& units) {
    Table table = shown_table(results, units);
    const Table folded = shown_table(results, units, Results::For::folded);
    if (table.empty()) return "";
    if (results.view == Results::View::side_by_side) return text_panels(table, width);
    if (!folded.empty()) table.insert(table.end(), folded.begin() + 1, folded.end());
    return text_columns(table, width);
}

std::string table_text(const Section& section, int width, const Units& units) {
    std::vector<std::string> parts;
    for (const Results& one : section.results)
        if (std::string part = results_text(one, width, units); !part.empty()) parts.push_back(std::move(part));
    return joined(parts);
}

std::vector<DataRows> all_records(std::span<const Section> sections) {
    std::vector<DataRows> all;
    for (const Section& one : sections) std::ranges::move(records_of(one), std::back_inserter(all));
    return all;
}

}  // namespace

std::string text(std::span<const Section> sections, int width, const Units& units) {
    std::vector<std::string> parts;
    for (const Section& one : sections) {
        std::string part = one.title.empty() ? "" : one.title + "\n\n";
        const std::string tables = table_text(one, width, units);
        part += wrapped(one.before, width) + tables + wrapped(one.after, width);
        if (!tables.empty() && one.after.empty() && !one.notes.empty()) part += '\n';
        for (const std::string& note : one.notes) part += wrapped(note, width) + "\n";
        part += wrapped(one.missing, width);
        if (!part.empty()) parts.push_back(std::move(part));
    }
    return joined(parts);
}

std::string csv(std::span<const Section> sections) {
    std::vector<std::string> parts;
    for (const DataRows& records : all_records(sections))
        if (std::string part = csv(records); !part.empty()) parts.push_back(std::move(part));
    return joined(parts);
}

std::string json(std::span<const Section> sections) {
    return json(all_records(sections));
}

std::vector<DataRows> records_of(const Section& section) {
    std::vector<DataRows> records;
    for (const Results& one : section.results)
        if (std::ranges::any_of(one.columns, [](const ResultColumn& column) { return !column.key.empty(); }))
            records.push_back(data_rows(one));
    return records;
}

}  // namespace floes
