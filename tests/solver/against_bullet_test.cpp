// One step in lanes against the same step of Bullet's own solver, and every lane width against every other.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "core/error.hpp"
#include "solver/bullet_scene.hpp"
#include "solver/lane_width.hpp"

namespace floes::testing {
namespace against_bullet_test {

struct Outcome {
    std::vector<SolverState> states;
    std::vector<std::array<double, 6>> pushes;
    std::vector<SolverReaction> reactions;
    std::vector<SolverContact> contacts;
};

Outcome solve_in_lanes(const BulletScene& scene, std::span<btPersistentManifold*> manifolds, int width) {
    LaneSystem system = scene.lane_system(width);
    Outcome outcome;
    outcome.contacts = scene.contacts(manifolds);
    system.solve(outcome.contacts, scene.law(), {BulletScene::iterations});
    for (std::size_t i = 0; i < system.body_count(); ++i) {
        outcome.pushes.push_back(system.push(i));
    }
    system.advance();
    for (std::size_t i = 0; i < system.body_count(); ++i) outcome.states.push_back(system.state(i));
    for (std::size_t i = 0; i < system.joint_count(); ++i) outcome.reactions.push_back(system.reaction(i));
    return outcome;
}

/// Steps, and solves the last step in lanes of each width as well.
std::vector<Outcome> step_in_lanes(BulletScene& scene, int steps, const std::vector<int>& widths) {
    for (int i = 1; i < steps; ++i) scene.step();
    std::vector<Outcome> outcomes;
    scene.solver.before = [&](std::span<btPersistentManifold*> manifolds) {
        for (const int width : widths) outcomes.push_back(solve_in_lanes(scene, manifolds, width));
    };
    scene.step();
    scene.solver.before = nullptr;
    return outcomes;
}

double largest(const btVector3& v) {
    return std::max({std::abs(v.x()), std::abs(v.y()), std::abs(v.z())});
}

/// Largest difference over largest value.
class Deviation {
  public:
    void add(const std::array<double, 3>& ours, const btVector3& theirs) {
        size_ = std::max(size_, largest(theirs));
        difference_ = std::max(difference_, largest(btVector3(ours[0], ours[1], ours[2]) - theirs));
    }
    void add(double ours, double theirs) {
        size_ = std::max(size_, std::abs(theirs));
        difference_ = std::max(difference_, std::abs(ours - theirs));
    }
    double relative() const { return difference_ / size_; }

