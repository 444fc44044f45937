// The design load as a finding: rows of a case, Froude's law, pairs, and what cannot be answered.

#include "findings/design_load.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <nlohmann/json.hpp>

#include "core/random.hpp"
#include "support/refusal.hpp"

namespace floes {
namespace design_load_test {

using testing::HasSubstr;

/// Two cases over the same 40 arrangements, exponential peaks of 20 N above 30 N; the second has half as much more.
CampaignTable campaign() {
    CampaignTable table;
    table.title = "example";
    table.averaging_times = {0.5, 1};
    for (const char* name : {"weak", "strong"}) {
        CaseRow row;
        row.name = name;
        row.shape = Shape({{-0.4, 0.2}, {0.1, 0.7}});
        row.analysis.steady_start = 10;
        row.analysis.window = 100;
        row.analysis.segments = 4;
        row.analysis.peak_separation = 0.01;  // peaks hide none
        table.cases.push_back(row);
    }
    for (int arrangement = 0; arrangement < 40; ++arrangement) {
        RandomStream random{5, static_cast<std::uint32_t>(arrangement), StreamId::bootstrap, 0};
        std::vector<double> peaks(20);
        for (double& peak : peaks) peak = 30 - 20 * std::log(random.uniform(1e-16, 1));
        std::ranges::sort(peaks, std::ranges::greater{});
        for (int k = 0; k < 2; ++k) {
            MemberRow row;
            row.case_index = k;
            row.arrangement = arrangement;
            row.status = RowStatus::done;
            row.load.mean = 20;
            row.load.steady = true;
            AveragedLoad averaged;
            averaged.time = 1;
            for (const double peak : peaks) averaged.peaks.push_back(k == 0 ? peak : 1.5 * peak);
            averaged.segment_maximum.assign(averaged.peaks.begin(), averaged.peaks.begin() + 4);
            row.averaged.push_back(averaged);
            table.members.push_back(row);
        }
    }
    return table;
}

nlohmann::json answer(const DesignLoadRequest& request) {
    const CampaignTable table = campaign();
    return nlohmann::json::parse(json(design_load_sections(summarise(table), find_design_loads(table, request))));
}

double load_of(const nlohmann::json& told, const std::string& name, const std::string& method = "both tails") {
    for (const auto& one : told.at("design").at("loads"))
        if (one.at("case") == name && one.at("method") == method && one.at("figure") == "quantile")
            return one.at("load");
    ADD_FAILURE() << "no load of " << name << " in " << told;
    return 0;
}

TEST(DesignFinding, HasEveryCaseMethodAndFigure) {
    const nlohmann::json told = answer({});
    EXPECT_EQ(told.at("design").at("loads").size(), 2u * 5 * 2);
    EXPECT_NEAR(load_of(told, "weak"), 30 + 20 * std::log(10800 * 0.2 / -std::log(0.9)), 40);
    EXPECT_EQ(told.at("design").at("basis").at(0).at("arrangements"), 40);
    EXPECT_EQ(told.at("design").at("basis").at(0).at("peaks"), 200);
    // Only both tails have an interval that holds.
    for (const auto& one : told.at("design").at("loads")) {
        EXPECT_EQ(one.at("load_low").is_null(), one.at("method") != "both tails") << one;
        EXPECT_TRUE(one.at("reason").is_null()) << one;
    }
}

TEST(DesignFinding, GrowsByFroude) {
    const double scale = 36;
    const nlohmann::json model = answer({});
    const nlohmann::json full = answer({.exposure = 6 * 10800, .averaging = 6, .scale = scale});
    EXPECT_NEAR(load_of(full, "weak") / load_of(model, "weak"), scale * scale * scale, 1e-6);
    EXPECT_EQ(full.at("design").at("basis").at(0).at("exposure"), 10800);
}

TEST(DesignFinding, ComparesCasesOverTheSameArrangements) {
    const nlohmann::json pair = answer({}).at("design").at("pairs").at(0);
    EXPECT_EQ(pair.at("first"), "weak");
    EXPECT_EQ(pair.at("second"), "strong");
    // The loads vary together, so the difference is far more certain than either.
    EXPECT_GT(pair.at("difference_low").get<double>(), 0);
    EXPECT_LT(pair.at("difference_high").get<double>() - pair.at("difference_low").get<double>(),
              0.7 * pair.at("difference").get<double>());
}

// With many peaks a case is resampled less often, the less the more peaks it has; the draws that both have are
// compared.
TEST(DesignFinding, ComparesCasesWithOtherNumbersOfPeaks) {
    CampaignTable table = campaign();
    const std::vector<MemberRow> once = table.members;
    for (int copy = 1; copy < 4; ++copy)
        for (MemberRow row : once) {
            row.arrangement += 40 * copy;
            if (row.case_index == 1) row.averaged[0].peaks.resize(16);
            table.members.push_back(row);
        }
    const DesignLoads designs = find_design_loads(table, {});
    ASSERT_NE(designs.of_cases[0].load.draws.size(), designs.of_cases[1].load.draws.size());
    const auto told = nlohmann::json::parse(json(design_load_sections(summarise(table), designs)));
    EXPECT_EQ(told.at("design").at("pairs").size(), 1u);
}

TEST(DesignFinding, PairsNoOtherArrangements) {
    CampaignTable table = campaign();
    table.members.back().arrangement = 99;
    const DesignLoads designs = find_design_loads(table, {});
    const auto told = nlohmann::json::parse(json(design_load_sections(summarise(table), designs)));
    EXPECT_FALSE(told.at("design").contains("pairs"));
    EXPECT_FALSE(difference_of(designs.of_cases[0], designs.of_cases[1], {}))
        << "they are neither paired nor independent";
}

TEST(DesignFinding, SaysWhichCaseDidNotAverageOverThatTime) {
    CampaignTable table = campaign();
    for (MemberRow& row : table.members)
        if (row.case_index == 1) row.averaged.front().time = 0.5;
    const DesignLoads designs = find_design_loads(table, {});
    EXPECT_EQ(designs.of_cases[0].lacks.why, "");
    EXPECT_EQ(more_arrangements(designs.of_cases[1]), 0);
    EXPECT_THAT(none_text(designs.of_cases[1], table.cases[1]),
                testing::HasSubstr("did not average the load over that time"));
}

TEST(DesignFinding, SaysWhatItRestsOn) {
    const CampaignTable table = campaign();
    const std::string told = text(design_load_sections(summarise(table), find_design_loads(table, {})), 100);
    EXPECT_THAT(told, HasSubstr("Design load: the largest load averaged over 1 s in 3 h"));
    EXPECT_THAT(told, HasSubstr("weak, both tails"));
    EXPECT_THAT(told, HasSubstr("exposure / time run"));
    EXPECT_THAT(told, HasSubstr("Far end: an ice sheet."));
}

TEST(DesignFinding, NamesMembersThatStandOutBeforeAnyFigure) {
    CampaignTable table = campaign();
    for (MemberRow& row : table.members)
        if (row.case_index == 1 && (row.arrangement == 3 || row.arrangement == 5))
            for (double& peak : row.averaged[0].peaks) peak *= 10;
    const DesignLoads designs = find_design_loads(table, {});
    EXPECT_EQ(standing_out_text(designs.of_cases[0]), "");
    EXPECT_EQ(standing_out_text(designs.of_cases[1]),
              "2 of 40 members carry the 40 highest peaks: replay 7 and 11. Both tails have them as a kind of member "
              "whose share is uncertain; methods that take all members as alike are left out. About 100 arrangements "
              "would have 5 of this kind.");
    const std::string told = text(design_load_sections(summarise(table), designs), 100);
    EXPECT_THAT(told, testing::StartsWith("! strong: 2 of 40 members carry"));
    EXPECT_THAT(told, testing::Not(HasSubstr("strong - weak")));
    EXPECT_THAT(told, testing::Not(HasSubstr("! weak")));
}

TEST(DesignFinding, ExtrapolatesARisingLoadOnlyWhenTold) {
    CampaignTable table = campaign();
    for (MemberRow& row : table.members) row.load.trend = (row.arrangement % 4 + 1) * 0.01;  // N/s, over 100 s
    for (MemberRow& row : table.members) row.averaged[0].segment_maximum = {50, 50.0 + row.arrangement % 2, 50};
    for (MemberRow& row : table.members)
        if (row.case_index == 0) row.load.trend = 0;
    const DesignLoads refused = find_design_loads(table, {});
    EXPECT_TRUE(refused.of_cases[0].load.valid());
    EXPECT_FALSE(refused.of_cases[1].load.valid());
    EXPECT_THAT(text(design_load_sections(summarise(table), refused), 100),
                HasSubstr("strong: the load rises, +12 % [+11, +14] of its mean over"));
    const DesignLoads told = find_design_loads(table, {.rising = true});
    EXPECT_TRUE(told.of_cases[1].load.valid());
    EXPECT_THAT(text(design_load_sections(summarise(table), told), 100),
                testing::StartsWith("! strong: the load rises, +12 %"));
}

TEST(DesignFinding, TakesASmallRiseAsSteadyAndSaysSo) {
    CampaignTable table = campaign();
    for (MemberRow& row : table.members) row.load.trend = (row.arrangement % 4 + 10) * 1e-5;  // N/s, over 100 s
    for (MemberRow& row : table.members) row.averaged[0].segment_maximum = {50, 50.0 + row.arrangement % 2, 50};
    const DesignLoads designs = find_design_loads(table, {});
    EXPECT_TRUE(designs.of_cases[0].load.valid());
    EXPECT_THAT(text(design_load_sections(summarise(table), designs), 1000),
                HasSubstr("weak: the load is steady, +0.058 % [+0.056, +0.059] of its mean over the measured"));
}

TEST(DesignFinding, HasNoFiguresOfALoadThatIsRefused) {
    CampaignTable table = campaign();
    for (MemberRow& row : table.members) row.load.trend = (row.arrangement % 4 + 1) * 0.01;
    const auto told = nlohmann::json::parse(json(design_load_sections(summarise(table), find_design_loads(table, {}))));
    const auto& basis = told.at("design").at("basis").at(0);
    EXPECT_EQ(basis.at("refused_as_rising"), true);
    EXPECT_EQ(basis.at("trend_seen"), true);
    EXPECT_EQ(basis.at("trend"), "rises");
    EXPECT_NEAR(basis.at("change_over_window"), 2.5, 1e-9);
    EXPECT_EQ(basis.at("arrangements"), 40);
    for (const char* name : {"threshold", "peaks", "time_run", "scatter"}) EXPECT_TRUE(basis.at(name).is_null());
}

TEST(DesignFinding, SaysNothingOfThreeMembers) {
    CampaignTable table = campaign();
    std::erase_if(table.members, [](const MemberRow& row) { return row.arrangement > 2; });
    const std::string told = text(design_load_sections(summarise(table), find_design_loads(table, {})), 400);
    EXPECT_THAT(told, HasSubstr("weak: 3 of the 4 arrangements that a design load needs; 8 or more are a beginning."));
}

TEST(DesignFinding, RefusesAnAveragingTimeThatIsNotThere) {
    EXPECT_EQ(refusal([] { find_design_loads(campaign(), {.averaging = 3}); }),
              "The members did not average the load over 3 s; take one of 0.5, 1 s, or run them with another "
              "analysis.averaging_s.");
    EXPECT_THAT(refusal([] { find_design_loads(campaign(), {.averaging = 1, .scale = 36}); }),
                HasSubstr("over 1 s at full scale; take one of 3, 6 s"));
}

TEST(DesignFinding, SaysWhereThereAreTooFewPeaks) {
    CampaignTable table = campaign();
    for (MemberRow& row : table.members)
        if (row.case_index == 1) row.averaged[0].peaks.resize(1);
    const std::string told = text(design_load_sections(summarise(table), find_design_loads(table, {})), 100);
    EXPECT_THAT(told, HasSubstr("strong: too few peaks ("));
}

}  // namespace design_load_test
}  // namespace floes
