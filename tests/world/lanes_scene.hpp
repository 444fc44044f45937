#pragma once
// Floes of 3 x 3 elements pushed together by a cone against a fixed sheet, in a World.

#include <vector>

#include "world/scene.hpp"

namespace floes::test {

class LanesScene {
  public:
    /// sides: of a pyramid in place of the cone; 0: the cone itself.
    explicit LanesScene(const WorldDefinition& definition, int floes = 11, int sides = 0);

    /// One step with the cone moving at `speed` m/s and a linear float and drag on every element.
    void step();

    /// Removes every `stride`-th joint and lets its elements collide.
    void break_joints(std::size_t stride);

    World world;
    std::vector<BodyId> elements;
    std::vector<JointId> joints;
    BodyId cone{0};

  private:
    void add_floe(const Pose& pose, int piece);

    static constexpr double speed = 0.5;
    double time_step_;
    int steps_ = 0;
};

}  // namespace floes::test
