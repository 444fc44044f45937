#include "keys/key.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "core/contract.hpp"
#include "keys/meant.hpp"

namespace floes {

Range Range::at_most(double bound) const {
    FLOES_EXPECTS(bound >= low);
    Range range = *this;
    range.high = bound;
    return range;
}

Range Range::below(double bound) const {
    FLOES_EXPECTS(bound > low);
    Range range = at_most(bound);
    range.high_included = false;
    return range;
}

Range Range::or_infinity() const {
    Range range = *this;
    range.infinity_included = true;
    return range;
}

Range Range::because(std::string_view why) const {
    Range range = *this;
    range.reason = why;
    return range;
}

bool Range::contains(double value) const {
    const bool high_enough = low_included ? value >= low : value > low;
    const bool low_enough = high_included ? value <= high : value < high;
    if (std::isinf(value)) return infinity_included && value > 0;
    return high_enough && low_enough;
}

Range above(double bound) {
    Range range = at_least(bound);
    range.low_included = false;
    return range;
}

Range at_least(double bound) {
    Range range;
    range.low = bound;
    return range;
}

std::string to_text(const Range& range) {
    std::vector<std::string> parts;
    constexpr double infinity = std::numeric_limits<double>::infinity();
    if (range.low > -infinity)
        parts.push_back(fmt::format("{} {}", range.low_included ? "at least" : "above", range.low));
    if (range.high < infinity)
        parts.push_back(fmt::format("{} {}", range.high_included ? "at most" : "below", range.high));
    const std::string bounds = parts.empty() ? "any number" : fmt::format("{}", fmt::join(parts, " and "));
    return range.infinity_included ? bounds + ", or inf" : bounds;
}

std::string number_literal(double number) {
    std::string text = fmt::format("{}", number);
    if (text.find_first_of(".en") == std::string::npos) text += ".0";  // tells floats of TOML from integers
    return text;
}

std::string number_literal(double in_si, double unit) {
    if (unit == 1) return number_literal(in_si);
    const double number = in_si / unit;
    if (!std::isfinite(number)) return number_literal(number);
    // A number that gives in_si again differs from `number` by less than 5e-16 of it. So where fewer than 15 digits are
    // enough, 15 digits are the same ones followed by zeros.
    for (int digits = std::numeric_limits<double>::digits10; digits <= std::numeric_limits<double>::max_digits10;
         ++digits) {
        const std::string text = fmt::format("{:.{}g}", number, digits);
        double rounded = 0;
        std::from_chars(text.data(), text.data() + text.size(), rounded);
        if (rounded * unit == in_si) return number_literal(rounded);
    }
    for (const double neighbour : {std::nextafter(number, -INFINITY), std::nextafter(number, INFINITY)}) {
        if (neighbour * unit == in_si) return number_literal(neighbour);
    }
    return number_literal(number);
}

std::string text_literal(std::string_view text) {
    std::string literal = "\"";
    for (const char character : text) {
        const auto code = static_cast<unsigned char>(character);
        if (character == '"' || character == '\\') {
            literal += '\\';
            literal += character;
        } else if (code < 0x20 || code == 0x7f) {
            literal += fmt::format("\\u{:04x}", code);
        } else {
            literal += character;
        }
    }
    return literal + "\"";
}

namespace {

std::vector<std::string> row_texts(const RowsField& rows, bool si) {
    std::vector<std::string> lines;
    for (const std::vector<double>& row : rows.get()) {
        std::vector<std::string> numbers;
        for (std::size_t i = 0; i < row.size(); ++i)
            numbers.push_back(number_literal(row[i], si || i >= rows.columns.size() ? 1.0 : rows.columns[i].unit));
        lines.push_back(fmt::format("[{}]", fmt::join(numbers, ", ")));
    }
    return lines;
}

std::string quoted(const std::vector<std::string_view>& words, std::string_view between) {
    std::vector<std::string> texts;
    for (const std::string_view word : words) texts.push_back(text_literal(word));
    return fmt::format("{}", fmt::join(texts, between));
}

std::string chosen_text(const WordsField& field) {
    std::vector<std::string_view> chosen;
    const std::vector<bool> flags = field.get();
    for (std::size_t i = 0; i < field.words.size(); ++i)
        if (flags[i]) chosen.push_back(field.words[i]);
    return fmt::format("[{}]", quoted(chosen, ", "));
}

std::vector<std::string> number_texts(const NumbersField& numbers, bool si) {
    std::vector<std::string> texts;
    for (const double value : *numbers.values) texts.push_back(number_literal(value, si ? 1.0 : numbers.unit));
    return texts;
}

std::string list_text(const std::vector<std::string>& items) {
    return fmt::format("[{}]", fmt::join(items, ", "));
}

struct Literal {
    bool si;
    std::string operator()(const NumberField& number) const {
        return si ? number_literal(number.get()) : number_literal(number.get(), number.unit);
    }
    std::string operator()(const NumbersField& numbers) const { return list_text(number_texts(numbers, si)); }
    std::string operator()(const IntegerField& integer) const { return fmt::format("{}", integer.get()); }
    std::string operator()(const SwitchField& field) const { return *field.value ? "true" : "false"; }
    std::string operator()(const WordField& word) const { return text_literal(word.words[word.get()]); }
    std::string operator()(const WordsField& words) const { return chosen_text(words); }
    std::string operator()(const TextField& text) const { return text_literal(*text.value); }
    std::string operator()(const RowsField& rows) const { return list_text(row_texts(rows, si)); }
};

struct Allowed {
    std::string operator()(const NumberField& number) const { return to_text(number.range); }
    std::string operator()(const NumbersField& numbers) const {
        return fmt::format("a list of numbers, each {}", to_text(numbers.range));
    }
    std::string operator()(const IntegerField& integer) const {
        if (integer.high == std::numeric_limits<std::int64_t>::max()) {
            return fmt::format("a whole number from {}", integer.low);
        }
        return fmt::format("a whole number from {} to {}", integer.low, integer.high);
    }
    std::string operator()(const SwitchField&) const { return "true or false"; }
    std::string operator()(const WordField& word) const { return quoted(word.words, " or "); }
    std::string operator()(const WordsField& field) const {
        return fmt::format("a list of {}", quoted(field.words, ", "));
    }
    std::string operator()(const TextField&) const { return "text in quotes"; }
    std::string operator()(const RowsField& rows) const {
        std::vector<std::string> names;
        std::vector<std::string> ranges;
        for (const Column& column : rows.columns) {
            names.push_back(column.name);
            const std::string range = to_text(column.range);
            if (range != "any number") ranges.push_back(fmt::format("{} {}", column.name, range));
        }
        const std::string shape = fmt::format("a list of [{}]", fmt::join(names, ", "));
        return ranges.empty() ? shape : fmt::format("{}, {}", shape, fmt::join(ranges, ", "));
    }
};

}  // namespace

Key number_key(std::string_view path, double& field, double unit, Range range, std::string_view source,
               std::string_view doc) {
    return {path,
            NumberField{[&field] { return field; }, [&field](double value) { field = value; }, unit, std::move(range)},
            source, doc};
}

Key numbers_key(std::string_view path, std::vector<double>& field, double unit, Range range, std::string_view source,
                std::string_view doc) {
    return {path, NumbersField{&field, unit, std::move(range)}, source, doc};
}

Key integer_key(std::string_view path, int& field, int low, int high, std::string_view source, std::string_view doc) {
    IntegerField binding{[&field] { return std::int64_t{field}; },
                         [&field](std::int64_t value) { field = static_cast<int>(value); }, low, high};
    return {path, std::move(binding), source, doc};
}

Key switch_key(std::string_view path, bool& field, std::string_view source, std::string_view doc) {
    return {path, SwitchField{&field}, source, doc};
}

Key text_key(std::string_view path, std::string& field, std::string_view source, std::string_view doc) {
    return {path, TextField{&field}, source, doc};
}

Key preset_key(Key key) {
    key.preset = true;
    return key;
}

Key part_key(Key key) {
    key.part = true;
    return key;
}

Key late_key(Key key) {
    key.late = true;
    return key;
}

Key only_with(std::string_view setting, std::function<bool()> in_force, Key key) {
    if (key.in_force) {  // what was said first is what it wants nearest
        key.in_force = [outer = std::move(in_force), inner = std::move(key.in_force)] { return outer() && inner(); };
        return key;
    }
    key.only_with = setting;
    key.in_force = std::move(in_force);
    return key;
}

std::vector<Entry> in_order_of_reading(std::span<const Key> keys, std::vector<Entry> entries) {
    const auto is_first = [&](const Entry& entry) {
        return std::ranges::any_of(keys, [&](const Key& key) { return key.preset && key.path == entry.path; });
    };
    const auto others = std::ranges::stable_partition(entries, is_first);
    std::ranges::stable_partition(others, [&](const Entry& entry) {
        return std::ranges::none_of(keys, [&](const Key& key) { return key.part && key.path == entry.path; });
    });
    return entries;
}

std::string allowed(const Key& key) {
    return std::visit(Allowed{}, key.field);
}

std::string literal(const Key& key) {
    return std::visit(Literal{false}, key.field);
}

std::string exact_text(const Key& key) {
    return std::visit(Literal{true}, key.field);
}

std::vector<std::string> items(const Key& key) {
    if (const auto* rows = std::get_if<RowsField>(&key.field)) return row_texts(*rows, false);
    const auto* numbers = std::get_if<NumbersField>(&key.field);
    return numbers != nullptr ? number_texts(*numbers, false) : std::vector<std::string>{};
}

const Key* find_key(std::span<const Key> keys, std::string_view path) {
    const auto found = std::ranges::find(keys, path, &Key::path);
    if (found != keys.end()) return &*found;
    for (const Key& key : keys) {
        if (!key.former.empty() && key.former == path) return &key;
        if (const Key* replaced = find_key(key.before, path)) return replaced;
    }
    return nullptr;
}

std::string nearest_path(std::span<const Key> keys, std::string_view path) {
    const std::string_view name = path.substr(path.rfind('.') + 1);  // the whole path without a dot
    const auto distance = [&](const Key& key) -> std::size_t {
        if (key.path.starts_with(std::string(path) + '_')) return 0;  // a name without its unit
        if (key.name().starts_with(std::string(name) + '_')) return 1;
        return std::min(edit_distance(key.path, path), edit_distance(key.name(), name) + 1);
    };
    return std::string(std::ranges::min_element(keys, {}, distance)->path);
}

Key formerly(std::string_view path, Key key) {
    key.former = path;
    return key;
}

Key instead_of(std::vector<Key> before, Key key) {
    key.before = std::move(before);
    for (Key& old : key.before) old.replaced = true;
    return key;
}

Keys keys_of_digest(Keys keys) {
    Keys old;
    old.reserve(keys.size() + 8);
    for (Key& key : keys) {
        if (key.derived()) continue;
        if (!key.former.empty()) key.path = key.former;
        if (key.before.empty()) old.push_back(std::move(key));
        for (Key& replaced : key.before) old.push_back(std::move(replaced));
    }
    return old;
}

const Key* present_key(std::span<const Key> keys, std::string_view path) {
    if (path.empty() || std::ranges::find(keys, path, &Key::path) != keys.end()) return nullptr;
    const auto stands = [&](const Key& key) { return key.former == path || find_key(key.before, path) != nullptr; };
    const auto found = std::ranges::find_if(keys, stands);
    return found == keys.end() ? nullptr : &*found;
}

}  // namespace floes
