#pragma once
// The first page of a campaign: one table of its cases and their figures with intervals and differences to the base
// case, the sentence that people quote, and what to type for figures that are not known yet.

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "findings/evidence.hpp"
#include "tables/section.hpp"

namespace floes {

struct PageOne {
    /// A row a case; of a design, the points with the least and the largest mean load. For programs "answer".
    Section table{};
    std::optional<Section> lines = {};  ///< of moorings
    std::string sentence;               ///< empty without a result
    /// What gives figures that are not known, or not well enough: what it does, and the command.
    std::vector<std::pair<std::string, std::string>> next{};
};

/// What a command calls the configuration of a campaign with this title: TITLE.toml where that is in this folder, else
/// CONFIG.toml, since no file says which it was.
std::string configuration_word(const std::string& title);

/// Figures are the design values of the structure, mean load and broken floes: of structures that give way mooring
/// force, offset, tension of lines over their break load and yaw; of others the largest averaged load. Design values
/// are those of Evidence::design_request. Reads the file of structures that give way.
PageOne find_page_one(Evidence& evidence);

}  // namespace floes
