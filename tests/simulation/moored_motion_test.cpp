// A structure on its moorings under given loads, against closed forms.

#include "simulation/structure_motion.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "world/world.hpp"

namespace floes {
namespace moored_motion_test {

constexpr double pi = std::numbers::pi;
constexpr double step = 0.02;
const Mat6 still_water = Mat6::Zero();  // which stiffens nothing

/// Of the period of 2 s in surge, 4 s in sway, 1 s in yaw.
Moorings springs(double damping = 0) {
    return {.mass = 1000,
            .gyration = 2,
            .surge = 1000 * pi * pi,
            .sway = 250 * pi * pi,
            .yaw = 16000 * pi * pi,
            .damping = damping};
}

/// A line ahead and one astern, of 50 m, that hold in surge as springs() do and less abeam.
Moorings two_lines(double break_load = 0) {
    Moorings moorings = springs();
    moorings.surge = 0;
    for (const double azimuth : {0.0, pi})
        moorings.lines.push_back({.x = 2 * std::cos(azimuth),
                                  .azimuth = azimuth,
                                  .distance = 50,
                                  .pretension = 5000,
                                  .stiffness = 500 * pi * pi,
                                  .break_load = break_load});
    return moorings;
}

// By cosh(√(-k/m) t), as lines that turn a hull over move one that thrusters hold.
TEST(LinearMotion, RunsAwayFromWhatPushesItOn) {
    const Mat6 stiffness = -Mat6::Identity();
    const LinearMotion yaw({2}, 4 * Mat6::Identity(), Mat6::Zero(), stiffness, 0.1, step);
    MooredState state;
    state.offset[2] = 1;
    yaw.advance(state, Vec6::Zero());
    EXPECT_NEAR(state.offset[2], std::cosh(step / 2), 1e-12);
}

TEST(MooredMotion, SlowLoadMovesItByTheStiffness) {
    for (const Moorings& moorings : {springs(0.3), two_lines()}) {
        Moorings damped = moorings;
        damped.damping = 0.3;
        MooredMotion motion(damped, still_water, step);
        const Vec3 load(-3000, 800, 5000);
        for (int k = 0; k < 20000; ++k) motion.advance(in_plane(load * std::min(1.0, k / 5000.0)), step * (k + 1));
        const Vec3 balanced = motion.restoring() + load;
        EXPECT_NEAR(balanced.norm() / load.norm(), 0, moorings.lines.empty() ? 1e-9 : 2e-5) << "lines: to (ωΔt)²";
        if (moorings.lines.empty()) {
            EXPECT_NEAR(motion.state().offset[0], -3000 / (1000 * pi * pi), 1e-12);
        }
    }
}

// 1 + e^(-πζ/√(1-ζ²)) in each direction, without error at any step.
TEST(MooredMotion, OvershootsAStep) {
    for (const double zeta : {0.0, 0.05, 0.3}) {
        MooredMotion motion(springs(zeta), still_water, step);
        const Vec3 load(1000, -400, 3000);
        Vec3 most = Vec3::Zero();
        for (int k = 0; k < 300; ++k) {
            motion.advance(in_plane(load), step * (k + 1));
            most = most.cwiseMax(motion.state().offset.head<3>().cwiseQuotient(
                load.cwiseQuotient(springs().stiffness().diagonal().head<3>())));
        }
        const double overshoot = 1 + std::exp(-pi * zeta / std::sqrt(1 - zeta * zeta));
        for (int i = 0; i < 3; ++i) EXPECT_NEAR(most[i], overshoot, 2e-3) << zeta << " " << i;
    }
}

// At resonance F/k / (2ζ).
TEST(MooredMotion, ResonatesWithItsDamping) {
    const double zeta = 0.05;
    MooredMotion motion(springs(zeta), still_water, step);
    double most = 0;
    for (int k = 0; k < 100 * 40; ++k) {
        const double load = 100 * (std::sin(pi * step * (k + 1)) - std::sin(pi * step * k)) / (pi * step);
        motion.advance(in_plane({load, 0, 0}), step * (k + 1));
        if (k > 100 * 35) most = std::max(most, std::abs(motion.state().offset[0]));
    }
    EXPECT_NEAR(most / (100 / (1000 * pi * pi)), 1 / (2 * zeta), 0.01 * 10);
}

/// Of motion and springs and two_lines(), J.
double energy(const Moorings& moorings, const MooredState& state) {
    double sum = 0.5 * state.velocity.dot(moorings.inertia() * state.velocity);
    const Vec3 spring(moorings.surge, moorings.sway, moorings.yaw);
    sum += 0.5 * state.offset.head<3>().dot(spring.cwiseProduct(state.offset.head<3>()));
    for (const MooringLine& line : moorings.lines) {
        const LinePull now = pull(moorings, line, state.offset);
        const double longer = (now.anchor - now.fairlead).norm() - line.distance;
        sum += line.pretension * longer + 0.5 * line.stiffness * longer * longer;
    }
    return sum;
}

// The work of the load is the energy of motion, springs and lines; with springs to rounding, with lines to (ωΔt)².
TEST(MooredMotion, KeepsEnergy) {
    for (const Moorings& moorings : {springs(), two_lines()}) {
        MooredMotion motion(moorings, still_water, step);
        double work = 0;
        double most = 0;
        double worst = 0;
        for (int k = 0; k < 5000; ++k) {
            const Vec3 load(900 * std::sin(0.7 * step * k), 300 * std::cos(0.4 * step * k), 700 * std::sin(step * k));
            const Vec6 before = motion.state().offset;
            motion.advance(in_plane(load), step * (k + 1));
            work += in_plane(load).dot(motion.state().offset - before);
            most = std::max(most, energy(moorings, motion.state()));
            worst = std::max(worst, std::abs(energy(moorings, motion.state()) - work));
        }
        EXPECT_LT(worst, (moorings.lines.empty() ? 1e-10 : 1e-4) * most);
    }
}

// b|v|v takes the energy of a free mass as v = v₀ / (1 + b v₀ t / m).
TEST(MooredMotion, QuadraticDampingSlowsIt) {
    Moorings moorings = springs();
    moorings.surge = 1e-6;
    moorings.quadratic[0] = 400;
    MooredMotion motion(moorings, still_water, step);
    motion.place({.velocity = in_plane({2, 0, 0})});
    for (int k = 0; k < 100; ++k) motion.advance(Vec6::Zero(), step * (k + 1));
    EXPECT_NEAR(motion.state().velocity[0], 2 / (1 + 400 * 2.0 * 2 / 1000), 1e-6);
}

/// As springs(), but held by thrusters.
Moorings thrusters(double limit) {
    Moorings moorings{.mass = 1000, .gyration = 2};
    moorings.thrusters = {.gain = springs().stiffness().diagonal().head<3>(), .limit = {limit, 0, 0}};
    return moorings;
}

// Within their limit they are a spring and a damper: 1 + e^(-πζ/√(1-ζ²)), to (ωΔt)².
TEST(MooredMotion, ThrustersHoldAsSpringsAndDampers) {
    for (const double zeta : {0.0, 0.3, 0.7071}) {
        Moorings moorings = thrusters(0);
        moorings.thrusters.damping = zeta;
        for (int i = 0; i < 3; ++i) {  // one by one: with yaw, surge and sway change places
            MooredMotion motion(moorings, still_water, step);
            const Vec3 load = 1000 * Vec3::Unit(i);
            double most = 0;
            for (int k = 0; k < 400; ++k) {
                motion.advance(in_plane(load), step * (k + 1));
                most = std::max(most, motion.state().offset[i] * moorings.thrusters.gain[i] / 1000);
            }
            EXPECT_NEAR(most, 1 + std::exp(-pi * zeta / std::sqrt(1 - zeta * zeta)), 5e-3) << zeta << " " << i;
            EXPECT_EQ(motion.restoring(), Vec3::Zero()) << "springs and lines";
            if (zeta > 0.5) {
                EXPECT_NEAR((motion.thrust() + load).norm() / load.norm(), 0, 0.02);
            }
        }
    }
}

// Under a load beyond their limit the structure is driven off with (F - L)/m: x = (F - L) t² / 2 m, once they are at
// it, whatever they did before.
TEST(MooredMotion, ThrustersGiveWayBeyondTheirLimit) {
    MooredMotion motion(thrusters(600), still_water, step);
    int k = 0;
    while (motion.thrust()[0] > -600 && k < 1000) motion.advance(in_plane({1000, 0, 0}), step * ++k);
    const MooredState from = motion.state();
    ASSERT_LT(k, 1000);
    for (int more = 0; more < 500; ++more) motion.advance(in_plane({1000, 0, 0}), step * ++k);
    const double time = 500 * step;
    EXPECT_NEAR(motion.state().velocity[0], from.velocity[0] + 0.4 * time, 1e-9);
    EXPECT_NEAR(motion.state().offset[0], from.offset[0] + from.velocity[0] * time + 0.2 * time * time, 1e-9);
    EXPECT_EQ(motion.thrust()[0], -600);
}

// A quarter turn to +x: what was +z is now ahead of the bow, where alone there is a limit.
TEST(MooredMotion, ThrustersTurnWithTheStructure) {
    MooredMotion motion(thrusters(600), still_water, step);
    motion.place({.offset = in_plane({0.1, 3, -pi / 2})});
    const Vec3 thrust = motion.thrust();
    EXPECT_EQ(thrust[0], -600);
    EXPECT_NEAR(thrust[1], 0.1 * thrusters(0).thrusters.gain[1], 1e-9);
    motion.advance(Vec6::Zero(), step);
    EXPECT_NEAR(motion.state().velocity[1], -0.6 * step, 1e-3 * step);
    EXPECT_LT(motion.state().velocity[0], 0);
}

// A thrust pushes a hull with a low centre where its mass turns along, as its lines do: at rest it does not trim, since
// load and thrust act on one line.
TEST(MooredMotion, ThrustersPushAHullWithALowCentreAsSpringsDo) {
    Moorings by_springs{.free = {true, false, false, false, true},
                        .mass = 1000,
                        .height = -3,
                        .pitch_gyration = 2,
                        .surge = 500,
                        .damping = 0.3};
    Moorings by_thrusters = by_springs;
    by_thrusters.surge = 0;
    by_thrusters.thrusters = {.gain = {500, 0, 0}, .damping = 0.3};
    Mat6 water = Mat6::Zero();
    water(at(Motion::pitch), at(Motion::pitch)) = 2e4;
    MooredMotion springs_hold(by_springs, water, step);
    MooredMotion thrusters_hold(by_thrusters, water, step);
    const double natural = natural_modes(by_springs, water).front().period;
    for (const NaturalMode& mode : natural_modes(by_thrusters, water)) {
        if (mode.motion == Motion::surge) {
            EXPECT_NEAR(mode.period / natural, 1, 1e-9) << "the gain stiffens it as the spring does";
        }
    }
    double apart = 0;
    for (int k = 0; k < 20000; ++k) {
        for (MooredMotion* motion : {&springs_hold, &thrusters_hold})
            motion->advance(in_plane({300, 0, 0}), step * (k + 1));
        apart = std::max(apart, std::abs(thrusters_hold.state().offset[0] - springs_hold.state().offset[0]));
    }
    EXPECT_LT(apart, 0.05 * 300 / 500) << "springs and thrusters are split otherwise in a step";
    const double of_step = 2 * std::pow(2 * pi / natural * step, 2);  // thrusters act apart from the water
    EXPECT_NEAR(thrusters_hold.state().offset[0] / (300.0 / 500), 1, of_step);
    EXPECT_NEAR(thrusters_hold.state().offset[at(Motion::pitch)], 0, of_step * 300 * 3 / 2e4);
}

/// Energy of a turret's curve with two slopes, J.
double turret_energy(double offset) {
    const double beyond = std::max(0.0, offset - 0.5);
    const double within = std::min(offset, 0.5);
    return 500 * within * within + 500 * beyond + 2000 * beyond * beyond;
}

// The work of the load is the energy of motion and the mooring, to (ωΔt)², with sway and yaw by the turret's arm.
TEST(MooredMotion, TurretKeepsEnergy) {
    Moorings moorings{.mass = 1000, .gyration = 2};
    moorings.turret.curve = {{0, 0}, {0.5, 500}, {1, 2500}};
    moorings.turret.ahead = 1.5;
    MooredMotion motion(moorings, still_water, step);
    const auto energy_now = [&] {
        const MooredState& now = motion.state();
        const Vec2 turret = turned({1.5, 0}, now.offset[2]) - Vec2(1.5, 0) + Vec2(now.offset[0], now.offset[1]);
        return 0.5 * now.velocity.dot(moorings.inertia() * now.velocity) + turret_energy(turret.norm());
    };
    double work = 0;
    double most = 0;
    double worst = 0;
    for (int k = 0; k < 5000; ++k) {
        const Vec3 load(250 * std::sin(0.7 * step * k), 200 * std::cos(0.4 * step * k), 0);
        const Vec6 before = motion.state().offset;
        motion.advance(in_plane(load), step * (k + 1));
        work += in_plane(load).dot(motion.state().offset - before);
        most = std::max(most, energy_now());
        worst = std::max(worst, std::abs(energy_now() - work));
    }
    EXPECT_LT(worst, 1e-3 * most);
    EXPECT_GT(most, turret_energy(0.6)) << "on both slopes";
}

/// A ship on a stiff turret 40 m ahead of its axis.
Moorings turret_ship(double friction = 0) {
    Moorings moorings{.mass = 1e7, .gyration = 30};
    moorings.turret = {.curve = {{0, 0}, {1, 1e9}}, .ahead = 40, .friction = friction};
    return moorings;
}

/// How a ship moves under a load that acts at a point of it this far ahead of its axis.
class Weathervane {
  public:
    Weathervane(const Moorings& moorings, double yaw, double ahead)
        : turret_(moorings.turret.ahead), ahead_(ahead), motion_(moorings, still_water, 0.02) {
        const Vec2 arm = turned({turret_, 0}, yaw);
        motion_.place({.offset = in_plane({turret_ - arm.x(), -arm.y(), yaw})});
    }

