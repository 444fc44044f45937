// The completion for fish.

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <sstream>

#include "completion_source.hpp"

namespace floes::manual {
namespace {

std::string fish_files(Source source) {
    return fmt::format("'(__floes_files {})'", fmt::join(endings(source), " "));
}

constexpr const char* fish_sources = R"sh(
function __floes_files
    set -l word (commandline -ct)
    for file in $word*
        if test -d $file
            echo $file/
        else if contains -- (string match -r '[^.]*$' -- $file) $argv
            echo $file
        end
    end
end
function __floes_keys
    string split ' ' -- '{}'
end
function __floes_cases
    set -l file (string match -- '*.h5' (commandline -opc))[1]
    test -r "$file"; and floes {}
end
)sh";

std::string fish_option(const OptionText& option) {
    std::string out;
    for (const std::string& name : option.names)
        out += name.starts_with("--") ? fmt::format(" -l {}", name.substr(2)) : fmt::format(" -s {}", name.substr(1));
    if (!option.takes_value) return out;
    switch (source_of(option)) {
        case Source::words:
            return fmt::format("{} -x -a '{}'", out, fmt::join(option.choices, " "));
        case Source::keys:
            return out + " -x -a '(__floes_keys)'";
        case Source::cases:
            return out + " -x -a '(__floes_cases)'";
        default:
            return endings(source_of(option)).empty() ? out + " -r" : out + " -x -a " + fish_files(source_of(option));
    }
}

/// The condition that the words of a verb stand in the command line.
std::string fish_seen(const std::string& verb) {
    std::vector<std::string> seen;
    std::istringstream words(verb);
    for (std::string word; words >> word;) seen.push_back(fmt::format("__fish_seen_subcommand_from {}", word));
    return fmt::format("{}", fmt::join(seen, "; and "));
}

/// Where the options of a verb are offered.
std::string fish_place(const VerbText& verb) {
    return verb.name == "floes" ? "-n __fish_use_subcommand" : fmt::format("-n '{}'", fish_seen(verb.name));
}

}  // namespace

std::string fish(const std::vector<VerbText>& verbs) {
    std::string out = "# Completions of floes for fish; made from its command line." +
                      fmt::format(fmt::runtime(fish_sources), keys_to_set(), print_cases);
    for (const VerbText& verb : verbs) {
        const std::string where = fish_place(verb);
        if (verb.name != "floes") {
            const std::size_t last = verb.name.rfind(' ') + 1;  // 0 without an outer verb
            const std::string before =
                last == 0 ? "__fish_use_subcommand" : fmt::format("'{}'", fish_seen(verb.name.substr(0, last - 1)));
            out += fmt::format("complete -c floes -n {} -f -a {} -d {}\n", before, verb.name.substr(last),
                               quoted(verb.description, "\\'"));
        }
        if (!endings(positional_source(verb)).empty())
            out += fmt::format("complete -c floes {} -f -a {}\n", where, fish_files(positional_source(verb)));
        for (const OptionText& option : verb.options)
            if (!option.positional)
                out += fmt::format("complete -c floes {}{} -d {}\n", where, fish_option(option),
                                   quoted(option.description, "\\'"));
    }
    return out;
}

}  // namespace floes::manual
