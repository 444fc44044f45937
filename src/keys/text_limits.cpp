#include "keys/text_limits.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>

#include "core/error.hpp"

namespace floes {
namespace {

constexpr std::ptrdiff_t most_values = 4'000'000;
constexpr int most_parts = 16;  // of a dotted key; ours have three at most

/// Where the string that begins at `at` ends. A string of one line ends with its line at the latest: what follows is
/// not TOML then.
std::size_t end_of_string(std::string_view text, std::size_t at) {
    const char quote = text[at];
    const std::string three(3, quote);
    const bool many_lines = text.substr(at, 3) == three;
    for (at += many_lines ? 3 : 1; at < text.size(); ++at) {
        if (quote == '"' && text[at] == '\\') {
            ++at;
        } else if (many_lines && text.substr(at, 3) == three) {
            at += 3;
            while (at < text.size() && text[at] == quote) ++at;  // quotes may stand just before the end
            return at;
        } else if (!many_lines && (text[at] == quote || text[at] == '\n')) {
            return at + 1;
        }
    }
    return text.size();
}

/// The most parts of a dotted key; a number with a point counts as two.
int parts_of_keys(std::string_view text) {
    const auto of_key = [](unsigned char c) {
        return std::isalnum(c) || c == '_' || c == '-' || c == ' ' || c == '\t';
    };
    int most = 1;
    int parts = 1;
    for (std::size_t at = 0; at < text.size();) {
        const char character = text[at];
        if (character == '#') {
            at = std::min(text.find('\n', at), text.size());
        } else if (character == '"' || character == '\'') {
            at = end_of_string(text, at);
        } else {
            parts = character == '.' ? parts + 1 : of_key(static_cast<unsigned char>(character)) ? parts : 1;
            most = std::max(most, parts);
            ++at;
        }
    }
    return most;
}

}  // namespace

void refuse_what_cannot_be_held(std::string_view text, const std::string& where) {
    if (text.size() > longest_text)
        throw InputError(
            fmt::format("{}: a text of {} bytes is too long; allowed: {} bytes", where, text.size(), longest_text));
    const auto values = std::ranges::count(text, ',') + std::ranges::count(text, '\n');
    if (values > most_values)
        throw InputError(
            fmt::format("{}: a text with {} lines and commas has more values than can be held; allowed: {}", where,
                        values, most_values));
    const int parts = parts_of_keys(text);
    if (parts > most_parts)
        throw InputError(fmt::format("{}: a key with {} parts between dots is none of floes; ours have three at most",
                                     where, parts));
}

}  // namespace floes
