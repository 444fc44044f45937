#pragma once
// The keys of a configuration, and the ranges and texts of their values.

#include <algorithm>
#include <cstdint>
#include <functional>
#include <iterator>
#include <limits>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include "core/units.hpp"
#include "keys/document.hpp"

namespace floes {

/// Allowed range of a number, in the unit of the key. NaN is never allowed.
struct Range {
    double low = -std::numeric_limits<double>::infinity();
    double high = std::numeric_limits<double>::infinity();
    bool low_included = true;
    bool high_included = true;
    bool infinity_included = false;
    std::string_view reason;  ///< why, if it is not obvious; part of the message

    Range at_most(double bound) const;
    Range below(double bound) const;
    Range or_infinity() const;
    Range because(std::string_view why) const;
    bool contains(double value) const;
};
Range above(double bound);
Range at_least(double bound);

/// "above 0 and below 1"; "any number" without bounds.
std::string to_text(const Range& range);

// Numbers and words as TOML writes them.

/// The shortest text that reads back to the same double, always with a point or an exponent: 75 -> "75.0".
std::string number_literal(double number);

/// `in_si / unit` with the fewest digits for which the product with `unit` is `in_si` again, bit for bit. If there is
/// no such double (which happens for values that did not come from text), the nearest one.
std::string number_literal(double in_si, double unit);

/// A basic string in quotes, escaped for TOML.
std::string text_literal(std::string_view text);

// A key of the configuration: a dotted path bound to one field, with its unit, range, meaning and source. One list of
// keys drives everything that concerns configuration text: reading, overriding, writing, comparing, the reference. A
// list of keys refers to the value that it describes and to the words of its descriptions (mostly literals), and must
// not outlive either. The words are not copied, because keys are described anew for each scenario that is compared.
//
// Keys of 1.0.0 that are others now: refuse_former() in keys/read.hpp.

struct NumberField {
    std::function<double()> get;      ///< SI
    std::function<void(double)> set;  ///< SI
    double unit;                      ///< SI value = number in the text * unit
    Range range;
};
struct NumbersField {
    std::vector<double>* values;  ///< SI
    double unit;
    Range range;  ///< of each number
};
struct IntegerField {
    std::function<std::int64_t()> get;
    std::function<void(std::int64_t)> set;
    std::int64_t low;
    std::int64_t high;
};
struct SwitchField {
    bool* value;
};
struct WordField {
    std::vector<std::string_view> words;  ///< in the order of the enumeration
    std::function<std::size_t()> get;
    std::function<void(std::size_t)> set;
};
/// A choice of several words, in the order of an enumeration.
struct WordsField {
    std::vector<std::string_view> words;
    std::function<std::vector<bool>()> get;  ///< for each word whether it is chosen
    std::function<void(const std::vector<bool>&)> set;
};
struct TextField {
    std::string* value;
};
struct Column {
    std::string name;  ///< with its unit: "height_m"
    double unit;
    Range range;
};
struct RowsField {
    std::vector<Column> columns;
    std::function<std::vector<std::vector<double>>()> get;  ///< SI
    std::function<void(const std::vector<std::vector<double>>&)> set;
    bool open = false;  ///< rows may have more numbers behind the columns, as they stand in the text
};

struct Key {
    std::string_view path;  ///< "ice.thickness_m": table, dot, name with unit
    std::variant<NumberField, NumbersField, IntegerField, SwitchField, WordField, WordsField, TextField, RowsField>
        field;
    std::string_view source;       ///< where the default comes from
    std::string_view doc;          ///< meaning, and what changing it does
    bool late = false;             ///< came after the first campaigns; not in a digest where it has the value of before
    bool preset = false;           ///< sets several keys at once
    bool part = false;             ///< sets a part of the value of another key
    std::string_view former = {};  ///< path in 1.0.0, if it was another
    std::vector<Key> before = {};  ///< keys of 1.0.0 that this one replaced, bound to the same fields
    bool replaced = false;         ///< one of those
    std::string_view only_with = {};      ///< setting without which the key has no effect: "joint.model = \"cfm\""
    std::function<bool()> in_force = {};  ///< whether that setting holds; empty: the key always has an effect

