#include "hydro/rows.hpp"

#include <algorithm>
#include <charconv>
#include <set>

#include "core/error.hpp"
#include "keys/meant.hpp"

namespace floes {

namespace {

constexpr std::string_view blanks = " \t\v\f";

std::vector<std::string_view> words_between(std::string_view line, std::string_view gaps) {
    std::vector<std::string_view> words;
    std::size_t at = 0;
    while ((at = line.find_first_not_of(gaps, at)) != std::string_view::npos) {
        const std::size_t end = std::min(line.find_first_of(gaps, at), line.size());
        words.push_back(line.substr(at, end - at));
        at = end;
    }
    return words;
}

/// Without what Fortran writes and std::from_chars() does not read.
std::string as_in_c(std::string_view text) {
    std::string word(text);
    std::ranges::replace(word, 'D', 'E');
    std::ranges::replace(word, 'd', 'e');
    if (word.starts_with('+') && !word.starts_with("+-")) word.erase(0, 1);
    return word;
}

}  // namespace

std::vector<std::string> words_of(std::string_view line) {
    const std::vector<std::string_view> words = words_between(line, blanks);
    return {words.begin(), words.end()};
}

std::optional<double> number_of(std::string_view text) {
    const std::string word = as_in_c(text);
    double value = 0;
    const auto [rest, error] = std::from_chars(word.data(), word.data() + word.size(), value);
    if (error != std::errc{} || rest != word.data() + word.size()) return {};
    return value;
}

std::optional<std::vector<double>> numbers_of(std::string_view line) {
    std::vector<double> found;
    const std::vector<std::string_view> words = words_between(line, blanks);
    for (const std::string_view word : words) {
        const bool decimal = words.size() > 1 && word.find('.') == std::string_view::npos;
        if (const std::string pointed = decimal ? with_decimal_point(as_in_c(word)) : ""; !pointed.empty()) {
            found.push_back(*number_of(pointed));
            continue;
        }
        for (const std::string_view part : words_between(word, ",")) {
            const std::optional<double> value = number_of(part);
            if (!value) return {};
            found.push_back(*value);
        }
    }
    return found;
}

bool is_title(std::string_view line) {
    const std::vector<std::string_view> words = words_between(line, blanks);
    const auto numbers =
        std::ranges::count_if(words, [](std::string_view word) { return number_of(word).has_value(); });
    return 2 * numbers < std::ssize(words);
}

void refuse_cut_number(std::string_view text, const std::string& file) {
    const std::vector<std::string_view> lines = lines_of(text);
    if (lines.empty() || text.ends_with('\n') || text.ends_with('\r')) return;
    const std::vector<std::string_view> last = words_between(lines.back(), blanks);
    if (last.empty()) return;
    const auto length = [](std::string_view word) {  // behind the point
        const std::size_t point = word.find_first_of(".,");
        return point == std::string_view::npos ? 0 : word.size() - point;
    };
    std::set<std::size_t> lengths;
    int alike = 0;
    for (std::size_t k = 0; k + 1 < lines.size(); ++k) {
        const std::vector<std::string_view> words = words_between(lines[k], blanks);
        if (words.size() != last.size() || !numbers_of(lines[k])) continue;
        lengths.insert(length(words.back()));
        ++alike;
    }
    if (alike > 1 && lengths.size() == 1 && length(last.back()) < *lengths.begin())
        throw InputError("{}:{}: ends within a number, {}; was the file cut off?", file, lines.size(), last.back());
}

}  // namespace floes
