#pragma once
// What the completions of all shells have in common: what a value is completed from.

#include <string>
#include <vector>

#include "command_text.hpp"

namespace floes::manual {

/// In single quotes; `quote` is how a single quote is written in them.
std::string quoted(const std::string& text, const std::string& quote);

/// A pattern of `case` in bash and zsh: 'laboratory plate' | 'laboratory cantilever'.
std::string inner_pattern(const std::vector<VerbText>& verbs);

/// What a value is completed from.
enum class Source { words, keys, cases, configurations, campaigns, stored, files };

Source source_of(const OptionText& option);

/// Of what stands for itself on the line of a verb: the first that is a file.
Source positional_source(const VerbText& verb);

/// The endings of the files; empty for any.
std::vector<std::string> endings(Source source);

/// "ice.thickness_m= ice.density_kg_m3= …".
std::string keys_to_set();

/// Arguments of floes that print the names of the cases of $file, a line each, from its status in JSON.
inline constexpr const char* print_cases =
    R"sh(status "$file" --format json 2> /dev/null | sed -n '/^  "cases"/,/^  ]/s/^ *"name": "\(.*\)",$/\1/p')sh";

std::string bash(const std::vector<VerbText>& verbs);
std::string zsh(const std::vector<VerbText>& verbs);
std::string fish(const std::vector<VerbText>& verbs);

}  // namespace floes::manual
