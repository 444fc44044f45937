// floes contour, from files on the disk to standard output, pictures and cases that can be run.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>

#include "campaign/read.hpp"
#include "cli/verb_output.hpp"
#include "core/error.hpp"
#include "support/file_bytes.hpp"
#include "support/refusal.hpp"
#include "support/temporary_folder.hpp"

namespace floes {
namespace contour_test {

using testing::HasSubstr;

class ContourVerb : public testing::Test {
  protected:
    ContourVerb() {
        put("ice.toml",
            "hours_per_year = 600\n[[input]]\nkey = \"ice.thickness_m\"\ndistribution = \"weibull\"\nscale = 0.03\n"
            "shape = 3\n[[input]]\nkey = \"structure.speed_m_s\"\ndistribution = \"normal\"\nmean = 0.25\nsd = 0.05\n");
        put("my.toml",
            "[campaign]\narrangements = 7\n[field]\nbegin_m = 3\n[analysis]\nsteady_start_s = 5\nwindow_s = 24\n");
        put("two.toml", "[[case]]\nname = \"A\"\n[[case]]\nname = \"B\"\nice.thickness_m = 0.04\n");
    }

    void put(const std::string& name, const std::string& text) { std::ofstream(folder_ / name) << text; }
    std::string path(const std::string& name) const { return (folder_ / name).string(); }
    std::string got(const std::string& name) const { return file_text(folder_ / name); }
    std::string contour(const std::string& arguments) {
        return verb_output(add_contour, "contour " + path("ice.toml") + " " + arguments);
    }

    TemporaryFolder folder_;
};

TEST_F(ContourVerb, TellsPoints) {
    EXPECT_THAT(contour(""), HasSubstr("10^-4, 0°"));
    EXPECT_THAT(contour("--per-year 0.01 --points 4 --format csv"), HasSubstr("per_year,radius,angle_deg"));
}

TEST_F(ContourVerb, WritesAPictureAndAPage) {
    contour("-o " + path("a.svg"));
    EXPECT_THAT(got("a.svg"), testing::StartsWith("<svg"));
    contour("-o " + path("a.html"));
    EXPECT_THAT(got("a.html"), HasSubstr("Environmental contours"));
    EXPECT_THAT(got("a.html"), HasSubstr("--per-year 0.01,0.0001 --exposure-h 3 --points 12 -o "));
}

TEST_F(ContourVerb, WritesCasesThatAreACampaign) {
    contour("--per-year 0.01,0.01 --points 8 --config " + path("my.toml") + " -o " + path("cases.toml"));
    const Campaign campaign = read_campaign({got("cases.toml"), "cases.toml", {}}, nullptr);
    EXPECT_EQ(campaign.arrangements, 7);
    ASSERT_FALSE(campaign.cases.empty());
    EXPECT_EQ(campaign.cases[0].name, "0.01_deg000");
    EXPECT_NEAR(campaign.cases[0].scenario.structure.speed, 0.25, 1e-12);
    EXPECT_GT(campaign.cases[0].scenario.floe.thickness, 0.045);
    EXPECT_TRUE(campaign.run.base_case.empty());
}

/// The thinnest ice wants a shorter step, and the slowest states would drift backwards.
TEST_F(ContourVerb, LeavesOutWhatCannotBeRun) {
    std::string slow = got("ice.toml");
    put("slow.toml", slow.replace(slow.find("sd = 0.05"), 9, "sd = 0.08"));
    testing::internal::CaptureStderr();
    verb_output(add_contour, "contour " + path("slow.toml") + " --per-year 0.0001 --points 4 --config " +
                                 path("my.toml") + " -o " + path("cases.toml"));
    const std::string said = testing::internal::GetCapturedStderr();
    const Campaign campaign = read_campaign({got("cases.toml"), "cases.toml", {}}, nullptr);
    EXPECT_EQ(campaign.cases.size(), 2u);
    EXPECT_THAT(said, HasSubstr("2 points cannot be run and are left out: 0.0001_deg180, 0.0001_deg270. The first: "
                                "0.0001_deg180:13: general.time_step_s = 0.02 is too long for ice.thickness_m = "));
}

TEST_F(ContourVerb, RefusesWhatItCannotWrite) {
    EXPECT_THAT(refusal([&] { contour("-o " + path("a.png")); }),
                HasSubstr("give a name that ends with .toml, .svg or .html"));
    EXPECT_THAT(refusal([&] { contour("-o " + path("a.toml")); }), HasSubstr("say which with --config"));
    EXPECT_THAT(refusal([&] { contour("-o " + path("a.toml") + " --config " + path("two.toml")); }),
                HasSubstr("this campaign has several; name it with --case: A, B"));
    EXPECT_THROW(contour("--points 2"), CommandLineEnd);
    EXPECT_THROW(contour("--per-year 1"), CommandLineEnd);
}

}  // namespace contour_test
}  // namespace floes
