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

}  // namespace
}  // namespace floes
