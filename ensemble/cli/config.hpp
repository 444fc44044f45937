#pragma once
// The one place that opens configuration files and the files of other programs.

#include <string>
#include <vector>

#include "campaign/campaign.hpp"

namespace floes {

/// The whole of a file, of at most 64 MiB. Throws InputError when it cannot be read.
std::string read_bytes(const std::string& path);

/// The text of a file. Throws InputError when it cannot be read or has other things in it.
std::string read_text(const std::string& path);

/// Where a configuration lies: `name` itself, or, if there is no such file and `name` is a word such as "smoke", the
/// installed configuration of that name, if there is one.
std::string find_config(const std::string& name);

/// Reads and checks the campaign of the configuration find_config(`name`), with "key=value" overrides (--set). Throws
/// InputError.
Campaign load_campaign(const std::string& name, const std::vector<std::string>& overrides);

/// The campaign's case of that name, or its only one where none is named. Throws InputError if there is none.
const Case& chosen_case(const Campaign& campaign, const std::string& name);

}  // namespace floes
