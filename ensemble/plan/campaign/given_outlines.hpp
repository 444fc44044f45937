#pragma once
// Outlines of floes that a configuration gives in a file. For this room only.

#include <optional>
#include <string>

#include "campaign/pose_file.hpp"
#include "campaign/read_design.hpp"
#include "scenario/scenario.hpp"

namespace floes {

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

}  // namespace floes
