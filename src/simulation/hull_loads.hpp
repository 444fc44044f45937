#pragma once
// What contacts exert on the parts of the structure, and the moments on the whole of it, step by step.
//
// Moments are about the reference point, in the structure's axes and by the right-hand rule: yaw about +y turns
// the bow to port, roll about +x heels to starboard, pitch about +z lifts the bow.

#include <span>
#include <vector>

#include "core/vector.hpp"
#include "shapes/shape.hpp"
#include "statistics/averaged_load.hpp"
#include "statistics/load_statistics.hpp"
#include "world/state.hpp"

namespace floes {

class HullLoads {
  public:
    /// `solids`: as the world has them; `steps` are kept.
    HullLoads(const Shape& shape, std::vector<ConvexSolid> solids, std::size_t steps);

    const std::vector<ConvexSolid>& solids() const { return solids_; }

    /// One step, at the end of which the structure is there. `contacts`: of the structure; `moment`: of them all about
    /// its reference point, in the world's axes.
    void add(std::span<const ContactForce> contacts, BodyId structure, const StructurePose& pose, const Vec3& moment);

    /// For each part; a structure that is one part has none.
    std::vector<PartLoad> parts(const Averaging& how) const;
    Swing yaw() const { return swing_of(yaw_); }
    Swing roll() const { return swing_of(roll_); }
    Swing pitch() const { return swing_of(pitch_); }

    /// The steps so far, saved or set (core/state_archive.hpp).
    void archive(StateArchive& state);

  private:
    std::vector<ConvexSolid> solids_;
    std::vector<ConvexSolid> pieces_;  ///< of which the solids are made, if they are others; of several parts only
    std::vector<PartHistory> parts_;
    std::vector<double> yaw_, roll_, pitch_;
};

}  // namespace floes
