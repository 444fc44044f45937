#include "keys/document.hpp"

#include <algorithm>
#include <cctype>

#include <fmt/format.h>

#include "core/error.hpp"
#include "core/text.hpp"
#include "keys/key.hpp"

namespace floes {

namespace {

constexpr std::size_t longest_path = 200;  // bytes; ours have 40 at most

/// `where` begins the message.
template <class Where>
void refuse_long_path(const std::string& path, const Where& where) {
    if (path.size() > longest_path)
        throw InputError(fmt::format("{}: {}... is a key of more than {} characters, and none of floes", where(),
                                     text_literal(beginning(path, 20)), longest_path));
}

Value to_value(const toml::node& node) {
    if (const auto* boolean = node.as_boolean()) return {boolean->get()};
    if (const auto* integer = node.as_integer()) return {integer->get()};
    if (const auto* number = node.as_floating_point()) return {number->get()};
    if (const auto* text = node.as_string()) return {text->get()};
    if (const auto* array = node.as_array()) {
        std::vector<Value> values;
        for (const toml::node& item : *array) values.emplace_back(to_value(item));
        return {std::move(values)};
    }
    if (node.is_table()) return {Value::Strange{"a table"}};
    return {Value::Strange{"a date or time"}};
}

/// An entry with its position in the text.
struct Placed {
    Entry entry;
    toml::source_position at;
};

/// Walks a toml++ document, which is sorted by name, and keeps the positions that restore the order of the text.
class Flattener {
  public:
    explicit Flattener(const std::string& file) : file_(file) {}

    /// Entries of a table and the tables in it. Arrays of tables become blocks, except inside a block.
    std::vector<Entry> entries_of(const toml::table& table, bool in_block) {
        std::vector<Placed> placed;
        collect(table, "", in_block, placed);
        std::ranges::stable_sort(placed, {},
                                 [](const Placed& item) { return std::pair(item.at.line, item.at.column); });
        std::vector<Entry> entries;
        for (Placed& item : placed) entries.push_back(std::move(item.entry));
        return entries;
    }

    std::vector<Block> take_blocks() {
        std::ranges::stable_sort(blocks_, {}, [](const PlacedBlock& item) { return item.line; });
        std::vector<Block> blocks;
        for (PlacedBlock& item : blocks_) blocks.push_back(std::move(item.block));
        return blocks;
    }

  private:
    struct PlacedBlock {
        Block block;
        toml::source_index line;
    };

    void collect(const toml::table& table, const std::string& prefix, bool in_block, std::vector<Placed>& placed) {
        for (const auto& [key, node] : table) {
            const std::string path = prefix + std::string(key.str());
            const toml::source_position at = key.source().begin;
            refuse_long_path(path, [&] { return where(at); });
            const toml::table* inner = node.as_table();
            const toml::array* array = node.as_array();
            if (inner != nullptr && !inner->empty()) {
                collect(*inner, path + ".", in_block, placed);
            } else if (array != nullptr && !in_block && array->is_array_of_tables()) {
                for (const toml::node& item : *array) add_block(path, *item.as_table());
            } else {
                placed.push_back(
                    {{path, inner ? Value{Value::Strange{"an empty table"}} : to_value(node), where(at)}, at});
            }
        }
    }

    void add_block(const std::string& path, const toml::table& table) {
        const toml::source_position at = table.source().begin;
        blocks_.push_back({{path, where(at), entries_of(table, true)}, at.line});
    }

    std::string where(const toml::source_position& at) const { return fmt::format("{}:{}", file_, at.line); }

