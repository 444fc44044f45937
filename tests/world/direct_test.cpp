// Joints solved exactly: against sweeps that have converged, closed forms, and what must be conserved.

#include <gtest/gtest.h>
#include <array>

#include <algorithm>
#include <cmath>
#include <vector>

#include "core/error.hpp"
#include "solver/lane_width.hpp"
#include "world/lanes_scene.hpp"

namespace floes::test {
namespace direct_test {

/// As stiff as ice of 5 GPa in elements of 0.2 m, 0.033 m thick.
JointSpring stiff_ice(double damping_ratio = 0) {
    constexpr double modulus = 5e9;
    constexpr double rigidity = modulus * element_thickness * element_thickness * element_thickness / 12;
    constexpr double sheet = modulus * element_thickness;
    constexpr double area = element_side * element_side;
    return {.force = {sheet, 12 * rigidity / area, 0.8 * sheet},
            .moment = {rigidity, sheet * area / 12, rigidity},
            .damping_ratio = damping_ratio};
}

double largest_load(const LanesScene& scene) {
    double largest = 0;
    for (const BodyId element : scene.elements) largest = std::max(largest, scene.world.contact_force(element).norm());
    return largest;
}

double largest_difference(const LanesScene& a, const LanesScene& b) {
    double largest = 0;
    for (const BodyId element : a.elements) {
        largest = std::max(largest, (a.world.contact_force(element) - b.world.contact_force(element)).norm());
    }
    return largest;
}

// The same joints and contacts, by 20,000 sweeps: what differs is that the direct solver takes the floe's shape from
// before it was strained.
TEST(Direct, IsWhereSweepsConvergeTo) {
    WorldDefinition swept = solved_by(SolverKind::direct);
    swept.solver = SolverKind::lanes;
    swept.iterations = 20000;
    WorldDefinition direct = solved_by(SolverKind::direct);
    direct.iterations = 500;
    LanesScene a(direct, 4);
    LanesScene b(swept, 4);
    int first_touch = -1;
    for (int i = 0; i < 60; ++i) {
        if (i == 20) {
            a.break_joints(5);
            b.break_joints(5);
        }
        a.step();
        b.step();
        const double size = largest_load(b);
        if (size == 0) continue;
        EXPECT_LT(largest_difference(a, b), (first_touch < 0 ? 1e-5 : 0.05) * size) << "step " << i;
        first_touch = first_touch < 0 ? i : first_touch;
    }
    EXPECT_GT(first_touch, 0);
}

// Sweeps end by themselves: the same forces as by many of them, to what the tolerance leaves.
TEST(Direct, SweepsEndWhereTheyChangeNothing) {
    WorldDefinition exact = solved_by(SolverKind::direct);
    exact.iterations = 500;
    WorldDefinition loose = exact;
    loose.tolerance = 1e-6;
    LanesScene a(loose, 4);
    LanesScene b(exact, 4);
    int fewest = exact.iterations;
    bool touched = false;
    for (int i = 0; i < 40; ++i) {
        a.step();
        b.step();
        EXPECT_EQ(b.world.sweeps(), largest_load(b) > 0 || b.world.sweeps() > 0 ? exact.iterations : 0);
        const double size = largest_load(b);
        if (size == 0) continue;
        touched = true;
        fewest = std::min(fewest, a.world.sweeps());
        EXPECT_GT(a.world.sweeps(), 0);
        EXPECT_LT(largest_difference(a, b), 0.01 * size) << "step " << i;
    }
    EXPECT_TRUE(touched);
    EXPECT_LT(fewest, 100);
}

TEST(Direct, AStepWithoutContactsTakesNoSweeps) {
    World world(solved_by(SolverKind::direct));
    world.add_element(element_at({0, 0, 0}));
    world.step();
    EXPECT_EQ(world.sweeps(), 0);
}

class EveryDirectWidth : public testing::TestWithParam<NormalLaw> {};

TEST_P(EveryDirectWidth, GivesTheSameBits) {
    std::vector<LanesScene> scenes;
    for (const int width : lane_widths()) {
        WorldDefinition definition = solved_by(SolverKind::direct, width);
        definition.contact.normal = GetParam();
        definition.tolerance = 1e-3;
        definition.contact.crushing_pressure = 145.6e3;
        definition.iterations = 15;
        LanesScene& scene = scenes.emplace_back(definition);
        for (int i = 0; i < 60; ++i) {
            if (i == 20) scene.break_joints(7);
            if (i == 40) scene.break_joints(3);
            scene.step();
        }
        EXPECT_GT(scene.world.contact_force(scene.cone).norm(), 0.1);
        for (std::size_t i = 0; i < scene.elements.size(); ++i) {
            EXPECT_TRUE(same_bits(scene.world.state(scene.elements[i]), scenes[0].world.state(scene.elements[i])));
        }
        EXPECT_EQ(scene.world.contact_force(scene.cone), scenes[0].world.contact_force(scenes[0].cone));
    }
}

INSTANTIATE_TEST_SUITE_P(Direct, EveryDirectWidth, testing::Values(NormalLaw::rigid, NormalLaw::crushing));

/// A floe of n x n elements, turned in space, with nothing around it.
struct LoneFloe {
    LoneFloe(int n, const JointSpring& spring, const WorldDefinition& definition) : world(definition), joint(spring) {
        const Quat turn = turned(0.7, Vec3(1, 2, -1));
        for (int i = 0; i < n * n; ++i) {
            const Vec3 offset(element_side * (i % n), 0, element_side * (i / n));
            elements.push_back(world.add_element(element_at(turn * offset, turn, 0)));
        }
        const auto join = [&](int a, int b, const Quat& frame) {
            const BodyId first = elements[static_cast<std::size_t>(a)];
            const BodyId second = elements[static_cast<std::size_t>(b)];
            joints.push_back(world.add_joint({.a = first,
                                              .b = second,
                                              .pivot = (world.state(first).position + world.state(second).position) / 2,
                                              .frame = turn * frame,
                                              .spring = spring}));
        };
        for (int i = 0; i < n * n; ++i) {
            if (i % n < n - 1) join(i, i + 1, Quat::Identity());
            if (i < n * (n - 1)) join(i, i + n, turned(-std::acos(-1.0) / 2, Vec3::UnitY()));
        }
    }

