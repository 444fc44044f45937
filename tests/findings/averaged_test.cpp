// Averaged loads go where the every-step ones go, and no further than they were measured.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "example.hpp"
#include "findings/cases.hpp"
#include "findings/catalogue.hpp"
#include "findings/pairs.hpp"
#include "tables/section.hpp"

namespace floes {
namespace averaged_test {

using testing::HasSubstr;
using testing::Not;

/// Over 0.5 s, half of what the every-step figures are.
CampaignTable averaged() {
    CampaignTable table = example::campaign();
    table.averaging_times = {0.5};
    for (MemberRow& row : table.members) {
        if (row.done())
            row.averaged = {{.time = 0.5,
                             .sd = row.load.sd / 2,
                             .segment_maximum = {row.load.maximum / 2},
                             .mean_maximum = row.load.mean_maximum / 2,
                             .sd_maximum = row.load.sd_maximum / 2}};
    }
    return table;
}

std::string text_of(const Section& section) {
    return text(std::vector{section}, 100);
}

const Quantity half_second = averaged_over(quantity("mean_maximum"), 0.5);

TEST(Averaged, IsSummarisedAsEveryStepIs) {
    const Summary summary = summarise(averaged());
    for (const CaseSummary& row : summary.cases) {
        const CaseEstimate& found = row.of(half_second);
        const CaseEstimate& every_step = row.of(quantity("mean_maximum"));
        EXPECT_DOUBLE_EQ(found.estimate, every_step.estimate / 2);
        EXPECT_DOUBLE_EQ(found.low, every_step.low / 2);
        EXPECT_NEAR(found.prediction_high, every_step.prediction_high / 2,
                    1e-12 * found.prediction_high);  // on the logarithmic scale too
    }
    EXPECT_THAT(text_of(summary_section(summary, 1)), HasSubstr("mean maximum over 0.5 s, N"));
    EXPECT_THAT(csv(std::vector{summary_section(summary, 1)}), HasSubstr(",mean_maximum_0.5s,mean_maximum_0.5s_low,"));
}

// Those of single steps depend on the time step: where there are others, they are for programs.
TEST(Averaged, TakesThePlaceOfMaximaOfSingleSteps) {
    Evidence evidence = evidence_of({}, averaged());
    const Section tables[] = {summary_section(evidence.summary, 1),
                              pairs_section(evidence.summary, compare_pairs(evidence), {})};
    for (const Section& table : tables) {
        const std::string shown = text_of(table);
        EXPECT_THAT(shown, HasSubstr("over 0.5 s"));
        EXPECT_THAT(shown, Not(HasSubstr("single steps")));
        EXPECT_THAT(shown, Not(HasSubstr("mean maximum, N")));
    }
    EXPECT_THAT(csv(std::vector{tables[0]}), HasSubstr(",maximum_load,"));
    EXPECT_THAT(csv(std::vector{tables[0]}), HasSubstr(",mean_maximum,mean_maximum_low,"));
    EXPECT_THAT(csv(std::vector{tables[1]}), HasSubstr("mean_maximum,"));
    const Summary without = summarise(example::campaign());
    EXPECT_THAT(text_of(summary_section(without, {})), HasSubstr("Maxima are of single steps"));
}

TEST(Averaged, IsNotShownWhereNothingWasAveraged) {
    const Summary summary = summarise(example::campaign());
    EXPECT_THAT(text_of(summary_section(summary, {})), Not(HasSubstr("over 0.5 s")));
    EXPECT_EQ(averaged_loads(summary).rows.size(), 0u);
}

// A member of an older journal is a missing value in these lines, and in no others.
TEST(Averaged, IsOverThoseThatHaveIt) {
    CampaignTable table = averaged();
    table.members[0].averaged.clear();  // E30, mean load 26; the others 28, 24, 30
    const Summary summary = summarise(table);
    EXPECT_DOUBLE_EQ(summary.cases[0].of(half_second).estimate, 2 * (28 + 24 + 30) / 3.0);
    EXPECT_DOUBLE_EQ(summary.cases[0].of(quantity("mean_maximum")).estimate, 108);
    EXPECT_EQ(summary.cases[0].done, 4);
    for (const PairRow& row : compare_pairs(evidence_of({}, table))) {
        if (row.first != 0 || row.second != 2) continue;
        EXPECT_EQ(row.found.arrangements, row.quantity.averaging > 0 ? 3 : 4) << row.quantity.key.view();
    }
    for (MemberRow& row : table.members) row.averaged.clear();
    EXPECT_TRUE(std::isnan(summarise(table).cases[0].of(half_second).estimate));
    EXPECT_EQ(compare_pairs(evidence_of({}, table)).size(), compare_pairs(evidence_of({}, averaged())).size());
}

TEST(Averaged, IsComparedInPairs) {
    std::size_t rows = 0;
    for (const PairRow& row : compare_pairs(evidence_of({}, averaged()))) {
        if (!(row.quantity.key == half_second.key) || row.first != 0 || row.second != 2) continue;
        ++rows;
        EXPECT_DOUBLE_EQ(row.found.difference, 2.0 * (-6 - 4 + 4 + 2) / 4);
    }
    EXPECT_EQ(rows, 1u);
}

TEST(Averaged, HasALineForEachCaseAndTimeOnThePage) {
    const Table table = shown_table(averaged_loads(summarise(averaged())), {});
    ASSERT_EQ(table.size(), 4u);
    EXPECT_EQ(table[1][0].value, "E30");
    EXPECT_EQ(table[1][1].value, "0.5");
    EXPECT_EQ(table[1][2].value, "6.75");   // SD 13.5 / 2
    EXPECT_EQ(table[1][3].value, "54.00");  // mean maximum 108 / 2
    EXPECT_EQ(table[1][5].value, "14.00");  // SD maximum 28 / 2
}

TEST(Averaged, IsInTheLineOfEachMember) {
    EXPECT_THAT(csv(std::vector{members_section(evidence_of({}, averaged()))}),
                HasSubstr(",mean_maximum,mean_maximum_0.5s,"));
}

}  // namespace averaged_test
}  // namespace floes
