// A campaign on one screen: what is wrong with it first, and only intervals that say something.

#include "findings/overview.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "findings/answer.hpp"
#include "findings/cases.hpp"
#include "findings/example.hpp"
#include "findings/summary.hpp"

namespace floes {
namespace overview_test {

using testing::ContainsRegex;
using testing::ElementsAre;
using testing::EndsWith;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;
using testing::StartsWith;

/// Three cases of four arrangements, all of them done.
CampaignTable whole() {
    CampaignTable table = example::campaign();
    table.members[4] = example::done(1, 1, 31, 0.04, 3);
    table.members[10] = example::done(1, 3, 33, 0.02, 3);
    return table;
}

Evidence evidence_with(const CampaignTable& table) {
    Evidence evidence = evidence_of({}, table);
    evidence.file = "a.h5";
    return evidence;
}

std::string overview(Evidence evidence, int width) {
    return text(std::vector{overview_section(evidence), next_commands(evidence, "floes")}, width);
}

TEST(Overview, FitsAScreen) {
    const std::string text = overview(evidence_with(whole()), 80);
    EXPECT_LE(std::ranges::count(text, '\n'), 23) << text;
    EXPECT_THAT(text, StartsWith("Campaign example: 12 members, 3 cases x 4 arrangements.\n\ncase "));
    EXPECT_THAT(text, ContainsRegex("\nE30 +4 +27\\.0 ± 4\\.1 "));
    EXPECT_THAT(text, HasSubstr("mean - E30, N"));
    EXPECT_THAT(text, HasSubstr("  floes report a.h5 "));
    EXPECT_THAT(text, HasSubstr("  floes replay a.h5 --worst -o worst.html "));
}

TEST(Overview, IsNoWiderThanTheScreen) {
    for (const int width : {60, 80, 120}) {
        Evidence evidence = evidence_with(whole());
        std::string text = floes::text(std::vector{overview_section(evidence)}, width);
        for (std::size_t end = text.find('\n'); end != std::string::npos; end = text.find('\n')) {
            EXPECT_LE(text_width(text.substr(0, end)), static_cast<std::size_t>(width)) << text.substr(0, end);
            text.erase(0, end + 1);
        }
    }
}

TEST(Overview, ComparesWithTheFirstCaseOrWithTheOneAskedFor) {
    Evidence evidence = evidence_with(whole());
    // E60 - E30 in the four arrangements: 4, 3, 10 and 3.
    EXPECT_THAT(overview(evidence, 80), ContainsRegex("\nE60 .*\\+5\\.0 ± 5\\.4\n"));
    evidence.reference = 1;
    EXPECT_THAT(overview(evidence, 80), ContainsRegex("\nE30 .*-5\\.0 ± 5\\.4\n"));
    EXPECT_THAT(overview(evidence, 80), HasSubstr("mean - E60, N"));
}

TEST(Overview, PrintsNoIntervalOfTwoArrangements) {
    CampaignTable table = whole();
    table.members.resize(6);
    const std::string text = overview(evidence_with(table), 80);
    EXPECT_THAT(text, HasSubstr("\n! n = 2: no interval worth printing; about "));
    EXPECT_THAT(text, ContainsRegex("\nE30 +2 +27\\.0 ± – "));
    EXPECT_THAT(text, ContainsRegex("\nE60 .*\\+3\\.5 ± –\n"));
}

TEST(Warnings, AreNoneWhereNothingIsWrong) {
    EXPECT_THAT(warnings_of(whole(), summarise(whole())), IsEmpty());
}

TEST(Warnings, SayWhatFailedAndWhatIsMissing) {
    const CampaignTable table = example::campaign();
    const std::vector<std::string> told = warnings_of(table, summarise(table));
    ASSERT_EQ(told.size(), 3u);
    EXPECT_EQ(told[0], "1 of 12 members failed and counts in no figure. Member 4: floe 3 sank.");
    EXPECT_THAT(told[1], StartsWith("1 of 12 members has no result yet. Short runs finish first"));
    EXPECT_THAT(told[2], StartsWith("n = 2 (E60): no interval worth printing; "));
}

TEST(Warnings, SayWhereMostStepsEndBeforeContactsAreSolved) {
    CampaignTable table = whole();
    const auto with = [&](int most, double sweeps) {
        for (CaseRow& one : table.cases) one.most_sweeps = 0;
        table.cases[1].most_sweeps = most;
        for (MemberRow& row : table.members) row.mean_sweeps = sweeps;
        return warnings_of(table, summarise(table));
    };
    EXPECT_THAT(with(20, 17.9), IsEmpty());
    EXPECT_THAT(with(0, 20), IsEmpty()) << "all steps take as many";
    const std::vector<std::string> told = with(20, 19.7);
    ASSERT_EQ(told.size(), 1u);
    EXPECT_THAT(told[0], StartsWith("Contacts are not solved in most steps (sweeps a step: " +
                                    summarise(table).label_of(1) + ", 19.7 of at most 20)"));
    EXPECT_THAT(told[0], EndsWith("Try general.iterations = 200."));
}

TEST(Warnings, SayWhereIceNeverTouchedTheStructure) {
    CampaignTable table = whole();
    for (const std::size_t member : {std::size_t{0}, std::size_t{3}, std::size_t{6}, std::size_t{9}, std::size_t{1}})
        table.members[member] =
            example::done(table.members[member].case_index, table.members[member].arrangement, 0, 0, 0);
    EXPECT_THAT(warnings_of(table, summarise(table)).at(0),
                StartsWith("Ice never touched the structure in 5 of 12 members: their loads are 0 (all of E30)."));
}

// Of two members a case nothing is known together, so those that are not steady by themselves are counted.
TEST(Warnings, SayThatMembersAreNotSteadyUnlessChanceWouldDo) {
    CampaignTable table = whole();
    EXPECT_THAT(warnings_of(table, summarise(table)), IsEmpty());  // member 3 alone is not steady
    std::erase_if(table.members, [](const MemberRow& row) { return row.arrangement > 1; });
    for (MemberRow& row : table.members) {
        row.load.steady = false;
        row.load.trend = 0.1;
    }
    EXPECT_THAT(warnings_of(table, summarise(table)).at(0),
                StartsWith("6 of 6 members not steady: the load still rises in the measured window."));
    table.members[0].load.trend = -0.1;
    EXPECT_THAT(warnings_of(table, summarise(table)).at(0), HasSubstr("the load still has a trend"));
}

TEST(Printable, AreIntervalsThatSaySomething) {
    EXPECT_TRUE(says_something(20, {15, 25}, 3));
    EXPECT_FALSE(says_something(20, {15, 25}, 2));
    EXPECT_FALSE(says_something(300, {17, 1666}, 4));
    EXPECT_FALSE(says_something(20, {20, 20}, 8));
    EXPECT_FALSE(says_something(20, {std::nan(""), std::nan("")}, 8));
    const Quantity& order = *find_quantity("local_order");  // it may be of either sign
    EXPECT_TRUE(says_something(0.01, {-0.2, 0.22}, 8, kind_of(order)));
    EXPECT_FALSE(says_something(0.5, {0, 1}, 4, kind_of(quantity("failure_ratio"))));
}

// 26, 28, 24, 30 N: s = 2.582; t(n - 1) s / √n <= 2.7 N first holds for n = 7: 2.447 · 2.582 / 2.646 = 2.39 N, for 6
// 2.71 N.
TEST(Printable, SaysHowManyArrangementsWouldDo) {
    const Interval found = mean_interval(std::vector<double>{26, 28, 24, 30});
    EXPECT_EQ(arrangements_for(found, 4, 0.1), 7);
    EXPECT_EQ(arrangements_for(found, 1, 0.1), 0);
}

TEST(LoadColumns, TakeTheLoadOverOneSecondInTheUnitOfTheCampaign) {
    CampaignTable table = whole();
    EXPECT_EQ(load_columns(summarise(table))[1].words, "largest of a step");
    table.averaging_times = {0.5, 1, 2};
    for (MemberRow& row : table.members) {
        row.load.mean *= 1e6;
        row.load.maximum *= 1e6;
        row.load.mean_maximum *= 1e6;
        for (const double time : table.averaging_times) row.averaged.push_back({time, 1, {}, 4e6 / time, 1});
    }
    Evidence evidence = evidence_with(table);
    EXPECT_EQ(load_columns(evidence.summary)[1].words, "largest over 1 s");
    const std::string text = floes::text(std::vector{overview_section(evidence)}, 100, evidence.units);
    EXPECT_THAT(text, ContainsRegex("mean load, MN +largest over 1 s, MN"));
    EXPECT_THAT(text, ContainsRegex("E30 +4 +27\\.0 ± 4\\.1 +4\\.0 in all"));
}

}  // namespace overview_test
}  // namespace floes
