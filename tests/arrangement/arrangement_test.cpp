#include "arrangement/arrangement.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <ctime>

#include "arrangement/check.hpp"
#include "arrangement/order.hpp"
#include "arrangement/sampler.hpp"
#include "core/error.hpp"
#include "core/random.hpp"
#include "support/refusal.hpp"

namespace floes {
namespace arrangement_test {

using testing::HasSubstr;

Scenario quick() {
    Scenario scenario;
    scenario.arrangement.method = ArrangementMethod::monte_carlo;
    scenario.arrangement.sweeps = 200;
    return scenario;
}

std::string refusal(const Scenario& scenario) {
    return floes::refusal([&] { make_arrangement(scenario, 1, 0); });
}

bool same(const Arrangement& a, const Arrangement& b) {
    for (std::size_t i = 0; i < a.size(); ++i) {
        if (a.floes[i].pose.x != b.floes[i].pose.x || a.floes[i].pose.z != b.floes[i].pose.z ||
            a.floes[i].pose.yaw != b.floes[i].pose.yaw)
            return false;
    }
    return a.psi4 == b.psi4;
}

TEST(Arrangement, FillsThePapersChannel) {
    const Scenario scenario = quick();
    const Arrangement arrangement = make_arrangement(scenario, 1, 0);
    EXPECT_EQ(arrangement.size(), 189u);
    EXPECT_NEAR(scenario.field_end(), 24.9, 1e-12);
    EXPECT_EQ(find_fault(scenario, arrangement), std::nullopt);
    EXPECT_EQ(arrangement.psi4, fourfold_order(arrangement.poses()));
}

TEST(Arrangement, IsAFunctionOfSeedNumberAndGeometry) {
    const Scenario scenario = quick();
    const Arrangement arrangement = make_arrangement(scenario, 1, 0);
    EXPECT_TRUE(same(arrangement, make_arrangement(scenario, 1, 0)));
    EXPECT_FALSE(same(arrangement, make_arrangement(scenario, 2, 0)));
    EXPECT_FALSE(same(arrangement, make_arrangement(scenario, 1, 1)));
    Scenario another_case = scenario;
    another_case.joint.cfm = 0.03;
    another_case.ice.elastic_modulus = 30e6;
    another_case.structure.speed = 0.1;
    EXPECT_TRUE(same(arrangement, make_arrangement(another_case, 1, 0)));
}

TEST(Arrangement, KeyFollowsEveryGeometryFieldAndNoOther) {
    const Scenario base;
    const std::uint64_t key = geometry_key(base);
    const auto key_after = [&](auto change) {
        Scenario scenario = base;
        change(scenario);
        return geometry_key(scenario);
    };
    EXPECT_NE(key, key_after([](Scenario& s) { s.floe.length = 0.8; }));
    EXPECT_NE(key, key_after([](Scenario& s) { s.floe.breadth = 0.8; }));
    EXPECT_NE(key, key_after([](Scenario& s) { s.field.floes = 190; }));
    EXPECT_NE(key, key_after([](Scenario& s) { s.field.concentration = std::nextafter(0.75, 1); }));
    EXPECT_NE(key, key_after([](Scenario& s) { s.field.begin = 5; }));
    EXPECT_NE(key, key_after([](Scenario& s) { s.field.half_width = 2; }));
    EXPECT_NE(key, key_after([](Scenario& s) { s.arrangement.method = ArrangementMethod::lattice; }));
    EXPECT_NE(key, key_after([](Scenario& s) { s.arrangement.start = ArrangementStart::stripes; }));
    EXPECT_NE(key, key_after([](Scenario& s) { s.arrangement.clearance = 0; }));
    EXPECT_NE(key, key_after([](Scenario& s) { ++s.arrangement.sweeps; }));
    EXPECT_NE(key, key_after([](Scenario& s) { s.arrangement.jitter = 0.1; }));
    EXPECT_NE(key, key_after([](Scenario& s) { s.arrangement.jitter_angle = 0.1; }));
    EXPECT_NE(key, key_after([](Scenario& s) { s.arrangement.poses = {{7, 0, 0}}; }));
    EXPECT_EQ(key, key_after([](Scenario& s) { s.floe.element = 0.1; }));
    EXPECT_EQ(key, key_after([](Scenario& s) { s.field.far_end = FarEnd::open; }));
    EXPECT_EQ(key, key_after([](Scenario& s) { s.floe.thickness = 0.04; }));
    EXPECT_EQ(key, key_after([](Scenario& s) { s.analysis.window = 100; }));
}

TEST(Arrangement, OblongFloesFitToo) {
    Scenario scenario = quick();
    scenario.floe.length = 1.2;
    scenario.floe.breadth = 0.4;
    scenario.field.floes = 60;
    scenario.field.concentration = 0.6;
    for (const ArrangementStart start : {ArrangementStart::lattice, ArrangementStart::stripes}) {
        scenario.arrangement.start = start;
        EXPECT_EQ(find_fault(scenario, make_arrangement(scenario, 1, 0)), std::nullopt);
    }
}

TEST(Arrangement, OneFloeIsAField) {
    Scenario scenario = quick();
    scenario.field.floes = 1;
    scenario.field.concentration = 0.1;
    for (const ArrangementStart start : {ArrangementStart::lattice, ArrangementStart::stripes}) {
        scenario.arrangement.start = start;
        EXPECT_NEAR(make_arrangement(scenario, 1, 0).psi4, 1, 1e-15);
    }
}

TEST(Arrangement, FloesThatNoLatticeHoldsAreRefused) {
    Scenario scenario = quick();
    scenario.field.concentration = 0.97;
    EXPECT_THAT(refusal(scenario), HasSubstr("do not fit on a lattice"));
}

TEST(Starts, AreValidAndDifferMuch) {
    const Scenario scenario;
    const double clearance = scenario.arrangement.clearance;
    const auto lattice = lattice_start(field_walls(scenario), covering(rectangles(floes_of(scenario))), clearance, 189);
    const auto stripes = stripes_start(field_walls(scenario), covering(rectangles(floes_of(scenario))), clearance, 189);
    EXPECT_EQ(find_fault(scenario, floes_at(scenario, lattice)), std::nullopt);
    EXPECT_EQ(find_fault(scenario, floes_at(scenario, stripes)), std::nullopt);
    EXPECT_NEAR(fourfold_order(lattice), 1, 1e-15);
    EXPECT_LT(fourfold_order(stripes), 0.6);
    double sway = 0;
    for (const PlanarPose& pose : stripes) sway += pose.z / 189;
    EXPECT_LT(sway, -0.2);  // pushed to one side
}

TEST(JitteredLattice, StaysWithinItsJitter) {
    Scenario scenario;
    scenario.arrangement.method = ArrangementMethod::lattice;
    const Arrangement still = make_arrangement(scenario, 1, 0);
    EXPECT_NEAR(still.psi4, 1, 1e-15);
    scenario.arrangement.jitter = 0.04;
    scenario.arrangement.jitter_angle = 0.1;
    const Arrangement moved = make_arrangement(scenario, 1, 0);
    double furthest = 0, widest = 0;
    for (std::size_t i = 0; i < 189; ++i) {
        const double dx = moved.floes[i].pose.x - still.floes[i].pose.x;
        const double dz = moved.floes[i].pose.z - still.floes[i].pose.z;
        furthest = std::max({furthest, std::abs(dx), std::abs(dz)});
        widest = std::max(widest, std::abs(moved.floes[i].pose.yaw));
    }
    EXPECT_LE(furthest, 0.04);
    EXPECT_GT(furthest, 0.03);
    EXPECT_LE(widest, 0.1);
    EXPECT_GT(widest, 0.08);
    EXPECT_FALSE(same(moved, make_arrangement(scenario, 1, 1)));
    EXPECT_TRUE(same(moved, make_arrangement(scenario, 1, 0)));
}

TEST(JitteredLattice, WithoutRoomIsRefused) {
    Scenario scenario;
    scenario.floe.length = scenario.floe.breadth = 1;
    scenario.field = {.floes = 9, .concentration = 0.9999, .begin = 0, .half_width = 1.5};
    scenario.arrangement.method = ArrangementMethod::lattice;
    scenario.arrangement.clearance = 0;
    scenario.arrangement.jitter = 0.5;
    EXPECT_THAT(refusal(scenario), HasSubstr("has no room for floe 0 of 9"));
}

TEST(GivenPoses, AreTakenAsTheyAre) {
    Scenario scenario = quick();
    const Arrangement sampled = make_arrangement(scenario, 1, 0);
    scenario.arrangement.method = ArrangementMethod::file;
    scenario.arrangement.poses = sampled.poses();
    EXPECT_TRUE(same(sampled, make_arrangement(scenario, 5, 9)));
}

TEST(GivenPoses, AreRefusedWithTheReason) {
    Scenario scenario = quick();
    const Arrangement sampled = make_arrangement(scenario, 1, 0);
    scenario.arrangement.method = ArrangementMethod::file;
    const auto refusal_after = [&](auto change) {
        scenario.arrangement.poses = sampled.poses();
        change(scenario.arrangement.poses);
        return refusal(scenario);
    };
    EXPECT_THAT(refusal_after([](auto& poses) { poses.pop_back(); }), HasSubstr("188 floes where the field has 189"));
    EXPECT_THAT(refusal_after([](auto& poses) { poses[3] = poses[7]; }), HasSubstr("floes 3 and 7"));
    EXPECT_THAT(refusal_after([](auto& poses) { poses[5].z = 2.3; }), HasSubstr("floe 5 at"));
    EXPECT_THAT(refusal_after([](auto& poses) { poses[5].x = 6.2; }), HasSubstr("is not inside the field"));
    EXPECT_THAT(refusal_after([](auto& poses) { poses[4].yaw = std::nan(""); }), HasSubstr("floe 4 has the yaw nan"));
    EXPECT_THAT(refusal_after([](auto& poses) { poses[4].x = std::nan(""); }), HasSubstr("is not inside the field"));
}

TEST(GivenPoses, AreRefusedWithTheFloesAndHowFarTheyAreOff) {
    Scenario scenario = quick();
    scenario.field = {.floes = 2, .concentration = 0.01, .begin = 6, .half_width = 2.4};
    scenario.arrangement.clearance = 0.01;
    const auto fault_of = [&](PlanarPose first, PlanarPose second) {
        const std::optional<Fault> fault = find_fault(scenario, floes_at(scenario, std::vector{first, second}));
        return fault ? fault->sentence : "none";
    };
    const double tip = 0.3 * std::sqrt(2.0);  // from the middle of a floe to its corner
    const double eighth = 0.5 * std::acos(0.0);
    EXPECT_EQ(fault_of({7, 0, 0}, {7.61, 0, 0}), "none");
    EXPECT_EQ(fault_of({7, 0, 0}, {7.55, 0.1, 0}),
              "floes 0 and 1, at x = 7.0000 m, z = 0.0000 m and x = 7.5500 m, z = 0.1000 m, overlap by 0.05 m; they "
              "are to be 0.01 m apart, the clearance");
    EXPECT_EQ(fault_of({7, 0, 0}, {7, -0.604, 0}),
              "floes 0 and 1, at x = 7.0000 m, z = 0.0000 m and x = 7.0000 m, z = -0.6040 m, are 0.004 m apart; they "
              "are to be 0.01 m apart, the clearance");
    EXPECT_EQ(fault_of({7, 0, 0}, {7.3 + tip + 0.0121, 0, eighth}), "none");
    EXPECT_THAT(fault_of({7, 0, 0}, {7.3 + tip + 0.0110, 0, eighth}),
                HasSubstr("are 0.011 m apart; they are to be 0.01207 m apart, the clearance of 0.01 m at the angle "
                          "between them"));
    EXPECT_EQ(fault_of({8, 0, 0}, {7, 2.2, 0}),
              "floe 1 at x = 7.0000 m, z = 2.2000 m is not inside the field: it lies 0.1 m beyond its edge at z = 2.4 "
              "m and is to stay 0.01 m within");
    EXPECT_THAT(fault_of({6.304, 0, 0}, {8, 0, 0}), HasSubstr("floe 0 at"));
    EXPECT_THAT(fault_of({6.304, 0, 0}, {8, 0, 0}), HasSubstr("it lies 0.004 m from its edge at x = 6 m"));
    EXPECT_EQ(find_fault(scenario, floes_at(scenario, std::vector<PlanarPose>{{8, 0, 0}, {8.1, 0, 0}}))->floes,
              (std::vector<std::size_t>{0, 1}));
}

// Every pair was looked at: 200,000 poses took minutes.
TEST(GivenPoses, OfALargeFieldAreLookedAtInTime) {
    Scenario scenario = quick();
    constexpr int floes = 100'000;
    constexpr int rows = 250;
    scenario.field = {.floes = floes, .concentration = 0.36, .begin = 0, .half_width = 0.5 * rows};
    std::vector<PlanarPose> poses;
    for (int k = 0; k < floes; ++k) poses.push_back({k / rows + 0.5, k % rows + 0.5 - 0.5 * rows, 0.01 * k});
    const std::clock_t begin = std::clock();  // of the processor
    EXPECT_EQ(find_fault(scenario, floes_at(scenario, poses)), std::nullopt);
    poses[80'000].x += 0.5;
    EXPECT_EQ(find_fault(scenario, floes_at(scenario, poses))->floes, (std::vector<std::size_t>{80'000, 80'250}));
    EXPECT_LT(std::clock() - begin, 5 * CLOCKS_PER_SEC);
}

// The cells must leave out no pair.
TEST(GivenPoses, OverlapExactlyWhenAPairOfThemDoes) {
    Scenario scenario = quick();
    constexpr int floes = 8;
    scenario.field = {.floes = floes, .concentration = 0.1, .begin = 0, .half_width = 3};
    RandomStream random(1, 0, StreamId::scattering, 0);
    int faults = 0;
    for (int round = 0; round < 1000; ++round) {
        std::vector<PlanarPose> poses;
        for (int k = 0; k < floes; ++k)
            poses.push_back({0.5 + 3.8 * random.uniform(), -2.5 + 5 * random.uniform(), 6 * random.uniform()});
        bool some = false;
        const Rectangle grown = rectangles(floes_of(scenario)).front().grown(0.5 * scenario.arrangement.clearance);
        for (int i = 0; i < floes; ++i)
            for (int j = 0; j < i; ++j)
                some = some || overlap({grown, turn_of(poses[i].yaw)}, {grown, turn_of(poses[j].yaw)},
                                       poses[j].x - poses[i].x, poses[j].z - poses[i].z);
        EXPECT_EQ(find_fault(scenario, floes_at(scenario, poses)).has_value(), some);
        faults += some ? 1 : 0;
    }
    EXPECT_GT(faults, 200);
    EXPECT_LT(faults, 980);
}

TEST(FourfoldOrder, OfKnownYaws) {
    const double quarter = std::acos(0.0);
    const std::vector<PlanarPose> aligned{
        {0, 0, 0.3}, {0, 0, 0.3 + quarter}, {0, 0, 0.3 - quarter}, {0, 0, 0.3 - 2 * quarter}};
    EXPECT_NEAR(fourfold_order(aligned), 1, 1e-15);
    const std::vector<PlanarPose> diagonal{{0, 0, 0}, {0, 0, 0.5 * quarter}};
    EXPECT_NEAR(fourfold_order(diagonal), 0, 1e-15);
    const std::vector<PlanarPose> pair{{0, 0, -0.1}, {0, 0, 0.1}};
    EXPECT_NEAR(fourfold_order(pair), std::cos(0.4), 1e-15);
}

}  // namespace arrangement_test
}  // namespace floes
