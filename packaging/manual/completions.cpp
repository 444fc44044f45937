// Completions for bash, zsh and fish. Values that are no words of a list are completed as files.

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "command_text.hpp"

namespace floes::manual {

namespace {

/// In single quotes, for bash, zsh and fish.
std::string quoted(const std::string& text, const std::string& quote) {
    std::string out = "'";
    for (const char c : text) out += c == '\'' ? quote : std::string(1, c);
    return out + "'";
}

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

/// A pattern of `case` in bash and zsh: 'laboratory plate' | 'laboratory cantilever'.
std::string inner_pattern(const std::vector<VerbText>& verbs) {
    std::vector<std::string> names;
    for (const VerbText& verb : verbs)
        if (verb.is_inner()) names.push_back(fmt::format("'{}'", verb.name));
    return fmt::format("{}", fmt::join(names, " | "));
}

std::string bash(const std::vector<VerbText>& verbs) {
    std::string values;
    std::string flags;
    std::string inner;
    for (const VerbText& verb : verbs) {
        for (const OptionText& option : verb.options) {
            if (option.positional || !option.takes_value) continue;
            std::vector<std::string> cases;
            for (const std::string& name : option.names) cases.push_back(fmt::format("'{}:{}'", verb.name, name));
            values += fmt::format("        {}) COMPREPLY=({}); return ;;\n", fmt::join(cases, " | "),
                                  option.choices.empty()
                                      ? "$(compgen -f -- \"$word\")"
                                      : fmt::format("$(compgen -W '{}' -- \"$word\")", fmt::join(option.choices, " ")));
        }
        flags += fmt::format("        '{}') COMPREPLY=($(compgen -W '{}' -- \"$word\")) ;;\n", verb.name,
                             fmt::join(flags_of(verb), " "));
        if (!verb.inner.empty())
            inner += fmt::format("        '{}') COMPREPLY=($(compgen -W '{}' -- \"$word\")); return ;;\n", verb.name,
                                 fmt::join(verb.inner, " "));
    }
    return fmt::format(R"(# Completions of floes for bash; made from its command line.
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
{}        esac
        COMPREPLY=($(compgen -f -- "$word"))
    fi
}}
complete -o filenames -F _floes floes
)",
                       inner_pattern(verbs), values, flags, fmt::join(names_of_verbs(verbs), " "), inner);
}

/// A description inside a specification of zsh's _arguments.
std::string bracketed(std::string text) {
    for (const char c : {'\\', '[', ']', ':'})
        for (std::size_t at = text.find(c); at != std::string::npos; at = text.find(c, at + 2))
            text.insert(at, 1, '\\');
    return text;
}

std::string zsh_option(const OptionText& option) {
    const std::string value = !option.takes_value      ? ""
                              : option.choices.empty() ? ":value:_files"
                                                       : fmt::format(":value:({})", fmt::join(option.choices, " "));
    std::string out;
    for (const std::string& name : option.names)
        out += fmt::format(" \\\n            {}",
                           quoted(fmt::format("*{}[{}]{}", name, bracketed(option.description), value), "'\\''"));
    return out;
}

std::string zsh(const std::vector<VerbText>& verbs) {
    std::string descriptions;
    std::string cases;
    for (const VerbText& verb : verbs) {
        std::string options;
        for (const OptionText& option : verb.options)
            if (!option.positional) options += zsh_option(option);
        if (verb.name == "floes") continue;
        if (!verb.is_inner())
            descriptions += fmt::format("        {}\n", quoted(verb.name + ":" + bracketed(verb.description), "'\\''"));
        const std::string words =
            verb.inner.empty() ? "*:file:_files" : fmt::format("1:verb:({})", fmt::join(verb.inner, " "));
        cases += fmt::format("        '{}')\n        _arguments{} \\\n            '{}' ;;\n", verb.name, options, words);
    }
    return fmt::format(R"(#compdef floes
# Completions of floes for zsh; made from its command line.
_floes() {{
    local -a verbs
    verbs=(
{}    )
    if ((CURRENT == 2)); then
        _describe verb verbs
        _arguments '--help' '--version'
        return
    fi
    local verb=$words[2]
    shift words
    ((CURRENT--))
    case "$verb $words[2]" in
        {})
        ((CURRENT > 2)) && verb="$verb $words[2]" && shift words && ((CURRENT--)) ;;
    esac
    case $verb in
{}    esac
}}
_floes "$@"
)",
                       descriptions, inner_pattern(verbs), cases);
}

std::string fish_option(const OptionText& option) {
    std::string out;
    for (const std::string& name : option.names)
        out += name.starts_with("--") ? fmt::format(" -l {}", name.substr(2)) : fmt::format(" -s {}", name.substr(1));
    if (!option.choices.empty()) return fmt::format("{} -x -a '{}'", out, fmt::join(option.choices, " "));
    return out + (option.takes_value ? " -r" : "");
}

/// The condition that the words of a verb stand in the command line.
std::string fish_seen(const std::string& verb) {
    std::vector<std::string> seen;
    for (const std::string& word : CLI::detail::split(verb, ' '))
        seen.push_back(fmt::format("__fish_seen_subcommand_from {}", word));
    return fmt::format("{}", fmt::join(seen, "; and "));
}

/// Where the options of a verb are offered.
std::string fish_place(const VerbText& verb) {
    return verb.name == "floes" ? "-n __fish_use_subcommand" : fmt::format("-n '{}'", fish_seen(verb.name));
}

std::string fish(const std::vector<VerbText>& verbs) {
    std::string out = "# Completions of floes for fish; made from its command line.\n";
    for (const VerbText& verb : verbs) {
        const std::string where = fish_place(verb);
        if (verb.name != "floes") {
            const std::size_t last = verb.name.rfind(' ') + 1;  // 0 without an outer verb
            const std::string before =
                last == 0 ? "__fish_use_subcommand" : fmt::format("'{}'", fish_seen(verb.name.substr(0, last - 1)));
            out += fmt::format("complete -c floes -n {} -f -a {} -d {}\n", before, verb.name.substr(last),
                               quoted(verb.description, "\\'"));
        }
        for (const OptionText& option : verb.options)
            if (!option.positional)
                out += fmt::format("complete -c floes {}{} -d {}\n", where, fish_option(option),
                                   quoted(option.description, "\\'"));
    }
    return out;
}

}  // namespace

std::vector<Page> completions(const std::vector<VerbText>& verbs) {
    return {{"floes.bash", bash(verbs)}, {"_floes", zsh(verbs)}, {"floes.fish", fish(verbs)}};
}

}  // namespace floes::manual
