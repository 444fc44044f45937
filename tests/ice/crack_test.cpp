// A crack takes the energy of its area: the law of a cohesive hinge, and two elements that it holds together.

#include <gtest/gtest.h>

#include <cmath>

#include "ice/failure.hpp"
#include "ice_scene.hpp"

namespace floes::test {
namespace crack_test {

TEST(CohesiveLaw, TakesTheEnergyWhateverThePeak) {
    for (const double peak : {0.002, 0.004, 0.008}) {
        const CohesiveLaw law = cohesive_law(200, peak, 0.01);
        EXPECT_FALSE(law.snaps_back());
        EXPECT_NEAR(law.work(law.open_rotation), 0.01, 1e-12);
        EXPECT_NEAR(law.moment(peak), 200 * peak, 1e-12);
        EXPECT_EQ(law.moment(1.01 * law.open_rotation), 0);
        EXPECT_NEAR(law.mean_moment(0, law.open_rotation), 0.01 / law.open_rotation, 1e-12);
    }
    EXPECT_TRUE(cohesive_law(200, 0.02, 0.01).snaps_back()) << "½ K θ₀² is four times the energy";
    EXPECT_TRUE(cohesive_law(200, 0.002, 0).snaps_back());
}

TEST(Crack, OpensAtOnceWhereTheJointHoldsMoreThanTheCrackTakes) {
    Crack crack(cohesive_law(200, 0.02, 0.01));
    crack.follow(0.0201, 0.1, 0.02);
    EXPECT_TRUE(crack.is_open());
    EXPECT_EQ(crack.sound(), 0);
    EXPECT_NEAR(crack.energy(), 0.5 * 200 * 0.0201 * 0.0201, 1e-12) << "counted as it is";
}

TEST(Crack, DoesNotHealAndGivesBackWhatItStores) {
    Crack crack(cohesive_law(200, 0.002, 0.01));
    crack.follow(0.006, 0, 0.02);
    const double sound = crack.sound();
    EXPECT_NEAR(sound * 200 * 0.006, cohesive_law(200, 0.002, 0.01).moment(0.006), 1e-12);
    crack.follow(0.001, -0.1, 0.02);
    crack.follow(0.0055, 0.0, 0.02);
    EXPECT_EQ(crack.sound(), sound);
}

// The moment of ice that hardly turns on was the rounding of two works: -0.39 of its stiffness in a pile that crept.
TEST(Crack, KeepsTheStiffnessOfItsLawHoweverSlowlyItTurns) {
    const CohesiveLaw law = cohesive_law(200, 0.002, 0.01);
    for (const double rotation : {0.0021, 0.011, 0.0193, law.open_rotation * (1 - 1e-9)}) {
        for (double rate = 1e-3; rate > 1e-19; rate /= 3) {
            Crack crack(law);
            crack.follow(rotation, rate, 0.02);
            if (rate < 1e-8 && rotation < 0.04) {
                EXPECT_NEAR(crack.sound(), law.moment(rotation) / (200 * rotation), 1e-6) << rotation << ", " << rate;
            }
            EXPECT_GT(crack.sound(), 0) << rotation << ", " << rate;
            EXPECT_LE(crack.sound(), 1);
        }
    }
}

struct Parting {
    double element;
    double time_step;
};

class ElementsThatPart : public testing::TestWithParam<Parting> {};

/// Two heavy elements turn against each other; what they lose until they are free is the crack's energy.
TEST_P(ElementsThatPart, LoseTheEnergyOfTheCrack) {
    const auto [element, time_step] = GetParam();
    Scenario scenario;
    scenario.general.time_step = time_step;
    scenario.water.added_mass_from = WaterFrom::share;
    scenario.floe = {.length = 2 * element, .breadth = element, .element = element};
    scenario.ice.density = 3e7 * std::pow(0.2 / element, 3);  // some six times the energy of the crack
    scenario.ice.fracture_energy = 1.5;
    scenario.joint.damping_ratio = 0;
    WorldDefinition definition{.time_step = time_step, .gravity = 0, .solver = SolverKind::direct};
    definition.contact = scenario.contact_law();
    World world(definition);
    IceField ice(world, scenario, floes_at(scenario, std::vector<PlanarPose>{{0, 0, 0.4}}));
    const double rate = 0.01;  // rad/s of each
    const double inertia = element_mass(scenario) * (element * element / 12 + 0.033 * 0.033 / 12);
    for (const int side : {0, 1}) {
        BodyState state = world.state(ice.elements()[static_cast<std::size_t>(side)].body);
        const double way = side == 0 ? -1 : 1;
        state.angular_velocity = state.rotation * Vec3(0, 0, way * rate);
        state.velocity = state.rotation * Vec3(0, rate * element / 2, 0);  // the pivot stays where it is
        world.place(ice.elements()[static_cast<std::size_t>(side)].body, state);
    }
    const auto kinetic = [&] {
        double sum = 0;
        for (const IceElement& one : ice.elements()) {
            const BodyState state = world.state(one.body);
            const Vec3 turning = state.rotation.transpose() * state.angular_velocity;
            sum +=
                0.5 * inertia * turning.z() * turning.z() + 0.5 * element_mass(scenario) * state.velocity.squaredNorm();
        }
        return sum;
    };
    const double before = kinetic();
    int steps = 0;
    while (ice.live_joints() > 0 && ++steps < 10000) {
        world.step();
        ice.break_joints(world, steps * time_step);
    }
    ASSERT_EQ(ice.broken_floes(), 1);
    const double crack = 1.5 * element * 0.033;
    ASSERT_GT(before, 3 * crack);
    EXPECT_NEAR((before - kinetic()) / crack, 1, 0.05);
    EXPECT_NEAR(ice.fracture_work() / crack, 1, 0.05);
    EXPECT_EQ(ice.breaks().front().mode, FailureMode::bending);
}

INSTANTIATE_TEST_SUITE_P(Ice, ElementsThatPart,
                         testing::Values(Parting{0.2, 0.02}, Parting{0.2, 0.01}, Parting{0.2, 0.0025},
                                         Parting{0.1, 0.02}, Parting{0.1, 0.005}, Parting{0.05, 0.02}));

/// Two light elements, so that what is loaded is their joint.
class TwoElements {
  public:
    TwoElements(double averaging, double fracture_energy)
        : scenario_(scenario(averaging, fracture_energy)),
          world_(definition(scenario_)),
          ice_(world_, scenario_, floes_at(scenario_, std::vector<PlanarPose>{{0, 0, 0.4}})) {}

