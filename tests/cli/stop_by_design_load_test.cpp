// The stop rule on a design load and floes design say the same of the same members.

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include <nlohmann/json.hpp>

#include "cli/verb_output.hpp"
#include "core/units.hpp"
#include "member/design_of.hpp"
#include "run/campaign_status.hpp"
#include "support/published.hpp"
#include "support/temporary_folder.hpp"

namespace floes {
namespace stop_by_design_load_test {

class StopByDesignLoad : public testing::Test {
  protected:
    StopByDesignLoad() {
        campaign_.stop.half_width = 0.01;
        campaign_.stop.of = "design_load";
        campaign_.stop.averaging = 0.4;
        campaign_.stop.exposure = 0.01 * unit::hour;
        for (Case& one : campaign_.cases) one.scenario.analysis.peak_separation = 0.01;  // peaks hide none
        for (int number = 0; number < member_count(campaign_); ++number)
            records_.push_back(synthetic::record_with_peaks(campaign_, number));
        records_[4] = synthetic::failed_record(campaign_, 4);
    }

    /// The longest half-width of all cases, of "expected" or "quantile" in the answer of floes design.
    double by_design(const std::string& arguments, const std::string& which, const std::string& value_key = "load") {
        const std::string averaging = value_key == "load" ? " --averaging-s 0.4" : "";
        const std::string told = verb_output(
            add_design, "design " + file_.string() + averaging + " --exposure-h 0.01 --format json " + arguments);
        double longest = 0;
        const auto all = nlohmann::json::parse(told);
        for (const auto& load : all.at("design").at("loads")) {
            if (load.at("method") != "both tails") continue;
            if (load.at("figure") != which) continue;
            const double value = load.at(value_key);
            longest = std::max({longest, load.at(value_key + "_high").get<double>() / value - 1,
                                1 - load.at(value_key + "_low").get<double>() / value});
        }
        return longest;
    }

    double by_rule() {
        synthetic::publish(file_, campaign_, records_);
        const StopStatus stop = *read_status(file_).stop;
        EXPECT_EQ(stop.obstacle, "");
        return stop.achieved;
    }

    Campaign campaign_ = synthetic::campaign(15);
    std::vector<MemberRecord> records_;
    TemporaryFolder folder_;
    std::filesystem::path file_ = folder_ / "synthetic.h5";
};

TEST_F(StopByDesignLoad, HasTheHalfWidthThatDesignPrints) {
    const double rule = by_rule();
    EXPECT_GT(rule, 0.05);
    EXPECT_NEAR(rule, by_design("--quantile 0.9", "quantile"), 1e-12);
    campaign_.stop.quantile = 0.99;
    const double rarer = by_rule();
    EXPECT_GT(rarer, rule);
    EXPECT_NEAR(rarer, by_design("--quantile 0.99", "quantile"), 1e-12);
}

TEST_F(StopByDesignLoad, HasThatOfTheExpectedLargest) {
    campaign_.stop.quantile = 0;
    const double rule = by_rule();
    EXPECT_GT(rule, 0.05);
    EXPECT_NEAR(rule, by_design("--quantile 0.9", "expected"), 1e-12);
}

// A hull whose offset has peaks of unlike height, without a trend.
TEST_F(StopByDesignLoad, HasThatOfAStructureThatGivesWay) {
    for (Case& one : campaign_.cases) {
        const double k = 0.98e5 * 4 * std::numbers::pi * std::numbers::pi;
        one.scenario.structure.speed = 0.55;
        one.scenario.analysis.window = 6;
        one.scenario.moorings = {.mass = 1e5, .gyration = 0.4, .surge = k, .sway = k, .yaw = 0.16 * k};
    }
    campaign_.arrangements = 40;
    for (int number = static_cast<int>(records_.size()); number < member_count(campaign_); ++number)
        records_.push_back(synthetic::record_with_peaks(campaign_, number));
    for (std::size_t member = 0; member < records_.size(); ++member) {
        records_[member].case_key = case_fingerprint(campaign_, static_cast<int>(member % campaign_.cases.size()));
        if (records_[member].result.status != MemberStatus::done) continue;
        const Scenario& scenario = campaign_.cases[member % campaign_.cases.size()].scenario;
        MotionHistory motion;
        for (int step = 0; step < scenario.step_count(); ++step) {
            for (const auto& one : motion_histories) (motion.*one.values).push_back(0);
            const auto drawn = static_cast<double>((member * 379 + static_cast<std::size_t>(step) * 53) % 997);
            const double higher = 1 - std::log((drawn + 0.5) / 997);
            motion.surge_offset.back() = step % 2 == 0 ? 0.1 : 0.1 + 0.02 * higher;
        }
        records_[member].result.responses = responses_of(scenario, motion);
    }
    campaign_.stop.of = "design_offset";
    const double rule = by_rule();
    EXPECT_GT(rule, 0.01);
    EXPECT_NEAR(rule, by_design("--of offset", "quantile", "offset"), 1e-12);
}

}  // namespace stop_by_design_load_test
}  // namespace floes
