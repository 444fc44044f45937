#include "hydro/rows.hpp"

#include <algorithm>
#include <charconv>
#include <string>

namespace floes {

std::optional<std::vector<double>> numbers_of(std::string_view line) {
    std::vector<double> found;
    std::size_t at = 0;
    while ((at = line.find_first_not_of(" \t\r,", at)) != std::string_view::npos) {
        const std::size_t end = std::min(line.find_first_of(" \t\r,", at), line.size());
        std::string word(line.substr(at, end - at));
        std::ranges::replace(word, 'D', 'E');
        std::ranges::replace(word, 'd', 'e');
        if (word.front() == '+') word.erase(0, 1);
        double value = 0;
        const auto [rest, error] = std::from_chars(word.data(), word.data() + word.size(), value);
        if (error != std::errc{} || rest != word.data() + word.size()) return std::nullopt;
        found.push_back(value);
        at = end;
    }
    return found;
}

std::vector<std::string_view> lines_of(std::string_view text) {
    std::vector<std::string_view> lines;
    while (!text.empty()) {
        const std::size_t end = std::min(text.find('\n'), text.size());
        lines.push_back(text.substr(0, end));
        text.remove_prefix(std::min(end + 1, text.size()));
    }
    return lines;
}

int turns_of(int i, int j) {
    return (i >= 3 ? 1 : 0) + (j >= 3 ? 1 : 0);
}

}  // namespace floes
