// A joint that cracks keeps a share of its stiffness against bending and torsion.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/error.hpp"
#include "world/world.hpp"

namespace floes {
namespace soften_joint_test {

/// Two boxes that a spring holds together, at rest under a couple about the joint's horizontal axis or along it.
class Couple {
  public:
    explicit Couple(SolverKind solver = SolverKind::direct)
        : world_({.time_step = 0.02,
                  .gravity = 0,
                  .contact = {.friction = Friction::cone,
                              .normal = NormalLaw::crushing,
                              .crushing_pressure = 1e5,
                              .internal_edges = false},
                  .solver = solver}) {
        for (const double x : {-0.1, 0.1}) {
            bodies_.push_back(world_.add_element({.corners = corners_of(0.1, 0.1),
                                                  .half_thickness = 0.0165,
                                                  .mass = 1.2,
                                                  .pose = {{x, 0, 0}, Quat::Identity()},
                                                  .piece = 0}));
        }
        const JointSpring spring{{1e6, 1e5, 1e6}, {200, 300, 200}, 1};
        joint_ = world_.add_joint({.a = bodies_[0],
                                   .b = bodies_[1],
                                   .cfm = 0.1,
                                   .spring = solver == SolverKind::direct ? std::optional(spring) : std::nullopt});
    }

    /// Angle between the boxes about an axis, rad, after the couple has acted for a while.
    double angle(const Vec3& couple) {
        for (int step = 0; step < 400; ++step) {
            world_.apply(bodies_[0], {Vec3::Zero(), -couple});
            world_.apply(bodies_[1], {Vec3::Zero(), couple});
            world_.step();
        }
        const Mat3 between = world_.state(bodies_[0]).rotation.transpose() * world_.state(bodies_[1]).rotation;
        return 0.5 * Vec3(between(2, 1) - between(1, 2), between(0, 2) - between(2, 0), between(1, 0) - between(0, 1))
                         .dot(couple.normalized());
    }

    World& world() { return world_; }
    JointId joint() const { return joint_; }

  private:
    World world_;
    std::vector<BodyId> bodies_;
    JointId joint_{0};
};

TEST(SoftenJoint, LeavesThatShareOfBendingAndTorsionAndAllOfTheRest) {
    for (const Vec3& axis : {Vec3(0, 0, 1), Vec3(1, 0, 0)}) {
        Couple couple;
        EXPECT_NEAR(couple.angle(0.5 * axis), 0.5 / 200, 1e-6);
        couple.world().soften_joint(couple.joint(), 0.25);
        EXPECT_NEAR(couple.angle(0.5 * axis), 0.5 / 50, 1e-5);
    }
    Couple in_plane;
    in_plane.world().soften_joint(in_plane.joint(), 0.25);
    EXPECT_NEAR(in_plane.angle(Vec3(0, 0.5, 0)), 0.5 / 300, 1e-6);
}

TEST(SoftenJoint, RefusesWhatCannotBe) {
    Couple couple;
    EXPECT_THROW(couple.world().soften_joint(couple.joint(), 0), InputError);
    EXPECT_THROW(couple.world().soften_joint(couple.joint(), 1.5), InputError);
    Couple swept(SolverKind::lanes);
    EXPECT_THROW(swept.world().soften_joint(swept.joint(), 0.5), InputError);
}

}  // namespace soften_joint_test
}  // namespace floes
