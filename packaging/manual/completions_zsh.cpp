// The completion for zsh.

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "completion_source.hpp"

namespace floes::manual {
namespace {

/// A description inside a specification of zsh's _arguments.
std::string bracketed(std::string text) {
    for (const char c : {'\\', '[', ']', ':'})
        for (std::size_t at = text.find(c); at != std::string::npos; at = text.find(c, at + 2))
            text.insert(at, 1, '\\');
    return text;
}

std::string zsh_files(Source source) {
    const std::vector<std::string> of = endings(source);
    return of.empty() ? "_files" : fmt::format("_files -g \"*.({})(-.)\"", fmt::join(of, "|"));
}

/// The action of _arguments that offers the values of an option.
std::string zsh_values(const OptionText& option) {
    switch (source_of(option)) {
        case Source::words:
            return fmt::format("({})", fmt::join(option.choices, " "));
        case Source::keys:
            return "_floes_keys";
        case Source::cases:
            return "_floes_cases";
        default:
            return zsh_files(source_of(option));
    }
}

constexpr const char* zsh_sources = R"sh(
_floes_keys() {{ compadd -S '' -- {} }}
_floes_cases() {{
    local file=${{words[(r)*.h5]}}
    [[ -r $file ]] && compadd -- ${{(f)"$(floes {})"}}
}}
)sh";

std::string zsh_option(const OptionText& option) {
    const std::string value = option.takes_value ? ":value:" + zsh_values(option) : "";
    std::string out;
    for (const std::string& name : option.names)
        out += fmt::format(" \\\n            {}",
                           quoted(fmt::format("*{}[{}]{}", name, bracketed(option.description), value), "'\\''"));
    return out;
}

}  // namespace

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
        const std::string words = verb.inner.empty() ? "*:file:" + zsh_files(positional_source(verb))
                                                     : fmt::format("1:verb:({})", fmt::join(verb.inner, " "));
        cases +=
            fmt::format("        '{}')\n        _arguments{} \\\n            '{}' ;;\n", verb.name, options, words);
    }
    const std::string sources = fmt::format(fmt::runtime(zsh_sources), keys_to_set(), print_cases);
    return fmt::format(R"(#compdef floes
# Completions of floes for zsh; made from its command line.{}
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
                       sources, descriptions, inner_pattern(verbs), cases);
}

}  // namespace floes::manual
