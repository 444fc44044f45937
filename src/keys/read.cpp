#include "keys/read.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "core/error.hpp"
#include "keys/key.hpp"
#include "keys/meant.hpp"

namespace floes {
namespace {

/// ", write 0.033, with a point" of the text "0,033", which --set takes as a text; otherwise empty.
std::string with_a_point(const Value& value) {
    const auto* text = std::get_if<std::string>(&value.data);
    const std::string pointed = text == nullptr ? "" : with_decimal_point(*text);
    return pointed.empty() ? "" : fmt::format(", write {}, with a point", pointed);
}

struct Assigner {
    const Key& key;
    const Entry& entry;

    InputError wrong(std::string_view what, std::string_view reason = "") const {
        return InputError("{}: {} = {} {}; allowed: {}{}", entry.where, key.path, to_text(entry.value), what,
                          allowed(key), reason.empty() ? "" : fmt::format(" ({})", reason));
    }

    /// What the entry's value is. `otherwise`: what is wrong with another.
    template <class Data>
    const Data& need(std::string_view otherwise) const {
        if (const auto* data = std::get_if<Data>(&entry.value.data)) return *data;
        throw wrong(otherwise);
    }

    void operator()(const NumberField& field) const {
        const std::optional<double> number = number_of(entry.value);
        if (!number) throw wrong("is not a number" + with_a_point(entry.value), field.range.reason);
        const double in_si = *number * field.unit;
        // The range applies to the number as written; the product may still underflow to a forbidden 0, or overflow.
        const bool lost = (in_si == 0 && *number != 0) || std::isinf(in_si) != std::isinf(*number);
        if (!field.range.contains(*number) || lost) throw wrong("is out of range", field.range.reason);
        field.set(in_si);
    }

    void operator()(const NumbersField& field) const {
        const auto& list = need<std::vector<Value>>("is not a list");
        std::vector<double> numbers;
        for (const Value& item : list) {
            const std::optional<double> number = number_of(item);
            if (!number) throw wrong(fmt::format("has {}, which is not a number", to_text(item)));
            if (!field.range.contains(*number)) throw wrong(fmt::format("has {}, out of range", to_text(item)));
            numbers.push_back(*number * field.unit);
        }
        *field.values = std::move(numbers);
    }

    void operator()(const IntegerField& field) const {
        const auto integer = need<std::int64_t>("is not a whole number");
        if (integer < field.low || integer > field.high) throw wrong("is out of range");
        field.set(integer);
    }

    void operator()(const SwitchField& field) const { *field.value = need<bool>("is neither true nor false"); }

    void operator()(const WordField& field) const {
        field.set(
            number_of_word(field.words, need<std::string>("is not a word in quotes"), "is not a word of this key"));
    }

    void operator()(const WordsField& field) const {
        const auto& list = need<std::vector<Value>>("is not a list");
        std::vector<bool> chosen(field.words.size(), false);
        for (const Value& item : list) {
            const auto* text = std::get_if<std::string>(&item.data);
            if (text == nullptr) throw wrong(fmt::format("has {}, which is not a word in quotes", to_text(item)));
            chosen[number_of_word(field.words, *text,
                                  fmt::format("has {}, which is none of its words", to_text(item)))] = true;
        }
        field.set(chosen);
    }

    /// `otherwise`: what is wrong with a text that is none of the words. Behind it stands the word that was mistyped,
    /// or else what the words mean.
    std::size_t number_of_word(const std::vector<std::string_view>& words, const std::string& text,
                               const std::string& otherwise) const {
        const auto found = std::ranges::find(words, text);
        if (found != words.end()) return static_cast<std::size_t>(found - words.begin());
        const auto distance = [&](std::string_view word) { return edit_distance(word, text); };
        const std::string_view near = *std::ranges::min_element(words, {}, distance);
        throw InputError(wrong(otherwise).what() + (2 * distance(near) <= near.size()
                                                        ? fmt::format("; did you mean {}?", text_literal(near))
                                                        : fmt::format(" ({})", key.doc.substr(0, key.doc.find('.')))));
    }

    void operator()(const TextField& field) const { *field.value = need<std::string>("is not text"); }

    void operator()(const RowsField& field) const {
        const auto& list = need<std::vector<Value>>("is not a list");
        std::vector<std::vector<double>> rows;
        for (const Value& item : list) rows.push_back(row(field, item, rows.size()));
        field.set(rows);
    }

    std::vector<double> row(const RowsField& field, const Value& item, std::size_t index) const {
        const auto fail = [&](const std::string& what) {
            return InputError("{}: {}[{}] = {} {}; allowed: {}", entry.where, key.path, index, to_text(item), what,
                              allowed(key));
        };
        const auto* values = std::get_if<std::vector<Value>>(&item.data);
        if (values == nullptr || values->size() < field.columns.size() ||
            (values->size() > field.columns.size() && !field.open)) {
            throw fail(fmt::format("is not a row of {} numbers", field.columns.size()));
        }
        std::vector<double> numbers;
        for (std::size_t i = 0; i < values->size(); ++i) {
            const std::optional<double> number = number_of((*values)[i]);
            if (i >= field.columns.size()) {
                if (!number || !std::isfinite(*number)) throw fail("has something that is not a number");
                numbers.push_back(*number);
                continue;
            }
            if (!number) throw fail(fmt::format("has a {} that is not a number", field.columns[i].name));
            if (!field.columns[i].range.contains(*number))
                throw fail(fmt::format("has a {} out of range", field.columns[i].name));
            numbers.push_back(*number * field.columns[i].unit);
        }
        return numbers;
    }
};

}  // namespace

void assign(const Key& key, const Entry& entry) {
    std::visit(Assigner{key, entry}, key.field);
}

void refuse_former(std::span<const Key> keys, const Entry& entry) {
    const Key* now = present_key(keys, entry.path);
    if (now == nullptr) return;
    std::string value = to_text(entry.value);
    if (now->former.empty()) {
        assign(*find_key(keys, entry.path), entry);  // the present key then shows what was meant
        value = literal(*now);
    }
    throw InputError("{}: {} = {} is a key of floes 1.0.0; write {} = {}", entry.where, entry.path,
                     to_text(entry.value), now->path, value);
}

void refuse_former(std::span<const Key> keys, const std::string& path, const std::string& where) {
    if (const Key* now = present_key(keys, path))
        throw InputError("{}: {} is a key of floes 1.0.0; write {}", where, path, now->path);
}

std::string assign_known(std::span<const Key> keys, const Entry& entry) {
    if (const Key* key = find_key(keys, entry.path)) {
        if (key->replaced || key->path != entry.path) refuse_former(keys, entry);
        assign(*key, entry);
        return std::string(key->path);
    }
    const bool empty_table = entry.value == Value{Value::Strange{"an empty table"}};
    const bool known_table =
        std::ranges::any_of(keys, [&](const Key& key) { return key.path.starts_with(entry.path + "."); });
    if (empty_table && known_table) return "";
    if (empty_table) {
        const auto distance = [&](const Key& key) { return edit_distance(key.table(), entry.path); };
        throw InputError("{}: [{}] is not a table of keys; did you mean [{}]?", entry.where, entry.path,
                         std::ranges::min_element(keys, {}, distance)->table());
    }
    if (known_table) {
        throw InputError("{}: {} = {} is a table of keys, not a key; write {} with its keys below", entry.where,
                         entry.path, to_text(entry.value), "[" + entry.path + "]");
    }
    throw InputError("{}: {} = {} is not a key; did you mean {}?", entry.where, entry.path, to_text(entry.value),
                     nearest_path(keys, entry.path));
}

}  // namespace floes
