// The findings as table, JSON and CSV.

#include "findings/catalogue.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <set>

#include "findings/example.hpp"
#include "findings/extremes.hpp"
#include "findings/pairs.hpp"

namespace floes {
namespace findings_test {

using nlohmann::json;
using testing::HasSubstr;
using testing::Not;

/// Twelve arrangements of the example's cases; E60 is E30 and 4 N, but for 0.5 N to and fro.
Evidence evidence() {
    CampaignTable table = example::campaign();
    table.members.clear();
    for (int arrangement = 0; arrangement < 12; ++arrangement) {
        const double load = 20 + (arrangement * 5) % 12;
        for (int one = 0; one < 3; ++one) {
            const double own = one == 0 ? load : one == 1 ? load + 4 + (arrangement % 2 - 0.5) : 50 - load;
            MemberRow row = example::done(one, arrangement, own, 0.01 * arrangement, arrangement);
            row.load.segment_maximum = {2 * own, 3 * own + arrangement, 4 * own};
            table.members.push_back(row);
        }
    }
    return evidence_of({}, std::move(table));
}

/// The parts of these names.
std::vector<Section> sections(Evidence of, const std::vector<std::string_view>& names) {
    std::vector<Section> made;
    for (const Finding& finding : findings())
        if (std::ranges::find(names, finding.name) != names.end())
            for (Section& section : finding.sections(of)) made.push_back(std::move(section));
    return made;
}

/// Rows of a pair: one for each quantity of Table 3.
const std::size_t compared = static_cast<std::size_t>(std::ranges::distance(shown_in(quantities, Shown::in_pairs)));

std::string text_of(const Section& section) {
    return text(std::vector{section}, 100);
}

TEST(Pairs, ShareArrangements) {
    const std::vector<PairRow> pairs = compare_pairs(evidence());
    ASSERT_EQ(pairs.size(), 3 * compared);
    const PairRow& first = pairs.front();
    EXPECT_EQ(first.found.arrangements, 12);
    EXPECT_DOUBLE_EQ(first.found.difference, 4);
    EXPECT_GT(first.found.variance_saved, 0.95);
    EXPECT_LT(first.t_p_holm, 1e-6);
    EXPECT_LT(pairs.at(1).found.variance_saved, -0.9);  // E200 goes against E30
    EXPECT_LE(first.to_resolve_observed, 4);
}

TEST(Pairs, PutTheReferenceFirst) {
    const std::vector<PairRow> rows = compare_pairs(evidence(), {.reference = 1});
    EXPECT_EQ(rows[0].first, 1u);
    EXPECT_EQ(rows[0].second, 0u);
    EXPECT_DOUBLE_EQ(rows[0].found.difference, -4);
    EXPECT_EQ(rows[1].first, 0u);
}

// Members that failed or are missing leave two arrangements to E30 and E60, and E60 and E200.
TEST(Pairs, LeaveOutWhatOneOfThemDoesNotHave) {
    const std::vector<PairRow> rows = compare_pairs(evidence_of({}, example::campaign()));
    ASSERT_EQ(rows.size(), 3 * compared);
    EXPECT_EQ(rows[0].found.arrangements, 2);
    EXPECT_EQ(rows[1].found.arrangements, 4);
}

TEST(Pairs, AreNotMadeOfDifferentFields) {
    CampaignTable table = example::campaign();
    for (MemberRow& row : table.members) row.arrangement = 3 * row.arrangement + row.case_index;
    const Evidence apart = evidence_of({}, std::move(table));
    EXPECT_TRUE(compare_pairs(apart).empty());
    EXPECT_THAT(text_of(pairs_section(apart.summary, {}, {})),
                testing::StartsWith("Pairs are not compared: a pair needs two arrangements"));
}

TEST(Pairs, SayWhichAreLeftOut) {
    CampaignTable table = example::campaign();
    for (MemberRow& row : table.members) row.arrangement += row.case_index == 1 ? 100 : 0;  // a field of its own
    const Evidence apart = evidence_of({}, std::move(table));
    const std::vector<PairRow> rows = compare_pairs(apart);
    EXPECT_EQ(rows.size(), compared);
    EXPECT_THAT(text_of(pairs_section(apart.summary, rows, {})), HasSubstr("\n2 of 3 pairs are not compared: "));
    const Evidence whole = evidence_of({}, example::campaign());
    EXPECT_EQ(left_out_text(whole.summary, compare_pairs(whole)), "");
}

// E200 has a field of its own, so E30 and E60 share every second row of /arrangements; people know arrangements by
// number.
TEST(Pairs, NameArrangementsThatStandApartByTheirNumber) {
    CampaignTable table = evidence().table;
    for (MemberRow& row : table.members) row.arrangement = 2 * row.arrangement + (row.case_index == 2 ? 1 : 0);
    table.members[3 * 7 + 1].load.mean = 300;
    const std::vector<PairRow> rows = compare_pairs(evidence_of({}, std::move(table)));
    ASSERT_FALSE(rows.empty());
    EXPECT_THAT(rows.front().apart, testing::ElementsAre(7));
}

TEST(Extremes, TakeTheSegmentsOfEveryDoneMember) {
    const CaseExtremes soft = find_extremes(evidence().table).front();
    EXPECT_EQ(soft.maxima, 36u);
    EXPECT_EQ(soft.segment, 50);
    EXPECT_TRUE(soft.gumbel.fit.valid());
    EXPECT_EQ(soft.exceedance.size(), 36u);
}

TEST(Extremes, PrintNoIntervalsAndNoFitThatSaysNothing) {
    const Evidence of = evidence();
    std::vector<CaseExtremes> found = find_extremes(of.table);
    found[1].gev.fit = fit_maxima({}, ExtremeKind::gev);
    const std::string text = text_of(extremes_section(of.summary, found));
    EXPECT_THAT(text, Not(testing::ContainsRegex("\n  (Gumbel|GEV) .*\\[")));
    EXPECT_THAT(text, HasSubstr("  GEV: no fit"));
    found.resize(1);
    found[0].gumbel.fit = {};
    EXPECT_THAT(text_of(extremes_section(of.summary, found)), HasSubstr("No case has 10 segment maxima that differ"));
    found[0].maxima = fewest_maxima - 1;
    EXPECT_THAT(text_of(extremes_section(of.summary, found)), HasSubstr("Too few segment maxima to fit"));
}

TEST(Findings, HaveANameOrAPlaceInTheReport) {
    std::set<std::string_view> names;
    for (const Finding& finding : findings()) {
        EXPECT_EQ(finding.page_title.empty(), finding.on_page == nullptr) << finding.name << finding.page_title;
        EXPECT_FALSE(finding.name.empty() && finding.page_title.empty());
        EXPECT_TRUE(finding.name.empty() || names.insert(finding.name).second) << finding.name;
    }
}

TEST(Findings, ComeInOrderAsATable) {
    const std::string text = floes::text(sections(evidence(), {"cases", "pairs", "extremes"}), 120);
    EXPECT_LT(text.find("Campaign example"), text.find("Pairs over the same arrangements"));
    EXPECT_LT(text.find("Pairs over the same arrangements"), text.find("Extremes\n"));
    EXPECT_THAT(text, testing::ContainsRegex("E60 - E30 +12 +4\\.00 \\[3\\.67, 4\\.33\\] +16 +<0\\.001"));
    EXPECT_THAT(text, HasSubstr("E30, 36 maxima"));
    EXPECT_THAT(text, Not(HasSubstr("nan")));
}

TEST(Findings, HaveEveryPartInJson) {
    const json parsed = json::parse(floes::json(sections(evidence(), {"cases", "pairs", "exceedance"})));
    EXPECT_EQ(parsed.at("cases").size(), 3u);
    EXPECT_EQ(parsed.at("pairs").size(), 18u);
    EXPECT_EQ(parsed.at("pairs").at(0).at("quantity"), "mean_load");
    EXPECT_EQ(parsed.at("exceedance").size(), 3u * 36);
    EXPECT_FALSE(parsed.contains("steady"));
}

TEST(Findings, AreOneTableAPartInCsv) {
    const std::string text = csv(sections(evidence(), {"pairs"}));
    EXPECT_TRUE(text.starts_with("quantity,first,second,arrangements,"));
    EXPECT_EQ(std::count(text.begin(), text.end(), '\n'), 19);
}

TEST(Findings, HaveALineAMemberInCsv) {
    CampaignTable table = example::campaign();
    table.members[0].load.segment_maximum = {120.5, 80, 111.25};
    table.members[1].load.segment_maximum = {70, 90};  // a case of two segments
    const std::string text = csv(std::vector{members_section(evidence_of({}, table))});
    EXPECT_TRUE(text.starts_with("member,case,arrangement,status,mean_load,sd_load,maximum_load,mean_maximum,"));
    EXPECT_THAT(text, HasSubstr(",segment_1_maximum,segment_2_maximum,segment_3_maximum,trend_p\n"));
    EXPECT_EQ(static_cast<std::size_t>(std::count(text.begin(), text.end(), '\n')), table.members.size() + 1);
    const MemberRow& first = table.members.front();
    EXPECT_THAT(text,
                HasSubstr(fmt::format("\n0,{},{},done,{},", table.cases[0].name, first.arrangement, first.load.mean)));
    EXPECT_THAT(text, HasSubstr(fmt::format(",120.5,80,111.25,{}\n", first.load.trend_p)));
    EXPECT_THAT(text, HasSubstr(fmt::format(",70,90,,{}\n", table.members[1].load.trend_p)));
    EXPECT_THAT(text, HasSubstr(",failed,,,,,,,,,,,,,,,,,,,,,\n"));
    EXPECT_THAT(text, HasSubstr(",missing,,,,,,,,,,,,,,,,,,,,,\n"));
}

/// Two levels, counted in E30 and E60 alone; E30 counts 0, 100, …, 1100 steps above the lower one.
Evidence with_levels() {
    Evidence made = evidence();
    made.table.levels = {20, 50};
    for (CaseRow& one : made.table.cases) one.time_step = 0.02;
    for (std::size_t k = 0; k < made.table.members.size(); ++k) {
        MemberRow& row = made.table.members[k];
        const double count = row.case_index == 2 ? std::nan("") : 100.0 * static_cast<double>(k / 3);
        row.steps_above = {count, 0 * count};
        row.upcrossings = {count / 10, 0 * count};
    }
    return made;
}

TEST(Levels, AreMeansOverTheArrangementsThatCountedThem) {
    const std::vector<LevelRow> rows = find_levels(with_levels().table);
    ASSERT_EQ(rows.size(), 4u);
    EXPECT_EQ(rows[1].case_index, 0u);
    EXPECT_EQ(rows[1].level, 50);
    EXPECT_EQ(rows[1].time_above.high, 0);
    EXPECT_EQ(rows[0].runs, 12);
    EXPECT_DOUBLE_EQ(rows[0].time_above.estimate, 550.0 / 7500);
    // t(11) s / √12 = 2.201 · 360.6 / 3.464 = 229.1 steps.
    EXPECT_NEAR(rows[0].time_above.high - rows[0].time_above.estimate, 229.1 / 7500, 0.1 / 7500);
    EXPECT_DOUBLE_EQ(rows[0].upcrossings.estimate, 55.0 / 150);
}

TEST(Levels, AreToldInEveryFormat) {
    const Evidence of = with_levels();
    const Section told = levels_section(of.summary, find_levels(of.table));
    EXPECT_THAT(text_of(told), testing::ContainsRegex("E30 +20 +12 +7\\.333 +\\[4\\.27.*22\\.00 +\\["));
    const json levels = json::parse(floes::json(std::vector{told})).at("load_levels");
    ASSERT_EQ(levels.size(), 4u);
    EXPECT_EQ(levels[2].at("case"), "E60");
    EXPECT_DOUBLE_EQ(levels[0].at("time_above").get<double>(), 550.0 / 7500);
    EXPECT_THAT(csv(std::vector{told}), testing::StartsWith("case,level,runs,time_above,"));
    EXPECT_THAT(csv(std::vector{told}), HasSubstr("\nE60,50,12,0,0,0,0,0,0\n"));
    const Section none = levels_section(of.summary, {});
    EXPECT_THAT(text_of(none), HasSubstr("no member counted any (analysis.exceedance_levels_N)"));
    EXPECT_EQ(csv(std::vector{none}), "");
    EXPECT_EQ(json::parse(floes::json(std::vector{none})).at("load_levels").size(), 0u);
}

}  // namespace findings_test
}  // namespace floes
