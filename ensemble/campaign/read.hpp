#pragma once
// From the [[case]] blocks of a document to one block for each case, the points of a design put in. For this module
// only.

#include <cstdint>
#include <string>
#include <vector>

#include "campaign/campaign.hpp"
#include "campaign/design.hpp"
#include "campaign/given.hpp"
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

/// Each case at each point of the design; the cases as they are without a design, and where they say their
/// design.point. `axes`: where each axis is given. Throws InputError for a case that sets an axis itself, and for more
/// cases than most_cases, or more values of axes than can be held.
std::vector<CaseBlock> at_points(std::vector<CaseBlock> given, const Design& design, const Origins& axes,
                                 std::uint64_t seed, const std::string& file);

/// Throws InputError for more members than the master of a campaign can hold.
void refuse_members(std::size_t cases, int arrangements, const std::string& file);

/// Throws InputError when `entry`, which sets `path`, sets an axis.
void refuse_axis(const Entry& entry, const Origins& axes);

/// Throws InputError when two cases of a design have one name or are one point, some case is at no point, or some
/// point has no case.
void check_points(const Campaign& campaign, const std::string& file);

// From the text of a configuration to a checked campaign.

/// The longest text of a configuration or of poses, bytes.
inline constexpr std::size_t longest_configuration = longest_text;

/// Where a campaign is read from.
struct CampaignSource {
    std::string text;                    ///< TOML
    std::string file;                    ///< names the text in messages; its stem is the campaign's name
    std::vector<std::string> overrides;  ///< "key=value" pairs (--set), applied last; of two for one key the later one
    /// Not stored by write_campaign(): only present keys are allowed, and given poses are checked floe by floe.
    bool from_user = false;
    bool without_design = false;  ///< [design] and its axes are left out: the cases as they are without
};

/// Reads and checks a campaign. Throws InputError, one sentence: file, line, key, value, what is allowed, and the
/// nearest known key; for contradictions the keys involved. From a user, a campaign whose resolved text could not be
/// read again is refused, too. Overrides "case.NAME.key=value" are for one case; an override of a key that cases set
/// themselves is refused. `load_file` reads the pose files that arrangement.file names (its path is relative to
/// `file`), since nothing below the command line opens files; it may be null where there are none. A design's points
/// become cases: "E60+p003" is the case E60 at point 3. Cases that have a design.point already (as write_campaign()
/// gives them) are those points.
Campaign read_campaign(const CampaignSource& source, LoadFile load_file);

}  // namespace floes
