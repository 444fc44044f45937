#include "findings/energy_section.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "findings/example.hpp"

namespace floes {
namespace {

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
    const std::vector<EnergyRow> rows = find_energy(with_work().table);
    ASSERT_EQ(rows.size(), 2 * all_work_shares.size());  // of two cases
    EXPECT_EQ(rows[0].key, "work_ice_friction");
    EXPECT_DOUBLE_EQ(rows[0].force.estimate, 0.6 * 27);
    EXPECT_DOUBLE_EQ(rows[0].share, 0.6);
    EXPECT_EQ(rows[0].members, 4);
    EXPECT_EQ(rows[all_work_shares.size()].case_index, 1U);
    EXPECT_EQ(rows[all_work_shares.size()].members, 2);  // the others failed or are missing
    double sum = 0;
    for (const EnergyRow& row : rows) sum += row.case_index == 0 ? row.force.estimate : 0;
    EXPECT_NEAR(sum, 27, 1e-12);
}

TEST(Energy, IsATableWithADashForCasesThatDidNotMeasureIt) {
    Evidence evidence = with_work();
    const std::vector<Section> sections{energy_section(evidence)};
    const std::string shown = text(sections, 120);
    EXPECT_THAT(shown, testing::ContainsRegex("friction, ice on ice +16.20 ± 2.4[0-9] +60 +19.20 ± [0-9.]+ +60 +–"));
    EXPECT_THAT(shown, testing::ContainsRegex("together +27.00 +100 +32.00 +100"));
    EXPECT_THAT(csv(sections), HasSubstr("E30,work_lifting,10.8,"));
}

TEST(Energy, ShowsWhatDrivesTheIceOnlyWhereSomethingDoes) {
    Evidence evidence = with_work();
    EXPECT_THAT(text(std::vector{energy_section(evidence)}, 120), testing::Not(HasSubstr("give way")));
    evidence.table.members.front().work.driving = -1;
    EXPECT_THAT(text(std::vector{energy_section(evidence)}, 120), HasSubstr("sheets that give way and wind"));
}

TEST(Energy, SaysWhereNobodyMeasuredIt) {
    Evidence evidence = with_work();
    for (MemberRow& row : evidence.table.members) {
        for (const EnergyRow& one : find_energy(with_work().table))
            find_quantity(one.key)->place.set(row, std::nan(""));
    }
    EXPECT_THAT(energy_section(evidence).missing, HasSubstr("computed without it"));
}

}  // namespace
}  // namespace floes