    /// Everything in motion, with strain rates that bend and twist it.
    void stir(double speed, double angular_velocity) {
        const Vec3 middle = world.state(elements[elements.size() / 2]).position;
        const Vec3 turning = angular_velocity * Vec3(0.3, 1, -0.2);
        for (std::size_t i = 0; i < elements.size(); ++i) {
            const auto k = static_cast<double>(i);
            BodyState state = world.state(elements[i]);
            state.velocity = turning.cross(state.position - middle) +
                             speed * Vec3(std::sin(3 * k), std::cos(5 * k), std::sin(7 * k + 1));
            state.angular_velocity = turning + 5 * speed * Vec3(std::cos(2 * k), std::sin(11 * k), std::cos(k));
            world.place(elements[i], state);
        }
    }

    Vec3 momentum() const {
        Vec3 sum = Vec3::Zero();
        for (const BodyId element : elements) sum += element_mass * world.state(element).velocity;
        return sum;
    }

    static Vec3 angular_momentum_of(const BodyState& state) {
        const double thin = element_thickness * element_thickness;
        const double broad = element_side * element_side;
        const Vec3 inertia = element_mass / 12 * Vec3(thin + broad, 2 * broad, thin + broad);
        return element_mass * state.position.cross(state.velocity) +
               state.rotation * inertia.asDiagonal() * state.rotation.transpose() * state.angular_velocity;
    }

    Vec3 angular_momentum() const {
        Vec3 sum = Vec3::Zero();
        for (const BodyId element : elements) sum += angular_momentum_of(world.state(element));
        return sum;
    }

    /// Kinetic and elastic, J.
    double energy() const {
        double sum = 0;
        for (const BodyId element : elements) {
            const BodyState state = world.state(element);
            const Vec3 own = angular_momentum_of(state) - element_mass * state.position.cross(state.velocity);
            sum += element_mass * state.velocity.squaredNorm() / 2 + own.dot(state.angular_velocity) / 2;
        }
        for (const JointId id : joints) {
            const JointReaction r = world.reaction(id);
            const double force[] = {r.axial, r.shear_vertical, r.shear_in_plane};
            const double moment[] = {r.torsion, r.in_plane_bending, r.bending};
            for (std::size_t i = 0; i < 3; ++i) {
                sum += force[i] * force[i] / joint.force[i] / 2 + moment[i] * moment[i] / joint.moment[i] / 2;
            }
        }
        return sum;
    }

