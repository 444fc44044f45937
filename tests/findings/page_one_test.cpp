// The first page: each figure by hand from what members and histories say, and why there is none.

#include "findings/page_one.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>

#include "core/random.hpp"
#include "findings/example.hpp"
#include "findings/moored.hpp"
#include "findings/overview.hpp"
#include "member/design_of.hpp"
#include "simulation/record.hpp"
#include "support/published.hpp"
#include "support/temporary_folder.hpp"

namespace floes {
namespace page_one_test {

using testing::HasSubstr;
using testing::StartsWith;

Estimate estimate_at(const PageOne& page, std::size_t row, std::string_view key) {
    return std::get<Estimate>(page.table.results.front().at(row, key).get());
}

std::string why_at(const PageOne& page, std::size_t row, std::string_view key) {
    return std::get<Undefined>(page.table.results.front().at(row, key).get()).why;
}

/// Three cases of four arrangements, all of them done.
Evidence whole() {
    CampaignTable table = example::campaign();
    table.members[4] = example::done(1, 1, 31, 0.04, 3);
    table.members[10] = example::done(1, 3, 33, 0.02, 3);
    return evidence_of({}, table);
}

// E30 has 26, 28, 24 and 30 N: 27 N, s = 2.582, t(3) = 3.1824. E60 is 4, 3, 10 and 3 N more: 5 N, s = 3.367.
TEST(PageOne, HasEachFigureWithItsIntervalAndItsDifference) {
    Evidence evidence = whole();
    const PageOne page = find_page_one(evidence);
    EXPECT_DOUBLE_EQ(estimate_at(page, 0, "mean_load").value, 27);
    EXPECT_NEAR(estimate_at(page, 0, "mean_load").high, 27 + 3.1824 * 2.5820 / 2, 1e-3);
    EXPECT_DOUBLE_EQ(estimate_at(page, 1, "mean_load_difference").value, 5);
    EXPECT_NEAR(estimate_at(page, 1, "mean_load_difference").low, 5 - 3.1824 * 3.3665 / 2, 1e-3);
    EXPECT_DOUBLE_EQ(estimate_at(page, 1, "mean_maximum_difference").value, 4 * 5);
    EXPECT_DOUBLE_EQ(estimate_at(page, 2, "failure_ratio").value, 0.5);
    EXPECT_TRUE(std::holds_alternative<Absent>(page.table.results.front().at(0, "mean_load_difference").get()));
    EXPECT_THAT(page.table.after, HasSubstr("by pairs over the same arrangements"));
    EXPECT_THAT(page.sentence, StartsWith("E60: mean load 32 N ("));
    EXPECT_THAT(page.next, testing::IsEmpty());
}

// 30 + 20 ln(8 / 1.2 s · 36 s / -ln 0.9) N of exponential peaks, eight in each window.
TEST(PageOne, HasTheDesignLoadThatPeaksGive) {
    const Campaign campaign = synthetic::campaign(40);
    std::vector<MemberRecord> records;
    for (int number = 0; number < member_count(campaign); ++number)
        records.push_back(synthetic::record_with_peaks(campaign, number));
    const TemporaryFolder folder;
    synthetic::publish(folder / "a.h5", campaign, records);
    Evidence evidence = read_evidence(CampaignFile(folder / "a.h5"));
    evidence.design_request = DesignLoadRequest{.exposure = 36, .averaging = 0.4};
    const PageOne page = find_page_one(evidence);
    const double exact = 30 + 20 * std::log(8 / 1.2 * 36 / -std::log(0.9));
    EXPECT_NEAR(estimate_at(page, 0, "design_load").value, exact, 0.25 * exact);
    EXPECT_NEAR(estimate_at(page, 1, "design_load_difference").value,
                estimate_at(page, 1, "design_load").value - estimate_at(page, 0, "design_load").value, 1e-9);
    EXPECT_THAT(page.table.after, HasSubstr("exceeded with 10 % in 0.01 h"));
}

/// Three runs of a hull on one line ahead of it, whose mooring force swings about 100 N and whose offset rises from 0.2
/// to 0.8 m through the run. The line's tension is 1000 N and 1000 N/m times the offset, of at most 2000 N.
class MooredPageOne : public testing::Test {
  protected:
    MooredPageOne() {
        Campaign campaign = synthetic::campaign(3);
        campaign.cases.resize(1);
        Scenario& scenario = campaign.cases.front().scenario;
        scenario.structure.speed = 0.55;
        scenario.analysis.window = 6;
        const double k = 0.98e5 * 4 * std::numbers::pi * std::numbers::pi;
        scenario.moorings = {.mass = 1e5, .gyration = 0.4, .surge = k, .sway = k, .yaw = 0.16 * k};
        scenario.moorings.lines = {{.distance = 1000, .pretension = 1000, .stiffness = 1000, .break_load = 2000}};
        std::vector<MemberRecord> records = synthetic::all_done_records(campaign);
        double tension = 1000;
        for (MemberRecord& record : records) {
            MotionHistory& motion = record.result.motion;
            for (int step = 0; step < scenario.step_count(); ++step) {
                for (const auto& one : motion_histories) (motion.*one.values).push_back(0);
                const double time = (step + 0.5) * scenario.general.time_step;
                motion.surge_mooring.back() = 100 + 10 * std::sin(2 * std::numbers::pi * time);
                motion.surge_offset.back() = 0.2 + 0.6 * step / scenario.step_count();
                motion.line_use.back() = 0.5 * (1 + motion.surge_offset.back());
            }
            record.result.responses = responses_of(scenario, motion);
            record.result.line_tension = {tension += 200};
            record.result.line_broken_at = {std::nan("")};
        }
        synthetic::publish(folder_ / "a.h5", campaign, records);
        evidence_ = read_evidence(CampaignFile(folder_ / "a.h5"));
        page_ = find_page_one(evidence_);
    }

