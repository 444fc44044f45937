#pragma once
// Poses that a configuration gives, in itself or in a CSV file. For this room only.

#include <cstdint>
#include <optional>
#include <set>
#include <string>

#include "campaign/pose_file.hpp"
#include "campaign/read_design.hpp"
#include "scenario/scenario.hpp"

namespace floes {

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
