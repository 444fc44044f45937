#include "house/names.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <map>
#include <regex>
#include <set>

namespace floes::house {
namespace {

/// Without comments, texts, characters and the parameters of templates.
std::string bare(const std::string& text) {
    static const std::regex noise{
        R"re(//[^\n]*|/\*[^]*?\*/|R"([a-z]*)\([^]*?\)\1"|"(?:\\.|[^"\\\n])*"|'(?:\\.|[^'\\\n])+')re"};
    std::string left = std::regex_replace(text, noise, " ");
    static const std::regex parameters{R"(template\s*<)"};
    std::smatch match;
    while (std::regex_search(left, match, parameters)) {
        auto at = static_cast<std::size_t>(match.position());
        std::size_t end = at + static_cast<std::size_t>(match.length());
        for (int depth = 1; depth > 0 && end < left.size(); ++end)
            depth += left[end] == '<' ? 1 : left[end] == '>' ? -1 : 0;
        left.erase(at, end - at);
    }
    return left;
}

/// What a brace belongs to.
struct Scope {
    bool is_namespace = false;
    std::string name;  ///< of a namespace; empty if it has none
};

}  // namespace

std::vector<std::string> classes_of(const std::string& text) {
    static const std::regex token{
        R"(\bnamespace\s*([\w:]*)\s*\{|\b(?:enum\s+class|enum|class|struct)\s+(?:\[\[[^\]]*\]\]\s*)?(\w+)(?:\s+final)?\s*(?::(?!:)[^;{}()]*)?\{|\{|\})"};
    const std::string code = bare(text);
    std::vector<Scope> scopes;
    std::vector<std::string> classes;
    for (auto at = std::sregex_iterator(code.begin(), code.end(), token); at != std::sregex_iterator(); ++at) {
        const std::string word = at->str();
        if (word == "}") {
            if (!scopes.empty()) scopes.pop_back();
        } else if (word.starts_with("namespace")) {
            scopes.push_back({true, (*at)[1].str()});
        } else {
            std::string full;
            bool open = (*at)[2].matched;
            for (const Scope& one : scopes) {
                open = open && one.is_namespace && !one.name.empty();
                full += one.name + "::";
            }
            if (open) classes.push_back(full + (*at)[2].str());
            scopes.push_back({});
        }
    }
    return classes;
}

std::vector<std::string> shared_names(const std::vector<Source>& sources) {
    std::map<std::string, std::set<std::string>> units;
    for (const Source& file : sources)
        for (const std::string& name : classes_of(file.text))
            units[name].insert(file.path.substr(0, file.path.rfind('.')));
    std::vector<std::string> sentences;
    for (const auto& [name, where] : units)
        if (where.size() > 1)
            sentences.push_back(fmt::format("{} is a class of {}", name, fmt::join(where, " and of ")));
    return sentences;
}

}  // namespace floes::house
