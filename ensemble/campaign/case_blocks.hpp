#pragma once
// From the [[case]] blocks of a document to one block for each case, the points of a design put in. For this module
// only.

#include <cstdint>
#include <string>
#include <vector>

#include "campaign/campaign.hpp"
#include "campaign/design.hpp"
#include "keys/document.hpp"

namespace floes {

struct CaseBlock {
    Block block;            ///< entries of the [[case]], and those of the axes at the point
    std::string name;       ///< of the case; empty where a design without a [[case]] gives the names
    std::size_t given = 0;  ///< number of the [[case]] that it comes from
    std::string base = {};  ///< name of that [[case]], where a point was added to it
    int point = -1;
};

/// The [[case]] blocks; without any, an empty one named `fallback`, or "" in a design. Throws InputError for blocks
/// that a configuration does not have, and for names that are missing, not plain or given twice.
std::vector<CaseBlock> given_cases(const Document& document, const std::string& fallback, const std::string& file,
                                   const Design& design);

/// Throws InputError when `entry`, which sets `path`, sets an axis.
void refuse_axis(const Entry& entry, const Origins& axes);

/// Each case at each point of the design; the cases as they are without a design, and where they say their
/// design.point. `axes`: where each axis is given. Throws InputError for a case that sets an axis itself, and for
/// more cases than most_cases, or more values of axes than can be held.
std::vector<CaseBlock> at_points(std::vector<CaseBlock> given, const Design& design, const Origins& axes,
                                 std::uint64_t seed, const std::string& file);

/// Throws InputError for more members than the master of a campaign can hold.
void refuse_members(std::size_t cases, int arrangements, const std::string& file);

/// Throws InputError when two cases of a design have one name or are one point, some case is at no point, or some
/// point has no case.
void check_points(const Campaign& campaign, const std::string& file);

}  // namespace floes
