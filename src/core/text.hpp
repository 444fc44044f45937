#pragma once
// What every text of floes is.

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace floes {

/// Whether a text is UTF-8: without overlong forms, surrogates, and letters cut off.
bool is_utf8(std::string_view text);

/// Whether a text begins as UTF-16 does: with its byte order mark, or with a zero beside a letter.
bool is_utf16(std::string_view text);

/// The text within HTML, XML or an attribute of theirs.
std::string markup_escaped(std::string_view text);

/// The first bytes of a text, `most` or so many fewer that no letter is cut apart.
std::string_view beginning(std::string_view text, std::size_t most);

/// Whether a file's name ends so, in letters of any case: "states.CSV" with ".csv".
bool has_ending(std::string_view file, std::string_view ending);

/// A name that people gave, as part of a file's name: without "/" and control characters, and not too long for one.
std::string in_a_file_name(std::string name);

/// Blanks for control characters, so that it stays in its line.
std::string in_one_line(std::string text);

/// A number rounded to so many significant digits.
double to_digits(double value, int digits);

/// With small letters, of ASCII.
std::string lower(std::string_view text);

/// Puts `by` in the place of every `what`.
void replace_all(std::string& text, std::string_view what, std::string_view by);

/// Without outer blanks.
std::string_view trimmed(std::string_view text, std::string_view blanks = " \t");

// Counts and durations in words, the same wherever the program says them.

/// "1 member", "3 members": nouns that take an s.
std::string counted(std::int64_t count, std::string_view noun);

/// A duration in s to the whole unit that a clock shows: "42 s", "15 min", "3 h 20 min", "2 d 5 h".
std::string duration_text(double seconds);

/// A duration in s to three figures of one unit: "2.5 ms", "31.3 s", "67.9 min", "17.2 h", "183 d".
std::string duration_in_figures(double seconds);

// Names of cases in a message. A design may have thousands.

/// "E30, E60, E200"; of many the first ones, and how many there are: "p000, p001, p002 … (320 in all)".
inline std::string name_list(const std::vector<std::string>& names) {
    constexpr std::size_t most = 12;
    constexpr std::size_t first = 3;
    if (names.size() <= most) return fmt::format("{}", fmt::join(names, ", "));
    return fmt::format("{} … ({} in all)", fmt::join(std::span(names).first(first), ", "), names.size());
}

// Words of commands that the program names, for people to copy.

/// The word as a shell takes it for one: "a.h5", "'my file.h5'".
std::string shell_word(const std::string& word);

}  // namespace floes
