#include <cmath>
#include <nlohmann/json.hpp>

#include "tables/data_rows.hpp"

namespace floes {
namespace {

using Json = nlohmann::ordered_json;  // keeps the order of names

struct ToJson {
    Json operator()(Absent) const { return nullptr; }
    Json operator()(Undefined) const { return nullptr; }
    Json operator()(bool value) const { return value; }
    Json operator()(std::int64_t value) const { return value; }
    Json operator()(double value) const { return std::isfinite(value) ? Json(value) : Json(nullptr); }
    Json operator()(const std::string& text) const { return text; }
};

/// The element "a/0/b" of `parent`, created if absent.
Json& at(Json& parent, const std::string& place) {
    return place.empty() || place == "." ? parent : parent[Json::json_pointer("/" + place)];
}

void put(Json& record, const std::vector<Names>& names, const std::vector<Datum>& row) {
    for (std::size_t k = 0; k < names.size(); ++k) {
        if (names[k].json.empty() || std::holds_alternative<Absent>(row[k].get())) continue;
        at(record, names[k].json) = std::visit(ToJson{}, row[k].get());
    }
}

bool has_names(const DataRows& records) {
    for (const Names& one : records.names)
        if (!one.json.empty()) return true;
    return false;
}

void add(Json& document, const DataRows& records) {
    if (!has_names(records)) return;
    Json& place = at(document, records.place);
    if (records.shape == DataRows::Shape::object) {
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
