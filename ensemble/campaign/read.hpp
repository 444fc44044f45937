#pragma once
// From the text of a configuration, and of the files that it names, to a checked campaign.

#include <string>
#include <vector>

#include "campaign/campaign.hpp"
#include "campaign/design.hpp"
#include "keys/document.hpp"
#include "scenario/scenario.hpp"

namespace floes {

/// Gives the text of the file at `path`; throws InputError when it cannot be read.
using LoadFile = std::string (*)(const std::string& path);

/// Floe poses from a CSV file, for example from a tank photograph.
struct PoseFile {
    std::string path;
    std::string columns;     ///< for arrangement.columns: what the header has behind x_m,z_m,yaw_deg
    Value poses;             ///< for arrangement.poses
    std::vector<int> lines;  ///< line of each pose in the file, from 1
};

/// Reads "x_m,z_m,yaw_deg", keys of which each floe has a value of its own, and a line for each floe; blank lines are
/// skipped. `file` names the text in messages. Throws
/// InputError with file, line and what is allowed.
PoseFile read_poses(const std::string& text, const std::string& file);

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
