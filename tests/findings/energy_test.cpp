#include "findings/catalogue.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "findings/example.hpp"

namespace floes {
namespace energy_test {

using testing::HasSubstr;

/// Of each load 60 % goes into friction of ice on ice and 40 % into lifting; E200 is of a file without the work.
Evidence with_work() {
    CampaignTable table = example::campaign();
    for (MemberRow& row : table.members) {
        const double nothing = row.case_index == 2 ? std::nan("") : 0;
        for (const auto share : all_work_shares) row.work.*share = nothing;
        row.work.ice_friction = 0.6 * row.load.mean + nothing;
        row.work.lifting = 0.4 * row.load.mean + nothing;
    }
    return evidence_of({}, table);
}

TEST(Energy, IsTheMeanLoadByCase) {
    const Evidence evidence = with_work();
    const Results found = find_energy(evidence.sample, evidence.summary);
    constexpr std::size_t shares = all_work_shares.size();
    ASSERT_EQ(found.rows.size(), 2 * shares);  // of two cases
    EXPECT_EQ(found.name(0, "quantity"), "work_ice_friction");
    EXPECT_DOUBLE_EQ(found.number(0, "force"), 0.6 * 27);
    EXPECT_DOUBLE_EQ(found.number(0, "share"), 0.6);
    EXPECT_EQ(found.number(0, "members"), 4);
    EXPECT_EQ(found.name(shares, "case"), "E60");
    EXPECT_EQ(found.number(shares, "members"), 2);  // the others failed or are missing
    double sum = 0;
    for (std::size_t r = 0; r < shares; ++r) sum += found.number(r, "force");
    EXPECT_NEAR(sum, 27, 1e-12);
}

TEST(Energy, IsATableWithADashForCasesThatDidNotMeasureIt) {
    Evidence evidence = with_work();
    const std::vector<Section> sections{energy_section(evidence)};
    const std::string shown = text(sections, 120);
    EXPECT_THAT(shown, testing::ContainsRegex(
                           "friction, ice on ice +16.20 \\[13.7[0-9], 18.6[0-9]\\] +60 +19.20 +(\\[|–).* 60"));
    EXPECT_THAT(shown, testing::ContainsRegex("together +27.00 .*100 +32.00 .*100"));
    EXPECT_THAT(csv(sections), HasSubstr("E30,work_lifting,10.8,"));
}

TEST(Energy, ShowsWhatDrivesTheIceOnlyWhereSomethingDoes) {
    Evidence evidence = with_work();
    EXPECT_THAT(text(std::vector{energy_section(evidence)}, 120), testing::Not(HasSubstr("give way")));
    evidence.table.members.front().work.driving = -1;
    evidence = evidence_of({}, evidence.table);
    EXPECT_THAT(text(std::vector{energy_section(evidence)}, 120), HasSubstr("sheets that give way and wind"));
}

TEST(Energy, SaysWhereNobodyMeasuredIt) {
    CampaignTable table = with_work().table;
    for (MemberRow& row : table.members)
        for (const auto share : all_work_shares) row.work.*share = std::nan("");
    Evidence evidence = evidence_of({}, std::move(table));
    EXPECT_THAT(energy_section(evidence).missing, HasSubstr("computed without it"));
}

}  // namespace energy_test
}  // namespace floes