    void step(const Vec2& force) {
        const Vec2 arm = turned({ahead_, 0}, yaw());
        const double moment = arm.y() * force.x() - arm.x() * force.y();
        time_ += 0.02;
        motion_.advance(in_plane({force.x(), force.y(), moment}), time_);
    }

    double yaw() const { return motion_.state().offset[2]; }
    double time() const { return time_; }

  private:
    double turret_, ahead_;
    double time_ = 0;
    MooredMotion motion_;
};

// It comes to lie with its turret upstream of where the load acts, wherever the load comes from.
TEST(MooredMotion, AShipLiesWithTheLoad) {
    Moorings moorings = turret_ship();
    moorings.quadratic[at(Motion::yaw)] = 1e12;
    moorings.quadratic[at(Motion::sway)] = 1e6;
    moorings.radiation_damping.assign(6, std::vector<double>(6, 0.0));
    moorings.radiation_damping[5][5] = 5e9;
    for (const double from : {0.0, 0.7, -1.5, 2.8}) {  // towards which the load is against the bow
        Weathervane ship(moorings, 0, -10);
        for (int k = 0; k < 100000; ++k) ship.step(turned({-4e6, 0}, from));
        EXPECT_NEAR(std::remainder(ship.yaw() - from, 2 * pi), 0, 2e-3) << from;
    }
}

// A turn of the drift swings it as a pendulum of I + m a² about the turret: 4 √(I/(F l)) K(sin θ/2), at any angle θ.
TEST(MooredMotion, AShipSwingsAfterATurnOfTheDrift) {
    for (const double turn : {0.2, 1.0, 2.0}) {
        Weathervane ship(turret_ship(), turn, -10);
        while (ship.yaw() > -turn * 0.999 && ship.yaw() > 0) ship.step({-4e6, 0});
        const double quarter =
            std::sqrt((1e7 * 900 + 1e7 * 1600) / (4e6 * 50)) * std::comp_ellint_1(std::sin(turn / 2));
        EXPECT_NEAR(ship.time(), quarter, 0.01 * quarter) << turn;
    }
}

// A turret behind where the load acts lets the ship turn round; friction of the bearing holds it at angles below
// asin(friction / (F l)), where a ship without it comes back.
TEST(MooredMotion, AWeathervaneIsStableWithItsTurretAhead) {
    Weathervane turned_away(turret_ship(), 0.01, 60);
    for (int k = 0; k < 20000 && std::abs(turned_away.yaw()) < 2; ++k) turned_away.step({-4e6, 0});
    EXPECT_GE(std::abs(turned_away.yaw()), 2);
    const double held = std::asin(5e7 / (4e6 * 50));
    for (const double yaw : {0.9 * held, 1.1 * held}) {
        Weathervane ship(turret_ship(5e7), yaw, -10);
        for (int k = 0; k < 20000; ++k) ship.step({-4e6 * std::min(1.0, k / 5000.0), 0});
        if (yaw < held)
            EXPECT_NEAR(ship.yaw(), yaw, 1e-3);
        else
            EXPECT_LT(std::abs(ship.yaw()), held);
    }
}

// The water beside a ship moves with it across, however the ship lies.
TEST(MooredMotion, AddedMassTurnsWithTheHull) {
    Moorings moorings = springs();
    moorings.added = {0, 3000, 0};
    moorings.yaw = 1e-6;
    for (const double yaw : {0.0, pi / 2, -pi}) {
        MooredMotion motion(moorings, still_water, 1e-3);
        motion.place({.offset = in_plane({0, 0, yaw})});
        motion.advance(in_plane({100, 0, 0}), 1e-3);
        const double mass = std::abs(std::cos(yaw)) > 0.5 ? 1000 : 4000;
        EXPECT_NEAR(motion.state().velocity[0], 100 * 1e-3 / mass, 1e-9) << yaw;
    }
}

TEST(MooredMotion, LineBreaksOnceAndForAll) {
    MooredMotion motion(two_lines(7000), still_water, step);
    const auto state = [&]() -> const MooredState& { return motion.state(); };
    int k = 0;
    for (; k < 200; ++k) motion.advance(in_plane({-1500, 0, 0}), step * (k + 1));
    EXPECT_TRUE(std::isnan(state().broken_at[0])) << "5000 N and half of twice 1500 N";
    for (; k < 400 && std::isnan(state().broken_at[0]); ++k) motion.advance(in_plane({-4500, 0, 0}), step * (k + 1));
    EXPECT_NEAR(state().broken_at[0], step * k, 1e-9);
    EXPECT_GT(motion.largest_tensions()[0], 7000);
    EXPECT_DOUBLE_EQ(motion.line_use(), motion.largest_tensions()[0] / 7000) << "of the step in which it breaks";
    EXPECT_TRUE(std::isnan(state().broken_at[1]));
    const double broken = state().broken_at[0];
    const double without = pull(two_lines(), two_lines().lines[1], state().offset).force[0];
    EXPECT_NEAR(motion.restoring()[0], without, 1e-9) << "only the other line pulls";
    motion.advance(in_plane({5000, 0, 0}), step * (k + 1));
    EXPECT_EQ(state().broken_at[0], broken);
}

// A floe of mass m that strikes a free structure of mass M and stays is stopped by m M / (m + M) of its speed. Here the
// structure moves after the step only, so it is m: 1 + m/M times as much, and momentum is kept all the same.
TEST(MooredMotion, StruckByAFloeItTakesItsMomentum) {
    for (const double ratio : {10.0, 100.0}) {
        WorldDefinition definition;
        definition.gravity = 0;
        definition.solver = SolverKind::lanes;
        World world(definition);
        const std::vector<ConvexSolid> drum{Frustum{-0.5, 0.6, 0.5, 0.6}};
        const BodyId structure = world.add_structure(drum, {Vec3::Zero()});
        const double floe_mass = 1.2;
        const BodyId floe = world.add_element({.corners = corners_of(0.1, 0.1),
                                               .half_thickness = 0.0165,
                                               .mass = floe_mass,
                                               .pose = {.position = {0.705, 0, 0}, .orientation = Quat::Identity()}});
        world.place(floe, {.position = {0.705, 0, 0}, .velocity = {-0.1, 0, 0}});
        MooredMotion motion({.free = {true}, .mass = ratio * floe_mass, .surge = 1e-9}, still_water, step);
        Vec3 load = Vec3::Zero();
        for (int k = 0; k < 200; ++k) {
            motion.advance(in_plane({load.x(), 0, 0}), step * (k + 1));
            world.move_structure({{motion.state().offset[0], 0, 0}});
            world.step();
            load = world.contact_force(structure);
        }
        const double structure_speed = motion.state().velocity[0];
        const double floe_speed = world.state(floe).velocity.x();
        EXPECT_NEAR(ratio * structure_speed + floe_speed, -0.1, 1e-6) << "momentum";
        EXPECT_NEAR(structure_speed, -0.1 / (ratio + 1), 0.1 / (ratio + 1) * 1.5 / ratio) << ratio;
    }
}

}  // namespace moored_motion_test
}  // namespace floes