    TemporaryFolder folder_;
    Evidence evidence_;
    PageOne page_;
};

TEST_F(MooredPageOne, RefusesEachFigureByItsOwnTrend) {
    EXPECT_THAT(why_at(page_, 0, "design_offset"), StartsWith("rises, +"));
    EXPECT_THAT(why_at(page_, 0, "design_line_tension"), StartsWith("rises, +"));
    // Three of the four that a design value needs; eight are a beginning. Runs took 13.5 s on average.
    EXPECT_EQ(why_at(page_, 0, "design_mooring_force"), "needs 5 more");
    EXPECT_EQ(page_.next.at(0).first, "8 arrangements, about 68 s of a core");
    const std::string file = evidence_.file.string();  // as it was given
    EXPECT_EQ(page_.next.at(0).second,
              fmt::format("floes run CONFIG.toml -o {} --set campaign.arrangements=8 --resume", file));
    EXPECT_EQ(page_.next.at(1).second, fmt::format("floes design {} --of offset --window auto", file));
}

TEST_F(MooredPageOne, IsTheTableOfTheScreen) {
    const Section screen = overview_section(evidence_);
    const auto printed = [](const Results& table) { return text(std::vector{Section{.results = {table}}}, 100); };
    EXPECT_EQ(printed(screen.results.at(0)), printed(page_.table.results.at(0)));
    EXPECT_THAT(screen.after, HasSubstr(page_.table.after));
    EXPECT_THAT(screen.before, StartsWith("Campaign synthetic: "));
}

// 1200, 1400 and 1600 N of 2000 N: 0.7, t(2) · 0.1 / √3 to either side.
TEST_F(MooredPageOne, HasTheTensionOfEachLineOverItsBreakLoad) {
    ASSERT_TRUE(page_.lines);
    const Results& lines = page_.lines->results.back();
    EXPECT_NEAR(lines.number(0, "ratio"), 0.7, 1e-12);
    EXPECT_NEAR(std::get<Estimate>(lines.at(0, "ratio").get()).high, 0.7 + 4.3027 * 0.1 / std::sqrt(3), 1e-4);
    EXPECT_THAT(page_.table.after, HasSubstr("a safety factor of 1.67 allows 0.60 (dashed)"));
}

// In the window, the last 6 s, the offset ends at 0.8 m: 1.8 kN of 2 kN.
TEST_F(MooredPageOne, HasTheTensionOverTheBreakLoadThatTheRunsHad) {
    const CasePeaks peaks = simulated_peaks(evidence_, *find_design_of("line_tension")).at(0);
    EXPECT_NEAR(peaks.rows.at(0).segment_maxima.back(), 0.9, 2e-3);
}

/// Exponential above an origin, eight in each window, without a trend.
Response peaks_of(int member, std::size_t kind, double origin, double scale) {
    RandomStream random{5, static_cast<std::uint32_t>(member), StreamId::bootstrap, static_cast<std::uint32_t>(kind)};
    Response made{.mean = origin - scale, .rise = 0, .segment_maximum = {}, .peaks = std::vector<double>(8)};
    for (double& peak : made.peaks) peak = origin - scale * std::log(random.uniform(1e-16, 1));
    std::ranges::sort(made.peaks, std::ranges::greater{});
    made.segment_maximum.assign(3, made.peaks.front());
    return made;
}

double scale_of(std::size_t of_case) {
    return of_case == 0 ? 1.0 : 0.5;
}

/// Two cases of 40 members with peaks_of() in all responses. `change`: of the campaign before it is run.
Evidence moored_with_peaks(const TemporaryFolder& folder, const std::function<void(Campaign&)>& change = {}) {
    Campaign campaign = synthetic::campaign(40);
    for (Case& one : campaign.cases) {
        const double k = 0.98e5 * 4 * std::numbers::pi * std::numbers::pi;
        one.scenario.structure.speed = 0.55;
        one.scenario.analysis.window = 6;
        one.scenario.moorings = {.mass = 1e5, .gyration = 0.4, .surge = k, .sway = k, .yaw = 0.16 * k};
        one.scenario.moorings.lines = {{.distance = 1000, .pretension = 1000, .stiffness = 1000, .break_load = 2000}};
    }
    if (change) change(campaign);
    std::vector<MemberRecord> records;
    for (int number = 0; number < member_count(campaign); ++number) {
        MemberRecord& record = records.emplace_back(synthetic::record_with_peaks(campaign, number));
        const double scale = scale_of(static_cast<std::size_t>(number) % campaign.cases.size());
        for (std::size_t kind = 0; kind < response_kinds().size(); ++kind)
            record.result.responses.push_back(peaks_of(number, kind, 2 * scale, scale));
        record.result.line_tension = {1000};
        record.result.line_broken_at = {std::nan("")};
    }
    synthetic::publish(folder / "a.h5", campaign, records);
    return read_evidence(CampaignFile(folder / "a.h5"));
}

// In T the largest of peaks at a rate r is exceeded with 10 % at origin + scale ln(r T / -ln 0.9).
TEST(PageOne, HasTheDesignValuesOfMoorings) {
    const TemporaryFolder folder;
    Evidence evidence = moored_with_peaks(folder);
    constexpr double exposure = 600;
    evidence.design_request = DesignLoadRequest{.exposure = exposure, .averaging = 0.4};
    const PageOne page = find_page_one(evidence);
    const auto exact = [&](std::size_t of_case) {
        return scale_of(of_case) * (2 + std::log(8.0 / 6 * exposure / -std::log(0.9)));
    };
    for (const std::string key : {"design_mooring_force", "design_offset", "design_line_tension", "design_yaw"}) {
        const double shown = key == "design_yaw" ? 1 / unit::degree : 1;
        for (const std::size_t row : {0U, 1U}) {
            const Estimate found = estimate_at(page, row, key);
            EXPECT_LT(found.low, shown * exact(row)) << key << row;
            EXPECT_GT(found.high, shown * exact(row)) << key << row;
        }
        const Estimate difference = estimate_at(page, 1, key + "_difference");
        EXPECT_NEAR(difference.value, estimate_at(page, 1, key).value - estimate_at(page, 0, key).value, 1e-9 * shown)
            << key;
        EXPECT_LT(difference.low, difference.value) << key;
        EXPECT_GT(difference.high, difference.value) << key;
    }
    EXPECT_DOUBLE_EQ(estimate_at(page, 0, "mean_load").value, 20);
    EXPECT_THAT(page.sentence, HasSubstr("in 0.167 h a mooring force of "));
    EXPECT_EQ(page.lines->results.back().number(0, "ratio"), 0.5);
}

// A period of 10 s is too long for a window of 6 s; the others' are of 1 s.
TEST(PageOne, RefusesTheDesignValuesOfTheCaseAlone) {
    const TemporaryFolder folder;
    Evidence evidence = moored_with_peaks(folder, [](Campaign& campaign) {
        Moorings& soft = campaign.cases.at(1).scenario.moorings;
        soft.surge /= 100;
        soft.sway /= 100;
    });
    evidence.design_request = DesignLoadRequest{.exposure = 600, .averaging = 0.4};
    const PageOne page = find_page_one(evidence);
    EXPECT_GT(estimate_at(page, 0, "design_mooring_force").value, 0);
    EXPECT_EQ(why_at(page, 1, "design_mooring_force"), "window too short");
    EXPECT_THAT(none_text(find_simulated_designs(evidence, {.of = *find_design_of("mooring_force")}).of_cases.at(1),
                          evidence.sample.cases.at(1)),
                HasSubstr("is longer than a third of the window"));
}

}  // namespace page_one_test
}  // namespace floes
