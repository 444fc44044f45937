// A moored hull under stored loads: closed forms through the window, what is refused, and the tails of k x.

#include "findings/moored.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <numbers>

#include "campaign/read.hpp"
#include "core/error.hpp"
#include "core/random.hpp"
#include "findings/design_load.hpp"
#include "findings/evidence.hpp"
#include "findings/example.hpp"
#include "support/published.hpp"
#include "support/refusal.hpp"
#include "support/temporary_folder.hpp"

namespace floes {
namespace moored_test {

using testing::HasSubstr;

constexpr double step = 0.05;  // s
constexpr double stiffness = 2000;

/// Of this natural period, s.
MooredRequest moored(double period, double damping_ratio) {
    const double omega = 2 * std::numbers::pi / period;
    return {{stiffness, stiffness / (omega * omega), damping_ratio}, 1, 1};
}

Analysis analysis() {
    Analysis made;
    made.steady_start = 40;
    made.window = 120;
    made.segments = 4;
    made.peak_separation = 1;
    return made;
}

/// From the start to the end of the window.
std::vector<double> history(const std::function<double(double)>& load) {
    std::vector<double> values;
    for (int k = 0; k < 3200; ++k) values.push_back(load(step * (k + 0.5)));
    return values;
}

/// 100 N and a sine of 10 N with this period, from 5 s on.
std::vector<double> sine(double period) {
    return history([=](double t) { return t < 5 ? 0 : 100 + 10 * std::sin(2 * std::numbers::pi * t / period); });
}

TEST(Moored, FeelsASlowLoadAsItIs) {
    const MooredRun run = moored_run(sine(60), step, analysis(), moored(2, 0.2));
    EXPECT_NEAR(run.mean_offset, 100 / stiffness, 0.002 * 100 / stiffness);
    EXPECT_NEAR(run.sd_offset, 10 / std::sqrt(2) / stiffness, 0.01 * 10 / stiffness);
    EXPECT_NEAR(run.amplification(), 1, 0.002);
    EXPECT_NEAR(run.rms_velocity, 10 / std::sqrt(2) / stiffness * 2 * std::numbers::pi / 60, 2e-5);
    EXPECT_EQ(run.first_load, 5);
}

// 10 N at resonance are 10 N / 2ζ; averaged over 1 s, a sine of period T keeps sin(π/T) / (π/T) of its amplitude.
TEST(Moored, SwingsAtResonance) {
    const double zeta = 0.1;
    const MooredRun run = moored_run(sine(4), step, analysis(), moored(4, zeta));
    const double kept = std::sin(std::numbers::pi / 4) / (std::numbers::pi / 4);
    EXPECT_NEAR(run.force.mean_maximum, 100 + 10 / (2 * zeta), 0.3);
    EXPECT_NEAR(run.load.mean_maximum, 100 + 10 * kept, 0.1);
    EXPECT_EQ(run.load.time, 1);
}

// What the entry leaves in the window is what is said of it: after a sudden entry into a constant load, the largest k x
// exceeds it by no more than e^(-ζωt) of its overshoot, and one with a slow entry by less.
TEST(Moored, LeavesNoTransientInTheWindow) {
    const MooredRequest request = moored(10, 0.15);
    const double left = std::exp(-request.hull.decay_rate() * 35);
    ASSERT_EQ(moored_refusal(analysis(), step, 5, request), "");
    ASSERT_GT(left, 0.01);  // near the limit, so that the test can fail
    const std::vector<double> sudden = history([](double t) { return t < 5 ? 0 : 30; });
    const std::vector<double> slow = history([](double t) { return 30 * std::clamp((t - 5) / 20, 0.0, 1.0); });
    const MooredRun run = moored_run(sudden, step, analysis(), request);
    EXPECT_GT(run.force.segment_maximum.front(), 30);
    EXPECT_LT(run.force.segment_maximum.front(), 30 * (1 + left));
    EXPECT_NEAR(run.force.segment_maximum.back(), 30, 30 * std::exp(-request.hull.decay_rate() * 125));
    EXPECT_LT(moored_run(slow, step, analysis(), request).force.segment_maximum.front(), 30 * (1 + left));
}

TEST(Moored, GivesTheForceThatItMeasures) {
    const MooredRequest request = moored(4, 0.1);
    const std::vector<double> force = mooring_force(sine(4), step, analysis(), request);
    ASSERT_EQ(force.size(), 2400u);
    const MooredRun run = moored_run(sine(4), step, analysis(), request);
    EXPECT_EQ(std::ranges::max(force), std::ranges::max(run.force.segment_maximum));
    EXPECT_EQ(std::ranges::max(std::span(force).first(600)), run.force.segment_maximum.front());
}

TEST(Moored, IsTheSameAtFullScale) {
    MooredRequest full = moored(4, 0.1);
    full.scale = 36;
    full.averaging = 6;
    full.hull.stiffness *= 36 * 36;
    full.hull.mass *= 36 * 36 * 36;
    EXPECT_NEAR(full.hull.period(), 6 * 4, 1e-12);
    const MooredRun at_full = moored_run(sine(7), step, analysis(), full);
    const MooredRun at_model = moored_run(sine(7), step, analysis(), moored(4, 0.1));
    EXPECT_NEAR(at_full.force.mean_maximum, at_model.force.mean_maximum, 1e-9);
    EXPECT_EQ(at_full.load.segment_maximum, at_model.load.segment_maximum);
}

TEST(Moored, KeepsSwingsOfOneEventTogether) {
    EXPECT_EQ(moored_separation(analysis(), moored(0.5, 0.5).hull), 1);         // analysis.peak_separation
    EXPECT_NEAR(moored_separation(analysis(), moored(4, 0.5).hull), 4, 1e-12);  // the period
    EXPECT_NEAR(moored_separation(analysis(), moored(4, 0.05).hull), 40 / std::numbers::pi, 1e-9);  // 1/(ζω)
}

TEST(Moored, SaysWhyAWindowDoesNotServe) {
    EXPECT_EQ(moored_refusal(analysis(), step, 5, moored(4, 0.1)), "");
    EXPECT_THAT(moored_refusal(analysis(), step, 5, moored(0.9, 0.1)), HasSubstr("fewer than 20 values"));
    EXPECT_THAT(moored_refusal(analysis(), step, 5, moored(41, 0.9)), HasSubstr("a third of the window of 120 s"));
    EXPECT_THAT(moored_refusal(analysis(), step, 5, moored(4, 0.01)), HasSubstr("% of the swing with which"));
    MooredRequest full = moored(4, 0.01);
    full.scale = 4;
    full.hull.stiffness *= 16;
    full.hull.mass *= 64;
    // At full scale 70 s of run-up, e^(-ζωt) = 0.58; -ln 0.05 / (ζω) = 381 s.
    EXPECT_THAT(moored_refusal(analysis(), step, 5, full), HasSubstr("58 % of the swing"));
    EXPECT_THAT(moored_refusal(analysis(), step, 5, full), HasSubstr("(by 311 s)"));
}

TEST(Moored, RefusesAHullThatIsNone) {
    EXPECT_THAT(refusal([] { check_hull({0, 1, 0.1}); }), HasSubstr("stiffness"));
    EXPECT_THAT(refusal([] { check_hull({1, -1, 0.1}); }), HasSubstr("added mass"));
    for (const double damping : {0.0, 1.0, -0.1, std::nan("")})
        EXPECT_THAT(refusal([=] { check_hull({1, 1, damping}); }), HasSubstr("damping"));
    EXPECT_NO_THROW(check_hull({1, 1, 0.1}));
}

// A run-up of 1 s at ζω = 3.35 1/s leaves 3.5 % of the swing of an entry at the start, 19 % of one after 0.5 s.
TEST(Moored, IsJudgedByTheMemberThatMeetsIceLast) {
    const TemporaryFolder folder;
    const auto found_with = [&](double last_entry) {
        Campaign campaign = synthetic::campaign();
        campaign.cases.resize(1);
        campaign.cases.front().scenario.structure.speed = 0.55;  // or the hull meets the field's end
        campaign.cases.front().scenario.analysis.window = 6;
        std::vector<MemberRecord> records = synthetic::records(campaign);
        for (std::size_t k = 0; k < records.size(); ++k) {
            std::vector<double>& surge = records[k].result.history.surge;
            const double entry = k == 0 ? last_entry : 0;
            for (std::size_t i = 0; i < surge.size(); ++i)
                surge[i] = k != 1 && 0.02 * (static_cast<double>(i) + 0.5) > entry ? 10 : 0;  // one meets none
        }
        synthetic::publish(folder / "a.h5", campaign, records);
        return find_moored(read_evidence(CampaignFile(folder / "a.h5")), moored(1.5, 0.8)).front();
    };
    EXPECT_EQ(found_with(0).refused, "");
    EXPECT_EQ(found_with(0).drift, 0.55);
    EXPECT_THAT(refusal([&] { found_with(0.5); }),
                HasSubstr("19 % of the swing with which the hull enters the ice is left when the window begins, 0.5 s "
                          "after the first load of the member that meets ice last"));
}

TEST(LastEntry, IsOfTheMembersThatMeetIce) {
    LastEntry entry;
    entry.add(100, 100);
    EXPECT_TRUE(std::isinf(entry.time));
    for (const double met : {3.0, 7.0, 5.0, 100.0}) entry.add(met, 100);
    EXPECT_EQ(entry.time, 7);
}

/// A table of one case, and runs with 20 exponential peaks of 20 N above 30 N each.
struct Campaign40 {
    CampaignTable table;
    std::vector<MooredCase> found;

