#pragma once
// From the fields that keys bind to text: a configuration file, the reference, a comparison.

#include <map>
#include <span>
#include <string>
#include <vector>

#include "keys/key.hpp"

namespace floes {

/// A sentence about each table of keys, by its name.
using TableTitles = std::map<std::string, std::string>;

enum class Comments { none, all };

/// "[table]" and "name = value" lines in the order of the keys, with the meaning and the allowed values of each key if
/// requested.
std::string write_tables(std::span<const Key> keys, const TableTitles& titles, Comments comments);

/// A section with a Markdown table for each table of keys: key, default (the fields' present values), allowed, meaning,
/// source.
std::string reference_markdown(std::span<const Key> keys, const TableTitles& titles);

/// "path = exact value" lines, sorted by path: equal exactly when all fields are.
std::string canonical_text(std::span<const Key> keys);

/// "general.iterations: 50 there, 20 here" for each key whose fields differ; of long lists and texts the first
/// difference. Both lists describe values of one type.
std::vector<std::string> key_differences(std::span<const Key> there, std::span<const Key> here);

}  // namespace floes
