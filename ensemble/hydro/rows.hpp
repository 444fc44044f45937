#pragma once
// Words and numbers of the texts that other programs write, whose lines are those of lines_of().

#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "core/error.hpp"
#include "keys/csv.hpp"

namespace floes {

std::vector<std::string> words_of(std::string_view line);

/// As Fortran writes it too, 1.0D+00; nothing for another word.
std::optional<double> number_of(std::string_view word);

/// The numbers of a line, divided by blanks, tabs or commas; nothing if a word is none. In a line of several words a
/// comma within one is a decimal comma.
std::optional<std::vector<double>> numbers_of(std::string_view line);

/// Whether a line is a title: most of its words are no numbers.
bool is_title(std::string_view line);

/// Throws InputError where a text without a line end at its end stops within a number: its last row has the form of the
/// others, whose last numbers have all as many digits behind the point, and its own has fewer.
void refuse_cut_number(std::string_view text, const std::string& file);

/// Calls use(row, number of the line, wrong) for each row of numbers below a title, if there is one. `wrong` makes the
/// error of the row, of what fmt::format() takes, and says what a row is to be: `form`.
template <class Use>
void for_each_row(std::string_view text, const std::string& file, std::string_view form, const Use& use) {
    refuse_cut_number(text, file);
    std::size_t number = 0;
    for (const std::string_view line : lines_of(text)) {
        ++number;
        const auto wrong = [&]<class... Values>(fmt::format_string<Values...> what, Values&&... values) {
            return InputError("{}:{}: {}; {}", file, number, fmt::format(what, std::forward<Values>(values)...), form);
        };
        const std::optional<std::vector<double>> row = numbers_of(line);
        if (row ? row->empty() : number == 1 && is_title(line)) continue;
        if (!row) throw wrong("has a word that is no number");
        use(*row, number, wrong);
    }
}

/// Which lines gave what. A file may give a thing again as it was, and not with another value.
template <class Thing, class Value>
class GivenOnce {
  public:
    /// Notes what a line gives. The line that gave the same thing another value; nothing if none did.
    std::optional<std::size_t> other_line(const Thing& thing, const Value& value, std::size_t line) {
        const auto [found, is_new] = given_.try_emplace(thing, value, line);
        if (is_new || found->second.first == value) return {};
        return found->second.second;
    }

  private:
    std::map<Thing, std::pair<Value, std::size_t>> given_{};
};

}  // namespace floes
