// The same bits whatever ran before, between or beside.

#include <gtest/gtest.h>

#include <thread>
#include <vector>

#include "scene.hpp"

namespace floes::test {
namespace determinism_test {

/// A cone driven into rows of joined pairs that lie close together before a wall; some joints are taken out on the way.
class Crowd {
  public:
    Crowd(SolverKind solver, int rows) : world_(weightless(solver)) {
        world_.add_structure(std::vector<ConvexSolid>{Frustum{-0.443, 0.171, 0.122, 0.736}}, {Vec3(-0.7, 0, 0)});
        world_.add_fixed_box({Vec3(0.1, 0.1, 2), {Vec3(rows * 0.402 + 0.12, 0, 0), Quat::Identity()}});
        for (int row = 0; row < rows; ++row) {
            for (int i = -2; i <= 2; ++i) add_pair({row * 0.402 + 0.1, 0, i * 0.203}, row * 5 + i + 2);
        }
    }

    /// Puts a row of elements far away; pushed, they run into each other and part again.
    void add_bystanders(double push) {
        for (int i = 0; i < 8; ++i) {
            const BodyId body = world_.add_element(element_at({50 + 0.205 * i, 0, 0}));
            if (i % 2 == 0) world_.apply(body, {Vec3(push, 0, 0), Vec3::Zero()});
        }
    }

    void step() {
        ++steps_;
        world_.move_structure({{-0.7 + steps_ * 0.01, 0, 0}});
        for (const BodyId body : bodies_) {  // a spring to the water's surface
            const BodyState state = world_.state(body);
            world_.apply(
                body, {Vec3(0, -400 * state.position.y() - 5 * state.velocity.y(), 0), -0.05 * state.angular_velocity});
        }
        world_.step();
        if (steps_ == 30) {
            for (std::size_t i = 0; i < joints_.size(); i += 3) {
                world_.remove_joint(joints_[i]);
                world_.set_piece(bodies_[2 * i], 1000 + static_cast<int>(i));
            }
        }
    }

    std::vector<BodyState> states() const {
        std::vector<BodyState> result;
        for (const BodyId body : bodies_) result.push_back(world_.state(body));
        return result;
    }

  private:
    void add_pair(const Vec3& first, int piece) {
        const Vec3 pitch(element_side, 0, 0);
        bodies_.push_back(world_.add_element(element_at(first, Quat::Identity(), piece)));
        bodies_.push_back(world_.add_element(element_at(first + pitch, Quat::Identity(), piece)));
        joints_.push_back(world_.add_joint(
            {bodies_[bodies_.size() - 2], bodies_.back(), first + pitch / 2, Quat::Identity(), 0.016, 0.8}));
    }

    World world_;
    std::vector<BodyId> bodies_;
    std::vector<JointId> joints_;
    int steps_ = 0;
};

class WorldDeterminism : public testing::TestWithParam<SolverKind> {
  protected:
    static std::vector<BodyState> run(int rows);
};

std::vector<BodyState> WorldDeterminism::run(int rows) {
    Crowd crowd(GetParam(), rows);
    for (int step = 0; step < 80; ++step) crowd.step();
    return crowd.states();
}

void expect_same(const std::vector<BodyState>& a, const std::vector<BodyState>& b) {
    ASSERT_EQ(a.size(), b.size());
    for (std::size_t i = 0; i < a.size(); ++i) EXPECT_TRUE(same_bits(a[i], b[i])) << "element " << i;
}

TEST_P(WorldDeterminism, DoesNotDependOnWhatRanBefore) {
    const auto first = run(4);
    ASSERT_GT((first.front().position - Vec3(0.1, 0, -0.406)).norm(), 0.01) << "the crowd must have been pushed";
    run(2);
    expect_same(run(4), first);
}

TEST_P(WorldDeterminism, DoesNotDependOnWhatRunsBetween) {
    const auto alone = run(3);
    Crowd crowd(GetParam(), 3);
    Crowd other(GetParam(), 2);
    for (int step = 0; step < 80; ++step) {
        crowd.step();
        other.step();
    }
    expect_same(crowd.states(), alone);
}

TEST_P(WorldDeterminism, DoesNotDependOnWhatRunsBeside) {
    const auto alone = run(3);
    std::vector<BodyState> beside[2];
    {
        std::jthread one([&] { beside[0] = run(3); });
        std::jthread two([&] { beside[1] = run(3); });
    }
    expect_same(beside[0], alone);
    expect_same(beside[1], alone);
}

// Contacts that come and go elsewhere scramble the list of contacts; the order of the solve must not follow it.
TEST_P(WorldDeterminism, DoesNotDependOnContactsElsewhere) {
    const auto crowd_beside = [](double push) {
        Crowd crowd(GetParam(), 4);
        crowd.add_bystanders(push);
        for (int step = 0; step < 120; ++step) crowd.step();
        return crowd.states();
    };
    expect_same(crowd_beside(40), crowd_beside(0));
}

INSTANTIATE_TEST_SUITE_P(Of, WorldDeterminism,
                         testing::Values(SolverKind::stock, SolverKind::lanes, SolverKind::direct));

}  // namespace determinism_test
}  // namespace floes::test
