// How a structure gives way, in closed form.

#include "member/design_of.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "member/array_output.hpp"

namespace floes {
namespace design_of_test {

constexpr double period = 2;  // s

/// Held by springs of that period in surge and sway.
Scenario moored() {
    Scenario scenario;
    scenario.general.time_step = 0.01;
    scenario.structure.speed = 0.2;
    scenario.analysis = {.steady_start = 4, .window = 20, .segments = 5};
    scenario.analysis.peak_separation = 0.1;
    const double k = 1e5 * std::pow(2 * std::numbers::pi / period, 2);
    scenario.moorings = {.mass = 1e5, .gyration = 2, .surge = k, .sway = k, .yaw = 4 * k};
    return scenario;
}

/// Offset 0.3 + 0.01 t + 0.1 sin(2 π t / 1 s) m, as much against it across, and a force of 3 and 4 N.
MotionHistory swinging(const Scenario& scenario) {
    MotionHistory motion;
    for (int step = 0; step < scenario.step_count(); ++step) {
        for (const auto& one : motion_histories) (motion.*one.values).push_back(0);
        const double time = (step + 1) * scenario.general.time_step;
        motion.surge_offset.back() = 0.3 + 0.01 * time + 0.1 * std::sin(2 * std::numbers::pi * time);
        motion.sway_offset.back() = -motion.surge_offset.back();
        motion.surge_mooring.back() = 3;
        motion.sway_mooring.back() = -4;
    }
    return motion;
}

class Responses : public testing::Test {
  protected:
    const Response& of(const char* word) { return *response_of(outputs_, *find_design_of(word)); }

    Scenario scenario_ = moored();
    MemberOutputs outputs_ = [this] {
        MemberOutputs made;
        made.responses = responses_of(scenario_, swinging(scenario_));
        return made;
    }();
};

TEST_F(Responses, HaveMeanRiseSegmentsAndPeaksOfTheWindow) {
    ASSERT_EQ(outputs_.responses.size(), response_kinds().size());
    const double end = scenario_.analysis.steady_start + scenario_.analysis.window;
    const Response& offset = of("surge_offset");
    EXPECT_NEAR(offset.mean, 0.3 + 0.01 * (end - 10), 1e-4);
    EXPECT_NEAR(offset.rise, 0.2, 0.02) << "a sine of 20 periods has a small slope of its own";
    ASSERT_EQ(offset.segment_maximum.size(), 5u);
    EXPECT_NEAR(offset.segment_maximum.back(), 0.4 + 0.01 * (end - 0.75), 1e-3);
    // A peak each second; two of three are nearer than the natural period to a higher one.
    EXPECT_NEAR(offset.peaks.front(), offset.segment_maximum.back(), 1e-12);
    EXPECT_NEAR(offset.peaks[0] - offset.peaks[1], 0.02, 1e-6);
    EXPECT_EQ(offset.peaks.size(), 10u);
}

TEST_F(Responses, AreResultantsAndAmounts) {
    EXPECT_DOUBLE_EQ(of("mooring_force").mean, 5);
    EXPECT_DOUBLE_EQ(of("surge_mooring").mean, 3);
    EXPECT_DOUBLE_EQ(of("sway_mooring").mean, 4);
    EXPECT_NEAR(of("offset").mean, std::sqrt(2.0) * of("surge_offset").mean, 1e-12);
    EXPECT_DOUBLE_EQ(of("sway_offset").mean, of("surge_offset").mean);
}

TEST_F(Responses, AreNotMeasuredWhereTheStructureHasNone) {
    for (const char* word : {"heave", "pitch", "roll", "line_tension"}) {
        EXPECT_TRUE(std::isnan(of(word).mean)) << word;
        EXPECT_TRUE(of(word).segment_maximum.empty()) << word;
    }
    EXPECT_EQ(response_of(outputs_, *find_design_of("load")), nullptr);
    scenario_.moorings = {};
    EXPECT_TRUE(responses_of(scenario_, swinging(scenario_)).empty());
}

// 1 / (ζ ω) where that is longer than the period.
TEST_F(Responses, HavePeaksApartByPeriodAndFading) {
    EXPECT_NEAR(separation_of(scenario_, *find_design_of("offset")), period, 1e-12);
    scenario_.moorings.damping = 0.01;
    EXPECT_NEAR(separation_of(scenario_, *find_design_of("offset")), period / (2 * std::numbers::pi * 0.01), 1e-9);
    EXPECT_EQ(separation_of(scenario_, *find_design_of("load")), scenario_.analysis.peak_separation);
    // The same by waves: 1 % of 2 √(k m) in surge and sway, the first two of either order.
    Moorings& moorings = scenario_.moorings;
    moorings.damping = 0;
    moorings.radiation_damping.assign(6, std::vector<double>(6, 0.0));
    const Mat6 inertia = moorings.inertia();
    const Mat6 stiffness = moorings.held(scenario_.water_stiffness());
    for (const int k : {0, 1})
        moorings.radiation_damping[static_cast<std::size_t>(k)][static_cast<std::size_t>(k)] =
            0.01 * 2 * std::sqrt(stiffness(k, k) * inertia(k, k));
    EXPECT_NEAR(separation_of(scenario_, *find_design_of("offset")), period / (2 * std::numbers::pi * 0.01), 1e-9);
}

TEST_F(Responses, TravelAsArrays) {
    MemberResult sent, received;
    static_cast<MemberOutputs&>(sent) = outputs_;
    for (const ArrayOutput& one : array_outputs)
        if (one.group() == "responses") one.access.set(received, one.access.get(sent));
    ASSERT_EQ(received.responses.size(), sent.responses.size());
    for (std::size_t k = 0; k < sent.responses.size(); ++k) {
        EXPECT_EQ(received.responses[k].peaks, sent.responses[k].peaks);
        EXPECT_EQ(received.responses[k].segment_maximum, sent.responses[k].segment_maximum);
        EXPECT_TRUE(std::isnan(sent.responses[k].mean) || received.responses[k].mean == sent.responses[k].mean);
        EXPECT_TRUE(std::isnan(sent.responses[k].rise) || received.responses[k].rise == sent.responses[k].rise);
    }
}

}  // namespace design_of_test
}  // namespace floes