    World world;
    JointSpring joint;
    std::vector<BodyId> elements;
    std::vector<JointId> joints;
};

TEST(Direct, AFreeFloeNeverGainsEnergy) {
    LoneFloe floe(3, stiff_ice(), weightless(SolverKind::direct));
    floe.stir(0.02, 0.5);
    floe.world.step();
    double before = floe.energy();
    for (int i = 0; i < 100000; ++i) {
        floe.world.step();
        const double now = floe.energy();
        ASSERT_LE(now, before * (1 + 1e-10)) << "step " << i;
        before = now;
    }
    EXPECT_GT(before, 1e-4);  // it still turns
}

TEST(Direct, AFreeFloeKeepsItsMomenta) {
    JointSpring soft = stiff_ice();
    for (auto* part : {&soft.force, &soft.moment}) {
        for (double& stiffness : *part) stiffness /= 80;  // 60 MPa
    }
    WorldDefinition definition = weightless(SolverKind::direct);
    definition.time_step = 0.001;
    LoneFloe floe(3, soft, definition);
    floe.stir(0.05, 0.3);
    const Vec3 momentum = floe.momentum();
    const Vec3 turning = floe.angular_momentum();
    for (int i = 0; i < 5000; ++i) floe.world.step();
    EXPECT_LT((floe.momentum() - momentum).norm(), 1e-10 * momentum.norm());
    EXPECT_LT((floe.angular_momentum() - turning).norm(), 1e-3 * turning.norm());
}

TEST(Direct, ReactionsOfALoadedBeamAreThoseOfStatics) {
    World world(weightless(SolverKind::direct));
    BodyId last = world.add_fixed_box({.half_extents = Vec3(0.1, 0.0165, 0.1), .pose = {.position = {-5, 0, 0}}});
    std::vector<JointId> joints;
    std::vector<BodyId> elements;
    constexpr int count = 6;
    for (int i = 0; i < count; ++i) {
        elements.push_back(world.add_element(element_at({element_side * (i + 0.5), 0, 0}, Quat::Identity(), 0)));
        joints.push_back(world.add_joint(
            {.a = last, .b = elements.back(), .pivot = {element_side * i, 0, 0}, .spring = stiff_ice(0.7)}));
        last = elements.back();
    }
    const Vec3 load(-3, -2, 1);  // small, so that what the strained shape adds stays below the tolerances
    for (int step = 0; step < 20000; ++step) {
        world.apply(last, {load, Vec3(0.1, 0, 0)});
        world.step();
    }
    for (int i = 0; i < count; ++i) {
        const double arm = element_side * (count - 0.5 - i);
        const JointReaction r = world.reaction(joints[static_cast<std::size_t>(i)]);
        // On a: what the load does to it through b.
        EXPECT_NEAR(r.axial, load.x(), 1e-3);
        EXPECT_NEAR(r.shear_vertical, load.y(), 1e-3);
        EXPECT_NEAR(r.shear_in_plane, load.z(), 1e-3);
        EXPECT_NEAR(r.torsion, 0.1, 1e-3);
        EXPECT_NEAR(r.in_plane_bending, -load.z() * arm, 1e-3);
        EXPECT_NEAR(r.bending, load.y() * arm, 2e-3);
    }
}

// Between its neighbours, and they between a wall and a push: every contact carries all of it.
TEST(Direct, AFloePressedAgainstTheWallPassesThePushOn) {
    WorldDefinition definition = weightless(SolverKind::direct);
    definition.iterations = 60;
    definition.contact.internal_edges = false;
    LanesScene scene(definition, 3);
    World& world = scene.world;
    const double push = 20;
    for (int i = 0; i < 4000; ++i) {
        for (const BodyId element : scene.elements) {
            const BodyState state = world.state(element);
            world.apply(element,
                        {-5 * state.velocity - Vec3(0, 100 * state.position.y(), 0), -0.1 * state.angular_velocity});
        }
        world.apply(scene.elements[3], {{push, 0, 0}, Vec3::Zero()});  // the middle of the first floe's near edge
        world.step();
    }
    std::array<Vec3, 3> on_floe{Vec3::Zero(), Vec3::Zero(), Vec3::Zero()};  // Eigen leaves them as they are
    for (std::size_t i = 0; i < scene.elements.size(); ++i) {
        const Vec3 drag = -5 * world.state(scene.elements[i]).velocity;
        const Vec3 spring(0, -100 * world.state(scene.elements[i]).position.y(), 0);
        on_floe[i / 9] += world.contact_force(scene.elements[i]) + drag + spring;
    }
    EXPECT_NEAR(on_floe[0].x(), -push, 0.02 * push);
    EXPECT_NEAR(on_floe[1].norm(), 0, 0.02 * push);
    EXPECT_NEAR(on_floe[2].norm(), 0, 0.02 * push);
}

TEST(Direct, RefusesWhatItCannotDo) {
    WorldDefinition definition = solved_by(SolverKind::direct);
    definition.contact.friction = Friction::one_direction;
    EXPECT_THROW(World{definition}, InputError);
    definition = solved_by(SolverKind::direct);
    definition.contact.split_impulse = true;
    EXPECT_THROW(World{definition}, InputError);
    WorldDefinition lanes = solved_by(SolverKind::direct);
    lanes.solver = SolverKind::lanes;
    EXPECT_THROW(LoneFloe(2, stiff_ice(), lanes), InputError);
    JointSpring loose = stiff_ice();
    loose.moment[0] = 0;
    EXPECT_THROW(LoneFloe(2, loose, solved_by(SolverKind::direct)), InputError);
}

}  // namespace direct_test
}  // namespace floes::test
