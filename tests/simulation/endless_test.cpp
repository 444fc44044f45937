// A tow through a field without end: what it measures does not know how long the run is, and costs the same all along.

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <utility>

#include "core/error.hpp"
#include "core/units.hpp"
#include "endless_tow.hpp"
#include "support/endless_scenario.hpp"

namespace floes {
namespace endless_test {

TEST(EndlessTow, BeginsWithTheBitsOfAnyLongerOne) {
    for (const SolverKind solver : {SolverKind::lanes, SolverKind::direct}) {
        std::vector<LoadHistory> loads;
        std::vector<std::size_t> breaks;
        for (const double seconds : {3.0, 6.0, 9.0, 12.0}) {
            Simulation simulation = tow(endless_scenario(seconds, solver));
            ASSERT_TRUE(simulation.run({}));
            loads.push_back(simulation.loads());
            breaks.push_back(simulation.ice().breaks().size());
        }
        for (std::size_t k = 0; k + 1 < loads.size(); ++k) {
            for (const auto part : {&LoadHistory::surge, &LoadHistory::sway, &LoadHistory::heave}) {
                std::vector<double> longer = loads.back().*part;
                longer.resize((loads[k].*part).size());
                EXPECT_EQ(loads[k].*part, longer);
            }
        }
        EXPECT_GT(*std::ranges::max_element(loads.front().surge), 1) << "the structure is to meet the ice";
        EXPECT_GT(breaks.back(), breaks.front()) << "floes are to break all along";
    }
}

TEST(EndlessTow, HasNoMorePlacesForFloesWhenItIsTwiceAsLong) {
    Simulation simulation = tow(endless_scenario(40));
    int early = 0;
    int entered = 0;
    ASSERT_TRUE(simulation.run({}, [&](const Simulation& run) {
        if (run.time() <= 20) {
            early = run.ice().places();
            entered = run.floes_entered();
        }
    }));
    constexpr int half_a_part = 6;
    EXPECT_LE(simulation.ice().places(), early + half_a_part) << "more only as the floes in the window scatter";
    EXPECT_GT(simulation.floes_entered(), 3 * entered / 2);
    EXPECT_GT(simulation.ice().floes(), simulation.ice().places() + 24) << "two parts are to have left";
}

TEST(EndlessTow, CountsFloesThatEnteredAndThoseThatMetTheStructure) {
    const Scenario scenario = endless_scenario(12);
    Simulation simulation = tow(scenario);
    std::vector<int> numbers;  // of floes that moved
    ASSERT_TRUE(simulation.run({}, [&](const Simulation& run) {
        for (std::size_t i = 0; i < run.element_states().size(); ++i) {
            if (run.element_states()[i].velocity.isZero(0)) continue;
            const int number = run.ice().number_of(run.ice().elements()[i].floe);
            if (std::ranges::find(numbers, number) == numbers.end()) numbers.push_back(number);
        }
    }));
    EXPECT_EQ(simulation.floes_entered(), std::ssize(numbers));
    EXPECT_GT(simulation.floes_met(), 4);
    EXPECT_LT(simulation.floes_met(), simulation.floes_entered());
    EXPECT_LE(simulation.floes_met_broken(), simulation.ice().broken_floes());
    std::vector<int> broken;
    for (const BreakEvent& event : simulation.ice().breaks()) {
        EXPECT_NE(std::ranges::find(numbers, event.floe), numbers.end()) << "a floe at rest broke";
        if (std::ranges::find(broken, event.floe) == broken.end()) broken.push_back(event.floe);
    }
    EXPECT_EQ(simulation.ice().broken_floes(), std::ssize(broken));
    EXPECT_GE(simulation.ice().pieces(), simulation.ice().floes());
}

// Floes ahead of the window stay where they were laid.
TEST(EndlessTow, MovesNothingAheadOfItsWindow) {
    const Scenario scenario = endless_scenario(8);
    LaidField laid = lay_field(scenario, 1, 0);
    Simulation simulation(scenario, laid.floes, laid.ahead);
    ASSERT_TRUE(simulation.run({}));
    const double axis = scenario.structure.start + scenario.structure.speed * simulation.time();
    int resting = 0;
    for (std::size_t i = 0; i < simulation.element_states().size(); ++i) {
        const BodyState& state = simulation.element_states()[i];
        if (state.position.x() < axis + scenario.field.ahead + 0.6) continue;
        ++resting;
        EXPECT_TRUE(state.velocity.isZero(0));
    }
    EXPECT_GT(resting, 9);
    EXPECT_EQ(simulation.floes_resting() + simulation.floes_entered(), simulation.ice().floes());
}

TEST(EndlessTow, FloesOfUnlikeIceComeAndLeaveToo) {
    Scenario scenario = endless_scenario(12, SolverKind::direct);
    scenario.spread.thickness.law = LawKind::lognormal;
    scenario.spread.thickness.cov = 0.2;
    scenario.sizes.law = SizeLaw::list;
    scenario.sizes.list = {{0.4, 0.4, 0.5}, {0.6, 0.6, 0.5}};
    std::vector<LoadHistory> loads;
    for (int i = 0; i < 2; ++i) {
        Simulation simulation = tow(scenario);
        ASSERT_TRUE(simulation.run({}));
        loads.push_back(simulation.loads());
        EXPECT_GT(simulation.ice().floes(), simulation.ice().places());
    }
    EXPECT_EQ(loads[0].surge, loads[1].surge);
}

/// A barge of 0.8 m by 0.5 m.
Scenario endless_barge(double seconds) {
    Scenario scenario = endless_scenario(seconds, SolverKind::direct);
    scenario.structure.shape = Shape(
        HullKind::barge, {.length = 0.8, .beam = 0.5, .draught = 0.2, .freeboard = 0.1, .stem = 45 * unit::degree});
    return scenario;
}

TEST(EndlessTow, OfAHullBeginsWithTheBitsOfAnyLongerOneAndKeepsThePiecesThatLeft) {
    ASSERT_EQ(find_contradictions(endless_barge(12)).size(), 0u);
    Simulation shorter = tow(endless_barge(6));
    Simulation longer = tow(endless_barge(12));
    ASSERT_NO_FATAL_FAILURE(expect_same_beginning(shorter, longer));
    const IceField& ice = longer.ice();
    std::map<int, std::pair<int, double>> floes;  // their pieces, and the area of these
    for (const PieceArea& one : ice.piece_areas()) {
        ++floes[one.floe].first;
        floes[one.floe].second += one.area;
    }
    EXPECT_EQ(std::ssize(floes), ice.split_floes());
    EXPECT_GT(ice.split_floes(), 0);
    EXPECT_LT(floes.begin()->first, ice.number_of(0)) << "a floe that left is to be in pieces";
    int pieces = ice.floes() - ice.split_floes();
    const FloeShape& floe = endless_barge(12).floe;
    for (const auto& [number, of] : floes) {
        pieces += of.first;
        EXPECT_GT(of.first, 1);
        EXPECT_NEAR(of.second, floe.length * floe.breadth, 1e-9);
    }
    EXPECT_EQ(pieces, ice.pieces());
}

/// Through polygons of different numbers of elements.
Scenario endless_polygons(double seconds, ShapeKind kind) {
    Scenario scenario = endless_scenario(seconds, SolverKind::direct);
    // One of each criterion: stress below contacts has to follow the element that is in a place.
    scenario.joint.failure = kind == ShapeKind::voronoi ? JointFailure::stress : JointFailure::moment;
    scenario.shapes.kind = kind;
    scenario.field.floes = 12;  // of a part, so that three come and go
    return scenario;
}

TEST(EndlessTow, ThroughPolygonsBeginsWithTheBitsOfAnyLongerOne) {
    for (const ShapeKind kind : {ShapeKind::polygon, ShapeKind::voronoi}) {
        SCOPED_TRACE(kind == ShapeKind::voronoi);
        ASSERT_EQ(find_contradictions(endless_polygons(18, kind)).size(), 0u);
        Simulation shorter = tow(endless_polygons(5, kind));
        Simulation longer = tow(endless_polygons(18, kind));
        ASSERT_NO_FATAL_FAILURE(expect_same_beginning(shorter, longer));
        const IceField& ice = longer.ice();
        EXPECT_GT(longer.floes_met(), 4);
        EXPECT_GT(ice.broken_floes(), 0);
        std::map<int, double> floes;  // in pieces, and the area of these
        for (const PieceArea& one : ice.piece_areas()) floes[one.floe] += one.area;
        EXPECT_EQ(std::ssize(floes), ice.split_floes());
    }
}

TEST(EndlessTow, CannotBeContinuedFromAState) {
    const Scenario scenario = endless_scenario(3);
    const LaidField laid = lay_field(scenario, 1, 0);
    EXPECT_THROW(Simulation(scenario, laid.floes, Simulation(scenario, laid.floes).state()), InputError);
}

}  // namespace endless_test
}  // namespace floes