    /// A step with a moment and a pull, in shares of what cracks the ice: whether they part.
    bool part(double bent, double pulled = 0) {
        const double strength = scenario_.ice.bending_strength;  // tensile as well
        load_joint(world_, ice_.elements()[0].body, ice_.elements()[1].body, Vec3(0.1, 0, 0),
                   Vec3(pulled * strength * 0.2 * 0.033, 0, 0), Vec3(0, 0, bent * strength * 0.2 * 0.033 * 0.033 / 6));
        world_.step();
        return ice_.break_joints(world_, 0) > 0;
    }

    const IceField& ice() const { return ice_; }

  private:
    static Scenario scenario(double averaging, double fracture_energy) {
        Scenario made;
        made.water.added_mass_from = WaterFrom::share;
        made.floe = {.length = 0.4, .breadth = 0.2, .element = 0.2};
        made.ice.density = 1;
        made.ice.fracture_energy = fracture_energy;
        made.joint.averaging = averaging;
        return made;
    }
    static WorldDefinition definition(const Scenario& scenario) {
        WorldDefinition made{.time_step = scenario.general.time_step, .gravity = 0, .solver = SolverKind::direct};
        made.contact = scenario.contact_law();
        return made;
    }

    Scenario scenario_;
    World world_;
    IceField ice_;
};

/// Steps after which two elements part that a moment bends, in shares of the strength by turns; -1: never.
int parts_after(double averaging, double first_share, double second_share) {
    TwoElements two(averaging, 0);
    for (int step = 1; step <= 20; ++step)
        if (two.part(step % 2 == 1 ? first_share : second_share)) return step;
    return -1;
}

TEST(Averaging, LetsStressThatLastsCrackAndBlowsByTheirMean) {
    EXPECT_EQ(parts_after(0.02, 1.1, 1.1), 1) << "one step";
    EXPECT_EQ(parts_after(0.02, 1.6, 0), 1);
    EXPECT_EQ(parts_after(0.02, 0.9, 0.9), -1);
    EXPECT_EQ(parts_after(0.04, 1.1, 1.1), 2) << "two steps, of which that before the first was without load";
    EXPECT_EQ(parts_after(0.04, 1.6, 0), -1);
    EXPECT_EQ(parts_after(0.04, 2.4, 0), 1);
    EXPECT_EQ(parts_after(0.08, 1.6, 0.8), 4);
}

TEST(ToughIce, IsPulledApartAtItsTensileStrengthBeforeItCracksAndWhileItDoes) {
    for (const bool cracked : {false, true}) {
        TwoElements two(0.02, 15);
        EXPECT_EQ(two.part(cracked ? 1.1 : 0.9), false);
        EXPECT_EQ(two.ice().cracked_floes(), cracked ? 1 : 0);
        for (int step = 0; step < 5; ++step) EXPECT_FALSE(two.part(0, 0.9)) << cracked;
        EXPECT_TRUE(two.part(0, 1.1)) << cracked;
        ASSERT_EQ(two.ice().breaks().size(), 1U);
        EXPECT_EQ(two.ice().breaks().front().mode, FailureMode::tension);
    }
}

}  // namespace crack_test
}  // namespace floes::test
