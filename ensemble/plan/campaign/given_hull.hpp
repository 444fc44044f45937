#pragma once
// A hull that a configuration gives in a CAD file. For this room only.

#include <optional>
#include <string>

#include "campaign/pose_file.hpp"
#include "campaign/read_design.hpp"
#include "scenario/scenario.hpp"

namespace floes {

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

}  // namespace floes
