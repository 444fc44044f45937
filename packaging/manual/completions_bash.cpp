// The completion for bash.

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "completion_source.hpp"

namespace floes::manual {
namespace {

std::vector<std::string> flags_of(const VerbText& verb) {
    std::vector<std::string> flags;
    for (const OptionText& option : verb.options)
        if (!option.positional) flags.insert(flags.end(), option.names.begin(), option.names.end());
    return flags;
}

std::vector<std::string> names_of_verbs(const std::vector<VerbText>& verbs) {
    std::vector<std::string> names;
    for (std::size_t i = 1; i < verbs.size(); ++i)
        if (!verbs[i].is_inner()) names.push_back(verbs[i].name);
    return names;
}

std::string bash_files(Source source) {
    return fmt::format("_floes_files {}", fmt::join(endings(source), " "));
}

/// The command that offers the values of an option.
std::string bash_values(const OptionText& option) {
    switch (source_of(option)) {
        case Source::words:
            return fmt::format("COMPREPLY=($(compgen -W '{}' -- \"$word\"))", fmt::join(option.choices, " "));
        case Source::keys:
            return "_floes_keys";
        case Source::cases:
            return "_floes_cases";
        default:
            return bash_files(source_of(option));
    }
}

constexpr const char* bash_sources = R"sh(
_floes_files() {{  # with these endings, and folders; without an ending all
    local ending
    mapfile -t COMPREPLY < <(
        if (($# == 0)); then compgen -f -- "$word"; else compgen -d -- "$word"; fi
        for ending; do compgen -f -X "!*.$ending" -- "$word"; done)
}}
_floes_keys() {{
    [[ $(type -t compopt) == builtin ]] && compopt +o filenames -o nospace 2> /dev/null
    COMPREPLY=($(compgen -W '{}' -- "$word"))
}}
_floes_cases() {{
    local file
    for file in "${{COMP_WORDS[@]}}"; do [[ $file == *.h5 && -r $file ]] && break; done
    [[ -r $file ]] || return 0
    local IFS=$'\n'
    compopt +o filenames 2> /dev/null
    mapfile -t COMPREPLY < <(compgen -W "$("${{COMP_WORDS[0]}}" {})" -- "$word")
}}
)sh";

}  // namespace

std::string bash(const std::vector<VerbText>& verbs) {
    std::string positionals;
    std::string values;
    std::string flags;
    std::string inner;
    for (const VerbText& verb : verbs) {
        for (const OptionText& option : verb.options) {
            if (option.positional || !option.takes_value) continue;
            std::vector<std::string> cases;
            for (const std::string& name : option.names) cases.push_back(fmt::format("'{}:{}'", verb.name, name));
            values += fmt::format("        {}) {}; return ;;\n", fmt::join(cases, " | "), bash_values(option));
        }
        flags += fmt::format("        '{}') COMPREPLY=($(compgen -W '{}' -- \"$word\")) ;;\n", verb.name,
                             fmt::join(flags_of(verb), " "));
        if (!endings(positional_source(verb)).empty())
            positionals += fmt::format("        '{}') {}; return ;;\n", verb.name, bash_files(positional_source(verb)));
        if (!verb.inner.empty())
            inner += fmt::format("        '{}') COMPREPLY=($(compgen -W '{}' -- \"$word\")); return ;;\n", verb.name,
                                 fmt::join(verb.inner, " "));
    }
    const std::string sources = fmt::format(fmt::runtime(bash_sources), keys_to_set(), print_cases);
    return fmt::format(R"(# Completions of floes for bash; made from its command line.{}
_floes() {{
    local word=${{COMP_WORDS[COMP_CWORD]}} before=${{COMP_WORDS[COMP_CWORD - 1]}} verb=floes
    ((COMP_CWORD > 1)) && [[ ${{COMP_WORDS[1]}} != -* ]] && verb=${{COMP_WORDS[1]}}
    ((COMP_CWORD > 2)) && case "$verb ${{COMP_WORDS[2]}}" in
        {}) verb+=" ${{COMP_WORDS[2]}}" ;;
    esac
    case $verb:$before in
{}    esac
    if [[ $word == -* ]]; then
        case $verb in
{}        esac
    elif ((COMP_CWORD == 1)); then
        COMPREPLY=($(compgen -W '{}' -- "$word"))
    else
        case $verb in
{}{}        esac
        _floes_files
    fi
}}
complete -o filenames -F _floes floes
)",
                       sources, inner_pattern(verbs), values, flags, fmt::join(names_of_verbs(verbs), " "), inner,
                       positionals);
}

}  // namespace floes::manual
