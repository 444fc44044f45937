#pragma once
// Configuration text as a flat list of "dotted path = value", each with the place it came from. The only door to
// toml++.

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace floes {

/// A value as written in the text. `Strange` stands for what no key accepts: dates and tables; `kind` says which.
struct Value {
    struct Strange {
        std::string kind;
        friend bool operator==(const Strange&, const Strange&) = default;
    };
    std::variant<bool, std::int64_t, double, std::string, std::vector<Value>, Strange> data;
    friend bool operator==(const Value&, const Value&) = default;
};

/// The value as TOML would write it, on one line; long lists and long texts are cut short with "...".
std::string to_text(const Value& value);

/// Of integers as well, as in thickness_m = 1; nothing for what is no number.
std::optional<double> number_of(const Value& value);

struct Entry {
    std::string path;  ///< "ice.thickness_m"; within a block, relative to the block
    Value value;
    std::string where;  ///< "table3.toml:12", the beginning of a message about this entry
};

/// One table of an array of tables: [[case]].
struct Block {
    std::string path;
    std::string where;
    std::vector<Entry> entries;

    /// The entry of a path; null if it is not there.
    const Entry* find(std::string_view path_in_block) const;
};

/// Entries and blocks in the order of the text.
struct Document {
    std::vector<Entry> entries;
    std::vector<Block> blocks;
};

/// Reads TOML; `file` names it in messages. Throws InputError if the text is not TOML (with line and column), if a key
/// is given twice or is longer than any of floes (with line and key), and as refuse_what_cannot_be_held() does.
Document parse_document(std::string_view text, const std::string& file);

/// Reads "key=value" of a command line option. A value that is not TOML is taken as text, so that field.far_end=open
/// needs no quotes. `option` ("--set") begins the message. Throws InputError if there is no "=", if the text is not
/// UTF-8, and as refuse_what_cannot_be_held() does.
Entry parse_override(const std::string& override_text, const std::string& option);

// Limits of a text, checked before it is parsed: beyond them toml++ would run out of memory or stack.

/// Enough for 100,000 cases of ten keys each, or for 500,000 poses.
inline constexpr std::size_t longest_text = 64 << 20;  // bytes

/// Throws InputError, beginning with `where`, for a text longer than longest_text, for more values than fit into memory
/// (toml++ needs about 150 bytes for each), and for a key of too many parts: toml++ makes a table of each part and
/// destroys them by recursion.
void refuse_what_cannot_be_held(std::string_view text, const std::string& where);

}  // namespace floes