    const std::string& file_;
    std::vector<PlacedBlock> blocks_;
};

/// The name of the last [table] at or above a line (counted from 1), with a dot; empty when there is none.
std::string table_above(std::string_view text, toml::source_index line) {
    std::string name;
    for (toml::source_index number = 1; number <= line && !text.empty(); ++number) {
        const std::size_t end = std::min(text.find('\n'), text.size());
        const std::string_view here = text.substr(0, end);
        text.remove_prefix(std::min(end + 1, text.size()));
        const std::size_t open = here.find_first_not_of(" \t");
        if (open == std::string_view::npos || here[open] != '[') continue;
        const std::size_t first = here.find_first_not_of("[ \t", open);
        const std::size_t close = here.find_first_of("] \t", first);
        if (first == std::string_view::npos || close == std::string_view::npos) continue;
        name = std::string(here.substr(first, close - first)) + ".";
    }
    return name;
}

/// toml++ says "…: cannot redefine existing integer 'thickness_m'"; the rest of its messages say what it expected.
InputError syntax_error(const toml::parse_error& error, std::string_view text, const std::string& file) {
    const toml::source_position at = error.source().begin;
    std::string description(error.description());
    std::ranges::replace(description, '\n', ' ');
    const std::size_t open = description.find('\'');
    const std::size_t close = description.rfind('\'');
    if (description.find("cannot redefine existing") != std::string::npos && close > open) {
        const bool is_table = description.find("table header") != std::string::npos;
        const std::string name = description.substr(open + 1, close - open - 1);
        if (is_table) return InputError(fmt::format("{}:{}: [{}] is given twice; keep one", file, at.line, name));
        return InputError(
            fmt::format("{}:{}: {}{} is given twice; keep one", file, at.line, table_above(text, at.line), name));
    }
    constexpr std::string_view prefix = "Error while ";
    if (description.starts_with(prefix)) description.erase(0, prefix.size());
    return InputError(fmt::format("{}:{}:{}: this is not TOML ({})", file, at.line, at.column, description));
}

std::string trimmed(std::string_view text) {
    const std::size_t first = text.find_first_not_of(" \t");
    if (first == std::string_view::npos) return "";
    return std::string(text.substr(first, text.find_last_not_of(" \t") - first + 1));
}

}  // namespace

Document parse_document(std::string_view text, const std::string& file) {
    refuse_what_cannot_be_held(text, file);
    try {
        const toml::table table = toml::parse(text, file);
        Flattener flattener(file);
        Document document;
        document.entries = flattener.entries_of(table, false);
        document.blocks = flattener.take_blocks();
        return document;
    } catch (const toml::parse_error& error) {
        throw syntax_error(error, text, file);
    }
}

Entry parse_override(const std::string& override_text, const std::string& option) {
    const std::string where = option + " " + override_text;
    const std::size_t equals = override_text.find('=');
    const std::string path = trimmed(std::string_view(override_text).substr(0, equals));
    if (equals == std::string::npos || path.empty()) {
        throw InputError(fmt::format("{}: this is not key=value; write {} general.iterations=50", where, option));
    }
    refuse_long_path(path, [&] { return option; });
    const std::string value = trimmed(std::string_view(override_text).substr(equals + 1));
    refuse_what_cannot_be_held(value, option + " " + path);
    try {
        const toml::table table = toml::parse("value = " + value);
        const bool alone = table.size() == 1;  // a line break could smuggle in a second key
        if (alone) return {path, to_value(*table.get("value")), where};
    } catch (const toml::parse_error&) {
        // Not TOML: a bare word.
    }
    if (!is_utf8(path) || !is_utf8(value))
        throw InputError(fmt::format("{}: this is not text in UTF-8, as configurations are", option));
    return {path, {value}, where};
}

std::string to_text(const Value& value) {
    constexpr std::size_t most = 60;
    constexpr std::size_t longest = 200;
    struct Writer {
        std::string operator()(bool boolean) const { return boolean ? "true" : "false"; }
        std::string operator()(std::int64_t integer) const { return fmt::format("{}", integer); }
        std::string operator()(double number) const { return number_literal(number); }
        std::string operator()(const std::string& text) const {
            return text.size() <= longest ? text_literal(text) : text_literal(beginning(text, most)) + "...";
        }
        std::string operator()(const Value::Strange& strange) const { return strange.kind; }
        std::string operator()(const std::vector<Value>& values) const {
            std::string text = "[";
            for (const Value& item : values) {
                if (text.size() > most) return text + ", ...]";
                text += (text.size() > 1 ? ", " : "") + to_text(item);
            }
            return text + "]";
        }
    };
    return std::visit(Writer{}, value.data);
}

namespace {

constexpr std::ptrdiff_t most_values = 4'000'000;
constexpr int most_parts = 16;  // of a dotted key; ours have three at most

bool is_quote(char character) {
    return character == '"' || character == '\'';
}

bool is_of_key(char character) {
    return std::isalnum(static_cast<unsigned char>(character)) || character == '_' || character == '-' ||
           character == ' ' || character == '\t';
}

/// Scans a text just far enough to tell strings and comments from the rest.
class Scan {
  public:
    explicit Scan(std::string_view text) : text_(text) {
        if (text_.starts_with("\xEF\xBB\xBF")) at_ = 3;  // byte order mark
        while (at_ < text_.size()) step();
    }

    /// The most parts of a dotted key; a number with a point counts as two.
    int most_parts() const { return most_; }

  private:
    void step() {
        const char character = text_[at_];
        if (character == '#') {
            at_ = std::min(text_.find('\n', at_), text_.size());
            return;
        }
        if (is_quote(character)) return skip_string(character);
        parts_ = character == '.' ? parts_ + 1 : is_of_key(character) ? parts_ : 1;
        most_ = std::max(most_, parts_);
        ++at_;
    }

    /// A one-line string ends with its line at the latest; without a closing quote the text is not TOML anyway.
    void skip_string(char quote) {
        const char quotes[]{quote, quote, quote};
        const std::string_view three(quotes, 3);
        const bool many_lines = text_.substr(at_, 3) == three;
        for (at_ += many_lines ? 3 : 1; at_ < text_.size(); ++at_) {
            if (quote == '"' && text_[at_] == '\\') {
                ++at_;
            } else if (many_lines && text_.substr(at_, 3) == three) {
                at_ = std::min(text_.find_first_not_of(quote, at_),
                               text_.size());  // the string itself may end with quotes
                return;
            } else if (!many_lines && (text_[at_] == quote || text_[at_] == '\n')) {
                ++at_;
                return;
            }
        }
    }

    std::string_view text_;
    std::size_t at_ = 0;
    int parts_ = 1;
    int most_ = 1;
};

}  // namespace

void refuse_what_cannot_be_held(std::string_view text, const std::string& where) {
    if (text.size() > longest_text)
        throw InputError(
            fmt::format("{}: a text of {} bytes is too long; allowed: {} bytes; take fewer cases, poses or values",
                        where, text.size(), longest_text));
    const auto values = std::ranges::count(text, ',') + std::ranges::count(text, '\n');
    if (values > most_values)
        throw InputError(fmt::format(
            "{}: a text with {} lines and commas has more values than can be held; allowed: {}; take fewer cases, "
            "poses or values",
            where, values, most_values));
    if (const int parts = Scan(text).most_parts(); parts > most_parts)
        throw InputError(fmt::format("{}: a key with {} parts between dots is none of floes; ours have three at most",
                                     where, parts));
}

}  // namespace floes
