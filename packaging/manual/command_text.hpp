#pragma once
// The command line as data, read from CLI11's app: what --help says, for manual pages and completions.

#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace floes::manual {

struct OptionText {
    std::vector<std::string> names;  ///< "-o", "--output"; one name without dashes if it is given by its place
    std::string values;              ///< what follows the names in --help: "TEXT:{none,process}", "Needs: --resume"
    std::string description;
    std::vector<std::string> choices;  ///< the values allowed, if they are words
    std::string group;                 ///< what is said of the options that it belongs to; mostly nothing
    bool takes_value;
    bool positional;
};

struct VerbText {
    std::string name;  ///< "run", "laboratory plate"; "floes" for the program itself
    std::string description;
    std::string usage;  ///< "floes run [OPTIONS] config"
    std::string footer;
    std::vector<OptionText> options;
    std::vector<std::string> inner;  ///< of "laboratory": "plate", "cantilever"

    bool is_inner() const { return name.find(' ') != std::string::npos; }
};

/// The program first, then each verb, followed by its inner verbs. Verbs of earlier versions are left out.
std::vector<VerbText> verbs_of(const CLI::App& program);

/// Files by their names, relative to the folder they are installed in.
struct Page {
    std::string name;
    std::string text;
};

/// floes.1 and floes-VERB.1. `version` and `date` (YYYY-MM-DD) stand at the foot of each page.
std::vector<Page> man_pages(const std::vector<VerbText>& verbs, const std::string& version, const std::string& date);

/// floes.bash, _floes (zsh) and floes.fish.
std::vector<Page> completions(const std::vector<VerbText>& verbs);

}  // namespace floes::manual
