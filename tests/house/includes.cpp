#include "house/includes.hpp"

#include <algorithm>
#include <fstream>
#include <regex>
#include <sstream>

namespace floes::house {

std::vector<Include> includes_of(const std::string& text) {
    static const std::regex include{R"(\s*#\s*include\s*([<"])([^>"]+)[>"].*)"};
    std::vector<Include> all;
    std::istringstream lines{text};
    int number = 0;
    for (std::string line; std::getline(lines, line);) {
        ++number;
        std::smatch match;
        if (std::regex_match(line, match, include)) all.push_back({number, match[2].str(), match[1].str() == "<"});
    }
    return all;
}

std::string room_of(const std::string& path) {
    static const std::regex shape{"(?:src/|ensemble/(?:[a-z]+/)?)?([^/]+)/[^/]+"};
    std::smatch match;
    return std::regex_match(path, match, shape) ? match[1].str() : std::string{};
}

std::string text_of(const std::filesystem::path& file) {
    std::ostringstream text;
    text << std::ifstream{file}.rdbuf();
    return text.str();
}

std::vector<Source> sources_of(const std::filesystem::path& project) {
    std::vector<Source> sources;
    for (const char* top : {"src", "ensemble"}) {
        for (const auto& entry : std::filesystem::recursive_directory_iterator(project / top)) {
            const std::string kind = entry.path().extension().string();
            if (kind != ".hpp" && kind != ".cpp") continue;
            const std::string path = std::filesystem::relative(entry.path(), project).generic_string();
            sources.push_back({path, text_of(entry.path())});
        }
    }
    std::ranges::sort(sources, {}, &Source::path);
    return sources;
}

}  // namespace floes::house
