#pragma once
// The arrangement with the largest load.

#include "findings/evidence.hpp"
#include "tables/section.hpp"

namespace floes {

/// How its floes lay at the start and which of them broke. Empty where no member is done, and where the page has
/// pictures of it. Reads the file.
Section largest_load_section(Evidence& evidence);

}  // namespace floes
