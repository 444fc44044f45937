#include "keys/text_limits.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>

#include "core/error.hpp"

namespace floes {
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
