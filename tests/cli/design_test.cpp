// The verb `design`, from a campaign file on the disk to standard output.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "campaign_file/publish.hpp"
#include "cli/verb_output.hpp"
#include "core/error.hpp"
#include "support/refusal.hpp"
#include "support/synthetic.hpp"
#include "support/temporary_folder.hpp"

namespace floes {
namespace {

using testing::HasSubstr;

/// The file of a campaign in whose first two cases a hull of 0.5 s can swing; `histories`: it has those.
void publish_long(const std::filesystem::path& file, bool histories) {
    Campaign campaign = synthetic::campaign();
    for (Case& one : campaign.cases) one.scenario.analysis.keep_history = histories;
    for (const std::size_t index : {0u, 1u}) {
        campaign.cases[index].scenario.structure.speed = 1.1;  // or the hull meets the field's end
        campaign.cases[index].scenario.analysis.window = 3;
    }
    std::vector<MemberRecord> records = synthetic::records(campaign);
    if (!histories)
        for (MemberRecord& record : records) record.result.history = {};
    publish(file, campaign, records, std::vector<Session>{synthetic::session()});
}

class Design : public testing::Test {
  protected:
    Design() {
        const Campaign campaign = synthetic::campaign();
        publish(file_, campaign, synthetic::records(campaign), std::vector<Session>{synthetic::session()});
    }

    std::string design(const std::string& arguments) {
        return verb_output(add_design, "design " + file_.string() + " " + arguments);
    }

    TemporaryFolder folder_;
    std::filesystem::path file_ = folder_ / "synthetic.h5";
};

// Members of the synthetic campaign have one to three peaks.
TEST_F(Design, SaysWhereThereAreTooFewPeaks) {
    EXPECT_THAT(design("--averaging-s 0.4"), HasSubstr("open: too few peaks ("));
    EXPECT_THAT(design("--averaging-s 0.4"), HasSubstr(" arrangements would do."));
    EXPECT_THAT(design("--averaging-s 0.4"), testing::StartsWith("! 1 of 12 members failed"));
    EXPECT_THAT(design("--averaging-s 0.4"), testing::Not(HasSubstr("nan")));
    EXPECT_TRUE(nlohmann::json::parse(design("--averaging-s 0.4 --format json")).at("design").at("loads").empty());
}

TEST_F(Design, RefusesWhatItCannotAnswer) {
    EXPECT_THAT(refusal([&] { design("--averaging-s 33"); }),
                HasSubstr("The members did not average the load over 33 s"));
    EXPECT_THROW(design("--exposure-h -1"), CommandLineEnd);
    EXPECT_THROW(design("--quantile 1"), CommandLineEnd);
    EXPECT_THROW(design("--scale 0.5"), CommandLineEnd);
}

// 0.5 s: 25 values, and a sixth of the window of two cases; that of the third is too short.
constexpr const char* hull = "--mooring-kN-m 1000 --mass-t 6.333 --damping-percent 30 ";

TEST_F(Design, MovesAMooredHull) {
    publish_long(file_, true);
    const std::string told = design(hull);
    EXPECT_THAT(told, HasSubstr("Design mooring force: the largest k x in 3 h"));
    EXPECT_THAT(told, HasSubstr("Moored hull: 1000 kN/m, 6.333 t, 30 % of the critical damping; natural period 0.5 s"));
    EXPECT_THAT(told,
                HasSubstr("open: not answered: the natural period of 0.5 s is longer than a third of the window"));
    const nlohmann::json json = nlohmann::json::parse(design(std::string(hull) + "--format json"));
    const nlohmann::json& soft = json.at("moored").at("cases").at(0);
    EXPECT_EQ(soft.at("case"), "soft");
    EXPECT_EQ(soft.at("runs"), 4);
    EXPECT_GT(soft.at("largest_force_N"), 0);
    EXPECT_EQ(json.at("moored").at("cases").size(), 2u);
}

TEST_F(Design, RefusesAHullThatItCannotMove) {
    EXPECT_THROW(design("--mooring-kN-m 1000"), CommandLineEnd);
    EXPECT_THROW(design("--mass-t 3 --damping-percent 20"), CommandLineEnd);
    EXPECT_THROW(design(std::string(hull) + "--regimes year.toml"), CommandLineEnd);
    EXPECT_THAT(refusal([&] { design("--mooring-kN-m 0 --mass-t 2 --damping-percent 20"); }), HasSubstr("above 0"));
    EXPECT_THAT(refusal([&] { design("--mooring-kN-m 1 --mass-t 2280 --damping-percent 20"); }),
                HasSubstr("longer than a third of the window"));
}

TEST_F(Design, SaysWhichKeyStoresTheHistoriesThatAHullNeeds) {
    publish_long(file_, false);
    EXPECT_THAT(refusal([&] { design(hull); }), HasSubstr("analysis.history_steps"));
}

}  // namespace
}  // namespace floes