  private:
    double size_ = 0;
    double difference_ = 0;
};

/// Poses of a step without a push: those are the caller's to apply.
void expect_same_poses(const BulletScene& scene, const Outcome& lanes) {
    Deviation position, rotation;
    for (std::size_t i = 0; i < scene.bodies.size(); ++i) {
        const btTransform& pose = scene.bodies[i]->getWorldTransform();
        if (scene.bodies[i]->isStaticOrKinematicObject()) continue;
        position.add(lanes.states[i].position, pose.getOrigin());
        for (int k = 0; k < 9; ++k) {
            rotation.add(lanes.states[i].rotation[static_cast<std::size_t>(k)], pose.getBasis()[k / 3][k % 3]);
        }
    }
    EXPECT_LT(position.relative(), 1e-14);
    EXPECT_LT(rotation.relative(), 1e-14);
}

void expect_same_step(const BulletScene& scene, const Outcome& lanes) {
    Deviation velocity, angular_velocity, force, moment, impulse, friction;
    for (std::size_t i = 0; i < scene.bodies.size(); ++i) {
        velocity.add(lanes.states[i].velocity, scene.bodies[i]->getLinearVelocity());
        angular_velocity.add(lanes.states[i].angular_velocity, scene.bodies[i]->getAngularVelocity());
    }
    for (std::size_t i = 0; i < scene.joints.size(); ++i) {
        const btJointFeedback& feedback = *scene.feedback[i];
        const btMatrix3x3& frame = scene.joints[i]->getCalculatedTransformA().getBasis();
        const btTransform& offset = scene.joints[i]->getFrameOffsetA();
        const btVector3 arm = frame * (offset.getOrigin() * offset.getBasis());
        force.add(lanes.reactions[i].force, feedback.m_appliedForceBodyA * frame);
        moment.add(lanes.reactions[i].moment,
                   (feedback.m_appliedTorqueBodyA - arm.cross(feedback.m_appliedForceBodyA)) * frame);
    }
    std::size_t at = 0;
    for (const btPersistentManifold* manifold : scene.manifolds()) {
        for (int i = 0; i < manifold->getNumContacts(); ++i, ++at) {
            impulse.add(lanes.contacts[at].impulse, manifold->getContactPoint(i).m_appliedImpulse);
            friction.add(lanes.contacts[at].friction_impulse, manifold->getContactPoint(i).m_appliedImpulseLateral1);
        }
    }
    EXPECT_GT(at, 10u);
    EXPECT_LT(velocity.relative(), 1e-9);
    EXPECT_LT(angular_velocity.relative(), 1e-9);
    EXPECT_LT(force.relative(), 1e-9);
    EXPECT_LT(moment.relative(), 1e-9);
    EXPECT_LT(impulse.relative(), 1e-9);
    EXPECT_LT(friction.relative(), 1e-9);
}

const std::vector<int> widest{lane_widths().back()};

TEST(AgainstBullet, SameVelocitiesReactionsAndImpulses) {
    for (const double cfm : {1e-10, 0.016}) {
        SCOPED_TRACE(cfm);
        BulletScene scene({.cfm = cfm});
        const std::vector<Outcome> lanes = step_in_lanes(scene, 70, widest);
        expect_same_step(scene, lanes[0]);
        expect_same_poses(scene, lanes[0]);
    }
}

TEST(AgainstBullet, BrokenJointsCarryNothing) {
    BulletScene scene({});
    for (std::size_t i = 0; i < scene.joints.size(); i += 5) scene.joints[i]->setEnabled(false);
    const std::vector<Outcome> lanes = step_in_lanes(scene, 70, widest);
    expect_same_step(scene, lanes[0]);
    for (std::size_t i = 0; i < scene.joints.size(); i += 5) {
        EXPECT_THAT(lanes[0].reactions[i].force, ::testing::Each(0.0));
        EXPECT_THAT(lanes[0].reactions[i].moment, ::testing::Each(0.0));
    }
}

TEST(AgainstBullet, FarTwistedJoints) {
    BulletScene scene({});
    for (int i = 0; i < 60; ++i) scene.step();
    for (std::size_t i = 0; i < scene.bodies.size() - 2; ++i) {
        const auto k = static_cast<double>(i);
        btTransform pose = scene.bodies[i]->getWorldTransform();
        pose.setRotation(btQuaternion(std::sin(k), 0.7 * std::cos(3 * k), 1.2 * std::sin(2 * k)) * pose.getRotation());
        scene.bodies[i]->setCenterOfMassTransform(pose);
        scene.bodies[i]->setAngularVelocity({3 * std::cos(k), 2 * std::sin(k), 4 * std::sin(7 * k)});
    }
    const std::vector<Outcome> lanes = step_in_lanes(scene, 1, widest);
    expect_same_step(scene, lanes[0]);
    expect_same_poses(scene, lanes[0]);
}

TEST(AgainstBullet, DeepPenetrationsPushPositionsOnly) {
    BulletScene scene({.split_depth = 0.0005});
    const std::vector<Outcome> lanes = step_in_lanes(scene, 70, widest);
    expect_same_step(scene, lanes[0]);
    // Bullet moves a body by its push before it moves it by its velocity: what is left over is the push.
    Deviation push;
    for (std::size_t i = 0; i < scene.bodies.size(); ++i) {
        if (scene.bodies[i]->isStaticOrKinematicObject()) continue;
        const std::array<double, 6>& ours = lanes[0].pushes[i];
        const btVector3 moved = scene.bodies[i]->getWorldTransform().getOrigin() - scene.before_step[i].getOrigin();
        push.add({ours[0], ours[1], ours[2]}, moved / BulletScene::time_step - scene.bodies[i]->getLinearVelocity());
    }
    EXPECT_LT(push.relative(), 1e-9);
}

TEST(LaneWidths, GiveTheSameBits) {
    BulletScene scene({.split_depth = 0.0005});
    for (std::size_t i = 0; i < scene.joints.size(); i += 7) scene.joints[i]->setEnabled(false);
    const std::vector<Outcome> lanes = step_in_lanes(scene, 70, lane_widths());
    ASSERT_EQ(lanes.size(), lane_widths().size());
    for (const Outcome& other : lanes) {
        for (std::size_t i = 0; i < other.states.size(); ++i) {
            EXPECT_EQ(other.states[i].position, lanes[0].states[i].position);
            EXPECT_EQ(other.states[i].rotation, lanes[0].states[i].rotation);
            EXPECT_EQ(other.states[i].velocity, lanes[0].states[i].velocity);
            EXPECT_EQ(other.states[i].angular_velocity, lanes[0].states[i].angular_velocity);
        }
        EXPECT_EQ(other.pushes, lanes[0].pushes);
        for (std::size_t i = 0; i < other.reactions.size(); ++i) {
            EXPECT_EQ(other.reactions[i].force, lanes[0].reactions[i].force);
            EXPECT_EQ(other.reactions[i].moment, lanes[0].reactions[i].moment);
        }
        for (std::size_t i = 0; i < other.contacts.size(); ++i) {
            EXPECT_EQ(other.contacts[i].impulse, lanes[0].contacts[i].impulse);
            EXPECT_EQ(other.contacts[i].friction_impulse, lanes[0].contacts[i].friction_impulse);
        }
    }
}

TEST(LaneWidths, NoMoreLanesThanEqualFloes) {
    EXPECT_EQ(BulletScene({.floes = 1}).lane_system(lane_widths().back()).width(), 1);
    EXPECT_EQ(BulletScene({.floes = 2}).lane_system(2).width(), 2);
}

TEST(LaneWidths, WhereJointsAreSolvedDirectlyUnequalFloesFillAllLanes) {
    const int all = lane_widths().back();
    const std::vector<SolverBody> bodies(5, {.inverse_mass = 1, .inverse_inertia = {6, 6, 6}});
    std::vector<SolverJoint> joints(3);  // of two bodies, and of three
    for (const std::uint32_t i : {0U, 1U, 2U}) {
        joints[i].a = i > 0 ? i + 1 : 0;
        joints[i].b = joints[i].a + 1;
    }
    EXPECT_EQ(LaneSystem(bodies, joints, all, SolverKind::lanes).width(), 1);
    EXPECT_EQ(LaneSystem(bodies, joints, all, SolverKind::direct).width(), all);
}

TEST(LaneWidths, UnknownWidthIsRefused) {
    EXPECT_THROW(lane_kernels(3), RunError);
}

}  // namespace against_bullet_test
}  // namespace floes::testing