    /// It has no field of its own, so digests and differences leave it out.
    bool derived() const { return preset || part; }
    /// Another setting leaves it without effect.
    bool idle() const { return in_force && !in_force(); }

    std::string_view table() const { return path.substr(0, path.find('.')); }
    std::string_view name() const { return path.substr(path.find('.') + 1); }
};

using Keys = std::vector<Key>;

/// All of these, one list after another.
template <class... Lists>
Keys joined_keys(Lists... lists) {
    Keys all;
    all.reserve((lists.size() + ...));
    (std::ranges::move(lists, std::back_inserter(all)), ...);
    return all;
}

/// Functions that make keys, one for each kind of field.
Key number_key(std::string_view path, double& field, double unit, Range range, std::string_view source,
               std::string_view doc);
Key numbers_key(std::string_view path, std::vector<double>& field, double unit, Range range, std::string_view source,
                std::string_view doc);
Key integer_key(std::string_view path, int& field, int low, int high, std::string_view source, std::string_view doc);
Key switch_key(std::string_view path, bool& field, std::string_view source, std::string_view doc);
Key text_key(std::string_view path, std::string& field, std::string_view source, std::string_view doc);

/// A key that came after the first campaigns: scenarios in which it has the value of before keep their digest.
Key late_key(Key key);

/// A key that has an effect only with another setting, `in_force` of which tells whether it holds. Of two settings both
/// have to hold, and the key names the first.
Key only_with(std::string_view setting, std::function<bool()> in_force, Key key);

/// What makes keys that are both.
inline auto late_with(std::string_view setting, std::function<bool()> in_force) {
    return [=](Key key) { return late_key(only_with(setting, in_force, std::move(key))); };
}

/// A key that sets several fields at once, each of which has a key of its own. It is read before those, wherever it
/// stands in the text, so that they can change what it sets.
Key preset_key(Key key);

/// A key that sets a part of the value of another key, so that a design can have it as an axis. It is read after that
/// key. It is never written, because it would override a change of the other key in the text.
Key part_key(Key key);

/// The enumeration must count from 0 in the order of `words`.
template <class Enum>
Key word_key(std::string_view path, Enum& field, std::vector<std::string_view> words, std::string_view source,
             std::string_view doc) {
    WordField binding{std::move(words), [&field] { return static_cast<std::size_t>(field); },
                      [&field](std::size_t word) { field = static_cast<Enum>(word); }};
    return {path, std::move(binding), source, doc};
}

/// The values that the key accepts, as in messages and in the reference: "above 0 and at most 10".
std::string allowed(const Key& key);

/// The field's value as TOML text in the key's unit; reading it gives the same field, bit for bit.
std::string literal(const Key& key);

/// The field's value in SI, each number in the shortest form that reads back to it: equal exactly when the fields are.
std::string exact_text(const Key& key);

/// The numbers or rows of a list as its literal() has them; empty for what is no list.
std::vector<std::string> items(const Key& key);

/// The entries in the order in which they have to be read: preset keys first, part keys last, otherwise as given.
std::vector<Entry> in_order_of_reading(std::span<const Key> keys, std::vector<Entry> entries);

/// The key of that path, present or of 1.0.0, or none. A replaced key is found with its own path and form.
const Key* find_key(std::span<const Key> keys, std::string_view path);

/// The key with the path nearest to a mistyped one: fewest edits, where a correct name in a wrong table counts as one
/// edit, and a name that lacks its unit (field.concentration) as none. `keys` is not empty.
std::string nearest_path(std::span<const Key> keys, std::string_view path);

// Keys of floes 1.0.0 that have another path now, or were replaced.
//
// Digests are made of the paths and values that keys had in 1.0.0, so that members keep theirs. No text may have them.

/// A key that had the path `path` in 1.0.0.
Key formerly(std::string_view path, Key key);

/// A key that replaced `before`, several keys of 1.0.0, which are bound to the fields that `key` sets. One of them may
/// have the path of `key`.
Key instead_of(std::vector<Key> before, Key key);

/// The keys with the paths and forms of 1.0.0, without derived ones: what digests are made of.
Keys keys_of_digest(Keys keys);

/// The key that stands for a path that only 1.0.0 had; none for other paths.
const Key* present_key(std::span<const Key> keys, std::string_view path);

}  // namespace floes