    Campaign40() {
        CaseRow row;
        row.name = "floes";
        row.shape = Shape({{-0.4, 0.2}, {0.1, 0.7}});
        row.analysis = analysis();
        table.title = "example";
        table.cases.push_back(row);
        MooredCase& one = found.emplace_back(MooredCase{0, 0.01, 0.5, {}, ""});  // peaks hide none
        for (int k = 0; k < 40; ++k) {
            MemberRow member;
            member.arrangement = k;
            member.status = RowStatus::done;
            member.load.mean = 20;
            table.members.push_back(member);
            RandomStream random{5, static_cast<std::uint32_t>(k), StreamId::bootstrap, 0};
            MooredRun& run = one.runs.emplace_back();
            run.member = k;
            run.rms_velocity = 0.05;
            for (int i = 0; i < 20; ++i) run.force.peaks.push_back(30 - 20 * std::log(random.uniform(1e-16, 1)));
            std::ranges::sort(run.force.peaks, std::ranges::greater{});
            run.force.segment_maximum.assign(run.force.peaks.begin(), run.force.peaks.begin() + 4);
            run.force.mean_maximum = 2;
            run.load.mean_maximum = 1;
            run.load.time = 1;
        }
    }
};

// The load that 3 h exceed with 10 %: 30 + 20 ln(rate T / -ln 0.9), of 20 peaks in 120 s.
TEST(Moored, GivesItsPeaksToTheTails) {
    const Campaign40 campaign;
    const std::vector<CasePeaks> peaks = moored_peaks(campaign.table, campaign.found);
    ASSERT_EQ(peaks.size(), 1u);
    EXPECT_EQ(peaks[0].members.size(), 40u);
    EXPECT_EQ(peaks[0].measured.mean, 20);
    DesignLoadRequest request;
    request.of = design_of_k_x;
    const DesignLoads designs = find_design_loads(campaign.table, request, peaks);
    EXPECT_EQ(designs.of_cases.at(0).separation, 0.01);
    const double exact = 30 + 20 * std::log(10800 / 6.0 / -std::log(0.9));
    EXPECT_NEAR(designs.of_cases.at(0).load.estimates.at(0).quantiles.at(0).value, exact, 0.2 * exact);
    const std::vector<Section> told = design_load_sections(summarise(campaign.table), designs);
    EXPECT_EQ(told.at(1).title, "Design mooring force: the largest k x in 3 h");
    EXPECT_THAT(csv(told), HasSubstr("floes,both tails,,3,1,quantile,0.9,"));  // no averaging time
}

TEST(Moored, TellsWhenTheHullMovesTooFast) {
    Campaign40 campaign;
    const auto told = [&] {
        return text(std::vector{moored_section(summarise(campaign.table), campaign.found, moored(4, 0.1))}, 200);
    };
    EXPECT_THAT(told(), testing::AllOf(HasSubstr("natural period 4 s"), HasSubstr("0.100"), HasSubstr("2.00")));
    EXPECT_THAT(told(), testing::Not(HasSubstr("drift speed (rms)")));
    campaign.found.front().drift = 0.2;
    EXPECT_THAT(told(),
                HasSubstr("critical damping; natural period 4 s\n\n! floes: the hull moves with 25 % of the drift"));
}

// Lengths times λ, speeds times √λ, forces times λ³.
TEST(Moored, IsToldAtFullScale) {
    Campaign40 campaign;
    for (MooredRun& run : campaign.found.front().runs) run.mean_offset = 0.1;
    MooredRequest full = moored(8, 0.1);
    full.scale = 4;
    const std::string told = csv(std::vector{moored_section(summarise(campaign.table), campaign.found, full)});
    EXPECT_THAT(told, HasSubstr("mean_offset"));
    EXPECT_THAT(told, HasSubstr(",4,8,2,0.02,0.4"));   // scale, period, averaging, separation, offset
    EXPECT_THAT(told, HasSubstr(",128,128,128,64,"));  // largest force and load
}

/// Springs alone: no line, so no tension and none broken.
TEST(MooredRuns, WithoutLinesTellNoTension) {
    Campaign campaign = read_campaign({"[campaign]\narrangements = 2\n[moorings]\nmass_t = 1.0\ngyration_m = 0.4\n"
                                       "surge_kN_m = 1.0\nsway_kN_m = 1.0\nyaw_kN_m_rad = 1.0\n",
                                       "a.toml",
                                       {}},
                                      nullptr);
    campaign.cases.front().scenario.path.legs = {{0, 0.8, 600, 0}};
    CampaignTable table;
    CaseRow row;
    row.name = campaign.cases.front().name;
    row.shape = campaign.cases.front().scenario.structure.shape;
    table.cases.push_back(row);
    for (int arrangement = 0; arrangement < 2; ++arrangement) {
        MemberRow member = example::done(0, arrangement, 20 + arrangement, 0.1, 1);
        member.moored.surge_offset = {0.01, 0.002, 0.03};
        member.moored.surge_mooring = {20, 5, 40};
        member.moored.mean_maximum = 30;
        member.moored.rms_velocity = 0.2;
        member.moored.yaw = {0, 0, 0};
        table.members.push_back(member);
    }
    const std::optional<Section> told = moored_runs_section(evidence_of(campaign, table));
    ASSERT_TRUE(told);
    const Table table_of_runs = shown_table(told->results.front(), {});
    EXPECT_THAT(table_of_runs.front(), testing::Not(testing::Contains(testing::Field(&Cell::value, "lines broken"))));
    EXPECT_EQ(table_of_runs.size(), 2u);
    EXPECT_THAT(table_of_runs.back(), testing::Contains(testing::Field(&Cell::value, "0.250"))) << "0.2 of 0.8 m/s";
}

}  // namespace moored_test
}  // namespace floes
