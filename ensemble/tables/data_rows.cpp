#include "tables/data_rows.hpp"

#include <cmath>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace floes {

namespace {

struct Field {
    std::string operator()(Absent) const { return ""; }
    std::string operator()(Undefined) const { return ""; }
    std::string operator()(bool value) const { return value ? "1" : "0"; }
    std::string operator()(std::int64_t value) const { return fmt::format("{}", value); }
    std::string operator()(double value) const { return std::isfinite(value) ? fmt::format("{}", value) : ""; }
    std::string operator()(const Estimate& one) const { return (*this)(one.value); }
    std::string operator()(const Bracket&) const { return ""; }
    std::string operator()(const Named& one) const { return (*this)(one.name); }
    /// Quoted if a comma, a quote or a line end would be misread.
    std::string operator()(const std::string& text) const {
        if (text.find_first_of(",\"\r\n") == std::string::npos) return text;
        std::string quoted;
        for (const char letter : text) quoted.append(letter == '"' ? 2 : 1, letter);
        return fmt::format("\"{}\"", quoted);
    }
};

void end_line(std::string& line) {
    line.back() = '\n';  // in place of the last comma
}

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

std::string csv(const DataRows& records) {
    std::string text;
    if (!records.in_csv) return text;
    for (const std::string& name : records.names) text += Field{}(name) + ",";
    end_line(text);
    for (const std::vector<Datum>& row : records.rows) {
        for (const Datum& value : row) text += std::visit(Field{}, value.get()) + ",";
        end_line(text);
    }
    return text;
}

namespace {

using Json = nlohmann::ordered_json;  // keeps the order of names

struct ToJson {
    Json operator()(Absent) const { return nullptr; }
    Json operator()(Undefined) const { return nullptr; }
    Json operator()(bool value) const { return value; }
    Json operator()(std::int64_t value) const { return value; }
    Json operator()(double value) const { return std::isfinite(value) ? Json(value) : Json(nullptr); }
    Json operator()(const Estimate& one) const { return (*this)(one.value); }
    Json operator()(const Bracket&) const { return nullptr; }
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

}  // namespace floes
