// The verb `plan`, from a configuration to standard output.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <nlohmann/json.hpp>

#include "cli/verb_output.hpp"
#include "core/error.hpp"
#include "store/journal.hpp"
#include "support/published.hpp"
#include "support/temporary_folder.hpp"

namespace floes {
namespace plan_test {

using nlohmann::json;
using testing::HasSubstr;

// Standard output of `floes plan CONFIG arguments…`.
std::string plan(const std::string& arguments) {
    return verb_output(add_plan, "plan " FLOES_SOURCE_DIR "/configs/table3.toml " + arguments);
}

TEST(Plan, GivesJsonOfEverySetting) {
    const json answer = json::parse(plan("--cores 1,150 --ranks 1,2 --format json"));
    EXPECT_EQ(answer.at("campaign"), "table3");
    EXPECT_EQ(answer.at("members"), 150);
    const json& one = answer.at("plans").at(0);
    const json& all = answer.at("plans").at(1);
    EXPECT_EQ(all.at("ranks"), 2);
    const double mean = answer.at("mean_run_time_s");
    EXPECT_NEAR(one.at("wall_time_s").get<double>(), 150 * mean, 0.01 * 150 * mean);
    EXPECT_NEAR(one.at("core_hours").get<double>(), 150 * mean / 3600, 0.01 * 150 * mean / 3600);
    const double longest = answer.at("longest_run_time_s");
    const json lean = json::parse(plan("--cores 1 --record-bytes 5000 --format json"));
    EXPECT_EQ(lean.at("plans").at(0).at("journal_bytes"), 150 * 5000.0);
    EXPECT_NEAR(all.at("wall_time_s").get<double>(), longest, 2.0);  // a member a core
}

TEST(Plan, GivesATableThatSaysWhereTheTimesComeFrom) {
    const std::string text = plan("--cores 400");
    EXPECT_THAT(text, HasSubstr("table3: 150 members"));
    EXPECT_THAT(text, HasSubstr("Run times: the expected cost of each member"));
    EXPECT_THAT(text, HasSubstr("400 cores: too few members;"));
    EXPECT_EQ(std::ranges::count(plan("--cores 2,4 --format csv"), '\n'), 3);
}

TEST(Plan, CountsOneMemberAsOne) {
    const TemporaryFolder folder;
    std::ofstream(folder / "one.toml") << "[campaign]\narrangements = 1\n";
    const std::string text = verb_output(add_plan, "plan " + (folder / "one.toml").string());
    EXPECT_THAT(text, HasSubstr("one: 1 member of"));
}

TEST(Plan, TakesRunTimesFromACampaignFileAndFromItsJournal) {
    const TemporaryFolder folder;
    Campaign campaign = synthetic::campaign();
    const auto records = synthetic::records(campaign);
    synthetic::publish(folder / "a.h5", campaign, records);
    const std::string of_file = plan("--from " + (folder / "a.h5").string() + " --format json");
    EXPECT_THAT(of_file, HasSubstr("10 measured members of synthetic"));  // of 12 one failed and one is missing
    Journal journal = open_journal(folder / "a.journal", campaign, Existing::refuse);
    for (const MemberRecord& record : records) journal.append(record);
    journal.hand_over();
    const std::string of_journal = plan("--from " + (folder / "a.h5").string() + " --format json");
    EXPECT_EQ(json::parse(of_file).at("mean_run_time_s"), json::parse(of_journal).at("mean_run_time_s"));
}

TEST(Plan, RefusesWhatCannotBe) {
    EXPECT_THROW(plan("--cores 2 --ranks 3"), InputError);
    EXPECT_THROW(plan("--cores 2,4,8 --ranks 1,2"), InputError);
    EXPECT_THROW(plan("--from nowhere.h5"), InputError);
    EXPECT_THROW(plan("--cores 0"), CommandLineEnd);
}

}  // namespace plan_test
}  // namespace floes
