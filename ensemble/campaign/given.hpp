#pragma once
// Floe poses from a CSV file, for example from a tank photograph.

#include <cstdint>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "campaign/design.hpp"
#include "keys/document.hpp"
#include "scenario/scenario.hpp"

namespace floes {

/// Gives the text of the file at `path`; throws InputError when it cannot be read.
using LoadFile = std::string (*)(const std::string& path);

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

/// The axes of a design that a CSV file lists: keys in its first line, a point in each other one. As [[design.axis]]
/// blocks with a value for each point. `file` names the text in messages. Throws InputError with file and line.
std::vector<Block> read_points(const std::string& text, const std::string& file);

// A hull that a configuration gives in a CAD file. For this module only.

class GivenHull {
  public:
    /// As GivenPoses: `configuration` is the file beside which hulls lie, `load_file` nullptr where none can be read.
    GivenHull(std::string configuration, LoadFile load_file)
        : configuration_(std::move(configuration)), load_file_(load_file) {}

    /// Loads hull.file, where there is one, into the shape's convex pieces. `label` names the case in messages. Throws
    /// InputError.
    void resolve(Scenario& scenario, const Origins& origins, const std::string& label);

  private:
    std::string configuration_;
    LoadFile load_file_;
    std::optional<HullFile> cut_;  ///< the last file, as it was given
    Structure pieces_;             ///< of it
};

// Outlines of floes that a configuration gives in a file. For this module only.

class GivenOutlines {
  public:
    /// As GivenPoses: `configuration` is the file beside which files of outlines lie, `load_file` nullptr where none
    /// can be read.
    GivenOutlines(std::string configuration, LoadFile load_file)
        : configuration_(std::move(configuration)), load_file_(load_file) {}

    /// Loads shapes.file, where there is one, into the outlines. `label` names the case in messages. Throws InputError.
    void resolve(Scenario& scenario, const Origins& origins, const std::string& label);

  private:
    std::string configuration_;
    LoadFile load_file_;
    std::string read_path_;  ///< the last file, as it was given
    LengthUnit read_unit_ = LengthUnit::m;
    std::optional<TracedOutlines> read_;  ///< of it
};

// Poses that a configuration gives, in itself or in a CSV file. For this module only.

class GivenPoses {
  public:
    /// `configuration`: the file beside which files of poses lie. `load_file`: nullptr where none can be read.
    GivenPoses(std::string configuration, LoadFile load_file)
        : configuration_(std::move(configuration)), load_file_(load_file) {}

    /// Loads arrangement.file, where there is one, into the poses. `label` names the case in messages.
    std::optional<PoseFile> resolve(Scenario& scenario, const Origins& origins, const std::string& label) const;

    /// Given poses are input: what make_arrangement() would refuse in every member is refused here, with its place.
    void refuse_faults(const Scenario& scenario, const std::optional<PoseFile>& file, const Origins& origins,
                       const std::string& label);

  private:
    std::string configuration_;
    LoadFile load_file_;
    std::set<std::uint64_t> looked_at_;  ///< geometries
};

}  // namespace floes
