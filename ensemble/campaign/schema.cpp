#include "campaign/schema.hpp"

#include <array>
#include <cmath>
#include <string_view>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "campaign/campaign.hpp"
#include "campaign/campaign_keys.hpp"
#include "keys/document.hpp"
#include "keys/key.hpp"

namespace floes {

namespace {

using OrderedJson = nlohmann::ordered_json;

/// A value as a configuration has it. JSON has no infinity: null.
OrderedJson json_of(const Value& value) {
    return std::visit(
        []<class Data>(const Data& data) -> OrderedJson {
            if constexpr (std::same_as<Data, std::vector<Value>>) {
                OrderedJson list = OrderedJson::array();
                for (const Value& item : data) list.push_back(json_of(item));
                return list;
            } else if constexpr (std::same_as<Data, Value::Strange>) {
                return nullptr;
            } else {
                return data;
            }
        },
        value.data);
}

OrderedJson number_schema(const Range& range) {
    OrderedJson schema{{"type", "number"}};
    if (std::isfinite(range.low)) schema[range.low_included ? "minimum" : "exclusiveMinimum"] = range.low;
    if (std::isfinite(range.high) && !range.infinity_included)
        schema[range.high_included ? "maximum" : "exclusiveMaximum"] = range.high;
    return schema;
}

OrderedJson list_of(OrderedJson items) {
    return {{"type", "array"}, {"items", std::move(items)}};
}

/// What a field takes, without its meaning.
struct FieldSchema {
    OrderedJson operator()(const NumberField& field) const { return number_schema(field.range); }
    OrderedJson operator()(const NumbersField& field) const { return list_of(number_schema(field.range)); }
    OrderedJson operator()(const IntegerField& field) const {
        return {{"type", "integer"}, {"minimum", field.low}, {"maximum", field.high}};
    }
    OrderedJson operator()(const SwitchField&) const { return {{"type", "boolean"}}; }
    OrderedJson operator()(const WordField& field) const { return {{"type", "string"}, {"enum", field.words}}; }
    OrderedJson operator()(const WordsField& field) const {
        return list_of({{"type", "string"}, {"enum", field.words}});
    }
    OrderedJson operator()(const TextField&) const { return {{"type", "string"}}; }
    OrderedJson operator()(const RowsField& field) const {
        OrderedJson columns = OrderedJson::array();
        for (const Column& column : field.columns) {
            OrderedJson one = number_schema(column.range);
            one["title"] = column.name;
            columns.push_back(std::move(one));
        }
        OrderedJson row{{"type", "array"}, {"minItems", field.columns.size()}};
        if (!field.open) row["maxItems"] = field.columns.size();
        row["items"] = std::move(columns);
        row["additionalItems"] = field.open ? OrderedJson{{"type", "number"}} : OrderedJson(false);
        return list_of(std::move(row));
    }
};

/// `with_default`: whether what is left out has the field's value; in a [[case]] it has that of the tables.
OrderedJson key_schema(const Key& key, bool with_default) {
    OrderedJson schema = std::visit(FieldSchema{}, key.field);
    std::string about = fmt::format("{} Allowed: {}.", key.doc, allowed(key));
    if (!key.only_with.empty()) about += fmt::format(" Only with {}.", key.only_with);
    schema["description"] = std::move(about);
    if (!with_default) return schema;
    OrderedJson value = json_of(parse_override("value=" + literal(key), "a default").value);
    if (!value.is_null()) schema["default"] = std::move(value);
    return schema;
}

/// An object that has these keys alone.
OrderedJson closed_object() {
    return {{"type", "object"}, {"additionalProperties", false}, {"properties", OrderedJson::object()}};
}

/// Two keys of a table that say the same thing in two ways.
struct Either {
    std::string_view table, one, other;
};
constexpr std::array<Either, 4> exclusive{{{"hull", "file", "pieces"},
                                           {"shapes", "file", "outlines"},
                                           {"arrangement", "file", "poses"},
                                           {"path", "legs", "places"}}};

/// Empty ones, as floes config --defaults writes them, are not given.
OrderedJson both_given(const Either& pair) {
    const OrderedJson given{{"minLength", 1}, {"minItems", 1}};
    OrderedJson schema{{"required", {pair.one, pair.other}}};
    for (const std::string_view name : {pair.one, pair.other}) schema["properties"][std::string(name)] = given;
    return schema;
}

OrderedJson table_schema(std::string_view table, const TableTitles& titles) {
    OrderedJson schema = closed_object();
    if (const auto title = titles.find(std::string(table)); title != titles.end())
        schema["description"] = title->second;
    for (const Either& pair : exclusive)
        if (pair.table == table) schema["not"] = both_given(pair);
    return schema;
}

/// Tables by name, with their keys; keys without a table stand beside them.
OrderedJson properties_of(std::span<const Key> keys, bool with_defaults) {
    const TableTitles all = titles();
    OrderedJson properties = OrderedJson::object();
    for (const Key& key : keys) {
        if (key.path.find('.') == std::string_view::npos) {
            properties[std::string(key.path)] = key_schema(key, with_defaults);
            continue;
        }
        const std::string table(key.table());
        if (!properties.contains(table)) properties[table] = table_schema(table, all);
        properties[table]["properties"][std::string(key.name())] = key_schema(key, with_defaults);
    }
    return properties;
}

OrderedJson case_schema() {
    Case one;
    OrderedJson schema = closed_object();
    schema["description"] = "A set of changes to the tables, run with every arrangement.";
    schema["required"] = {"name"};
    schema["properties"] = properties_of(describe(one), false);
    schema["properties"]["name"] = {
        {"type", "string"}, {"pattern", "^[A-Za-z0-9_+.-]+$"}, {"description", "Names the case, once."}};
    return schema;
}

OrderedJson axis_schema() {
    const auto number = [](const char* about) { return OrderedJson{{"type", "number"}, {"description", about}}; };
    OrderedJson schema = closed_object();
    schema["description"] = "An axis of the design: values of a grid or a list, else from and to.";
    schema["properties"] = {
        {"key", {{"type", "string"}, {"description", "A key that a case takes, as \"ice.thickness_m\"."}}},
        {"values", {{"type", "array"}, {"minItems", 1}, {"description", "Of a grid or a list, in the key's unit."}}},
        {"from", number("Least value of latin_hypercube and sobol, in the key's unit.")},
        {"to", number("Largest value, above from.")},
        {"scale", {{"type", "string"}, {"enum", {"linear", "log"}}, {"default", "linear"}}}};
    schema["required"] = {"key"};
    schema["oneOf"] = {{{"required", {"values"}}}, {{"required", {"from", "to"}}}};
    schema["dependencies"] = {{"from", {"to"}}, {"to", {"from"}}};
    return schema;
}

}  // namespace

std::string configuration_schema() {
    OrderedJson schema{{"$schema", "http://json-schema.org/draft-07/schema#"},
                       {"title", "A configuration of floes"},
                       {"description", "Every key has its unit in its name. A key that is left out has its default."},
                       {"type", "object"},
                       {"additionalProperties", false}};
    schema["properties"] = properties_of(CampaignTables().keys, true);
    schema["properties"]["design"]["properties"]["axis"] = list_of(axis_schema());
    schema["properties"]["case"] = list_of(case_schema());
    return schema.dump(1) + "\n";
}

}  // namespace floes
