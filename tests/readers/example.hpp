#pragma once
// A valid example of what others make, how it is read, and the ways in which it is changed.

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <regex>
#include <sstream>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <fmt/format.h>

namespace floes::test {

using Lines = std::vector<std::string>;

/// What is read, as numbers whose order means nothing.
using Numbers = std::vector<double>;

struct Example {
    std::string name;                            ///< "WAMIT .1"
    std::string file;                            ///< by which refusals name it
    Lines lines;                                 ///< of the text
    std::size_t first = 0;                       ///< line of the first row of its table
    std::size_t rows = 0;                        ///< how many lines are rows, whose order means nothing; 0: it has none
    std::pair<std::string, std::string> unit{};  ///< a unit that the text states, and what is none of its kind
    std::function<Numbers(const std::string& text)> read{};
    /// One letter for each of the changes: `=` gives the same numbers, `x` is refused, `?` cannot always be told,
    /// `-` has no meaning here.
    std::string outcomes;
    bool plus = true;  ///< whether numbers may begin with a sign +, as they may not in JSON
};

inline std::string text_of(const Lines& lines, std::string_view end = "\n") {
    std::string text;
    for (const std::string& line : lines) text.append(line).append(end);
    return text;
}

/// `text` with each number that has a point written by `write`.
inline std::string rewritten(const std::string& text, const std::function<std::string(double)>& write) {
    static const std::regex number(R"(([^\w.+-]|^)([-+]?\d+\.\d*(?:[eE][-+]?\d+)?)(?![\w.]))");
    std::string found;
    auto at = text.cbegin();
    for (std::sregex_iterator one(text.begin(), text.end(), number), none; one != none; ++one) {
        found.append(at, (*one)[2].first).append(write(std::stod((*one)[2])));
        at = (*one)[2].second;
    }
    return found.append(at, text.cend());
}

/// The row with a slightly different value in its last number that has a point.
inline std::string with_another_value(const std::string& row) {
    static const std::regex last(R"(([-+]?\d+\.\d*(?:[eE][-+]?\d+)?)(?!.*\d\.))");
    std::smatch found;
    if (!std::regex_search(row, found, last)) return row;
    const double value = std::stod(found[1]);
    return fmt::format("{}{}{}", found.prefix().str(), value + 0.02 * std::max(std::abs(value), 0.05),
                       found.suffix().str());
}

/// A way to change a text, which gives any number of changed ones.
struct Change {
    const char* name;
    std::vector<std::string> (*variants)(const Example& example);
};

namespace changes {

/// The example with the rows that `edit` gives for the index of each.
inline std::vector<std::string> each_row(const Example& example, Lines (*edit)(const std::string& row)) {
    std::vector<std::string> found;
    for (std::size_t row = example.first; row < example.first + example.rows; ++row) {
        Lines lines(example.lines.begin(), example.lines.begin() + static_cast<std::ptrdiff_t>(row));
        for (std::string& line : edit(example.lines[row])) lines.push_back(std::move(line));
        lines.insert(lines.end(), example.lines.begin() + static_cast<std::ptrdiff_t>(row) + 1, example.lines.end());
        found.push_back(text_of(lines));
    }
    return found;
}

inline std::vector<std::string> mark(const Example& example) {
    return {"\xEF\xBB\xBF" + text_of(example.lines)};
}

inline std::vector<std::string> line_ends(const Example& example) {
    std::string last_without = text_of(example.lines);
    last_without.pop_back();
    return {text_of(example.lines, "\r\n"), last_without};
}

inline std::vector<std::string> carriage_returns(const Example& example) {
    return {text_of(example.lines, "\r")};
}

inline std::vector<std::string> blanks(const Example& example) {
    return {text_of(example.lines, "  \n"), text_of(example.lines, "\t\n"), text_of(example.lines) + "\n \n\n"};
}

inline std::vector<std::string> numbers_otherwise(const Example& example) {
    const std::string text = text_of(example.lines);
    std::vector<std::string> found{rewritten(text, [](double x) { return fmt::format("{:.16e}", x); }),
                                   rewritten(text, [](double x) { return fmt::format("{:.16E}", x); })};
    if (example.plus) found.push_back(rewritten(text, [](double x) { return fmt::format("{:+.17g}", x); }));
    return found;
}

inline std::vector<std::string> other_order(const Example& example) {
    Lines lines = example.lines;
    const auto first = lines.begin() + static_cast<std::ptrdiff_t>(example.first);
    const auto end = first + static_cast<std::ptrdiff_t>(example.rows);
    std::reverse(first, end);
    std::vector<std::string> found{text_of(lines)};
    std::rotate(first, first + 1, end);
    found.push_back(text_of(lines));
    return found;
}

inline std::vector<std::string> row_again(const Example& example) {
    return each_row(example, [](const std::string& row) { return Lines{row, row}; });
}

inline std::vector<std::string> row_again_with_another_value(const Example& example) {
    return each_row(example, [](const std::string& row) { return Lines{row, with_another_value(row)}; });
}

inline std::vector<std::string> row_missing(const Example& example) {
    return each_row(example, [](const std::string&) { return Lines{}; });
}

inline std::vector<std::string> row_with_more(const Example& example) {
    return each_row(example, [](const std::string& row) { return Lines{row + " 1.5"}; });
}

inline std::vector<std::string> other_unit(const Example& example) {
    std::string text = text_of(example.lines);
    text.replace(text.find(example.unit.first), example.unit.first.size(), example.unit.second);
    return {text};
}

inline std::vector<std::string> cut_between_lines(const Example& example) {
    std::vector<std::string> found;
    for (std::size_t count = 1; count < example.lines.size(); ++count)
        found.push_back(text_of({example.lines.begin(), example.lines.begin() + static_cast<std::ptrdiff_t>(count)}));
    return found;
}

inline std::vector<std::string> cut_within_a_line(const Example& example) {
    const std::string text = text_of(example.lines);
    std::vector<std::string> found;
    for (std::size_t count = 1; count < text.size(); ++count)
        if (text[count] != '\n' && text[count - 1] != '\n') found.push_back(text.substr(0, count));
    return found;
}

}  // namespace changes

/// In the order of the letters of Example::outcomes. The first six must not matter; the others must be refused, where
/// they can be told.
inline constexpr Change all_changes[]{{"byte order mark", changes::mark},
                                      {"line ends", changes::line_ends},
                                      {"carriage returns alone", changes::carriage_returns},
                                      {"blanks", changes::blanks},
                                      {"numbers written otherwise", changes::numbers_otherwise},
                                      {"rows in another order", changes::other_order},
                                      {"a row again", changes::row_again},
                                      {"a row again, another value", changes::row_again_with_another_value},
                                      {"a row left out", changes::row_missing},
                                      {"a number too many in a row", changes::row_with_more},
                                      {"another unit", changes::other_unit},
                                      {"cut between lines", changes::cut_between_lines},
                                      {"cut within a line", changes::cut_within_a_line}};

std::vector<Example> hydrodynamic_examples();
std::vector<Example> shape_examples();
std::vector<Example> table_examples();

}  // namespace floes::test
