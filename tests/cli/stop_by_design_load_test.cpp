// The stop rule on a design load and floes design say the same of the same members.

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "campaign_file/publish.hpp"
#include "cli/verb_output.hpp"
#include "core/units.hpp"
#include "run/campaign_status.hpp"
#include "support/synthetic.hpp"
#include "support/temporary_folder.hpp"

namespace floes {
namespace stop_by_design_load_test {

class StopByDesignLoad : public testing::Test {
  protected:
    StopByDesignLoad() {
        campaign_.stop.half_width = 0.01;
        campaign_.stop.of = design_load_word;
        campaign_.stop.averaging = 0.4;
        campaign_.stop.exposure = 0.01 * unit::hour;
        for (Case& one : campaign_.cases) one.scenario.analysis.peak_separation = 0.01;  // peaks hide none
        for (int number = 0; number < member_count(campaign_); ++number)
            records_.push_back(synthetic::record_with_peaks(campaign_, number));
        records_[4] = synthetic::failed_record(campaign_, 4);
    }

    /// The longest half-width of all cases, of "expected" or "quantile" in the answer of floes design.
    double by_design(const std::string& arguments, const std::string& which) {
        const std::string told = verb_output(
            add_design, "design " + file_.string() + " --averaging-s 0.4 --exposure-h 0.01 --format json " + arguments);
        double longest = 0;
        const auto all = nlohmann::json::parse(told);
        for (const auto& load : all.at("design").at("loads")) {
            if (load.at("method") != "both tails") continue;
            if (load.at("figure") != which) continue;
            const double value = load.at("load");
            longest = std::max({longest, load.at("load_high").get<double>() / value - 1,
                                1 - load.at("load_low").get<double>() / value});
        }
        return longest;
    }

    double by_rule() {
        publish(file_, campaign_, records_, std::vector<Session>{synthetic::session()});
        return read_status(file_).stop->achieved;
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

}  // namespace stop_by_design_load_test
}  // namespace floes
