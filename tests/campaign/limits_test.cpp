// Campaigns that cannot be held: what is allowed for each key alone may be too much together.

#include <fmt/format.h>
#include <gmock/gmock.h>

#include "campaign/campaign.hpp"
#include "campaign/read.hpp"
#include "support/refusal.hpp"

namespace floes {
namespace limits_test {

using testing::AllOf;
using testing::HasSubstr;

std::string refused(const std::string& text) {
    return refusal([&] { read_campaign({text, "a.toml", {}, true}, nullptr); });
}

std::string cases(int count) {
    std::string text;
    for (int k = 0; k < count; ++k) text += "[[case]]\nname = \"c" + std::to_string(k) + "\"\n";
    return text;
}

// The number of members was an int that had overflowed.
TEST(CampaignLimits, MoreMembersThanCanBeHeldAreRefused) {
    EXPECT_EQ(
        refused("campaign.arrangements = 10000000\n" + cases(3)),
        "a.toml: 3 cases with 10000000 arrangements make 30000000 members, more than the 20000000 that a campaign "
        "can hold; take fewer of either, or run several campaigns");
    EXPECT_NO_THROW(read_campaign({"campaign.arrangements = 10000000\n" + cases(2), "a.toml", {}, true}, nullptr));
}

// Each value was compared with all earlier ones.
TEST(CampaignLimits, AnAxisOfMoreValuesThanCasesIsRefused) {
    std::string values;
    for (int k = 1; k <= 100'001; ++k) values += std::to_string(k) + "e-6,";
    EXPECT_EQ(
        refused("design.method = \"grid\"\n[[design.axis]]\nkey = \"ice.thickness_m\"\nvalues = [" + values + "]"),
        "a.toml:4: the axis ice.thickness_m has 100001 values; no more than 100000 are allowed");
}

TEST(CampaignLimits, ALongListAtEveryPointIsRefused) {
    std::string profile = "[-1, 1]";
    for (int k = 0; k < 100; ++k) profile += ", [1, 1]";
    EXPECT_EQ(refused("design.method = \"grid\"\n[[design.axis]]\nkey = \"structure.profile_m\"\nvalues = [[" +
                      profile + "]]\n[[design.axis]]\nkey = \"general.iterations\"\nvalues = [" +
                      [] {
                          std::string values;
                          for (int k = 1; k < 10'000; ++k) values += std::to_string(k) + ",";
                          return values;
                      }() +
                      "]"),
              "a.toml: 9999 cases of the design have 3049695 values of its axes, more than the 2000000 that can be "
              "held; take fewer points or fewer axes");
}

TEST(CampaignLimits, LongNamesOfCasesAreRefused) {
    EXPECT_THAT(refused("[[case]]\nname = \"" + std::string(201, 'a') + "\""),
                HasSubstr("is longer than the 200 characters that the name of a case may have"));
    EXPECT_THAT(refused("design.method = \"grid\"\n[[design.axis]]\nkey = \"joint.cfm\"\nvalues = [0.01]\n[[case]]\n"
                        "name = \"" +
                        std::string(199, 'a') + "\""),
                HasSubstr("+0.01 is longer than 200 characters; give the [[case]] a shorter one"));
}

TEST(CampaignLimits, AProfileOfManyPointsIsRefused) {
    std::string points;
    for (int k = 0; k <= 1000; ++k) points += "[" + std::to_string(k - 500) + ", 1],";
    EXPECT_THAT(refused("structure.profile_m = [" + points + "]"), HasSubstr("has more than 1000 points"));
}

TEST(CampaignLimits, ListsOfAllCasesAreCounted) {
    Scenario scenario;
    scenario.analysis.exceedance_levels.assign(10'000'000, 1.0);
    HeldNumbers held("a.toml");
    held.add(scenario);
    held.add(scenario);
    EXPECT_EQ(refusal([&] { held.add(scenario); }),
              "a.toml: poses, outlines, profiles, levels and times of all cases are more than 30000000 numbers, which "
              "cannot be "
              "held; take fewer cases or shorter lists");
}

// A key in which one case differs is written out in each. The run began, and its journal could not be read again.
TEST(CampaignLimits, ACampaignWhoseResolvedTextCouldNotBeReadAgainIsRefused) {
    std::string levels;
    for (int k = 0; k < 1000; ++k) levels += fmt::format("{}, ", k);
    const std::string table = "analysis.exceedance_levels_N = [" + levels + "]\n";
    EXPECT_NO_THROW(read_campaign({table + cases(4'100), "a.toml", {}, true}, nullptr)) << "written once";
    EXPECT_THAT(refused(table + cases(4'100) + "analysis.exceedance_levels_N = [1.0]\n"),
                AllOf(HasSubstr("a.toml, with all keys written out: a text with 4"),
                      HasSubstr("more values than can be held; allowed: 4000000; take fewer cases, poses or values")));
}

TEST(CampaignLimits, APoseFileHasNoMorePosesThanAFieldMayHaveFloes) {
    std::string text = "x_m,z_m,yaw_deg\n";
    for (int k = 0; k <= 1'000'000; ++k) text += "1,2,3\n";
    EXPECT_EQ(refusal([&] { read_poses(text, "a.csv"); }),
              "a.csv:1000002: there are more than 1000000 poses, the most floes of a field");
}

// The resolved text had that name and could not be read again.
TEST(CampaignLimits, AFileNameThatIsNotUtf8NamesNoCampaign) {
    EXPECT_EQ(refusal([] {
                  read_campaign({"", "\xff.toml", {}, true}, nullptr);
              }),
              "The name of the configuration file is not UTF-8, so it cannot name the campaign; give campaign.name.");
    EXPECT_EQ(read_campaign({"campaign.name = \"a\"", "\xff.toml", {}, true}, nullptr).name, "a");
}

}  // namespace limits_test
}  // namespace floes
