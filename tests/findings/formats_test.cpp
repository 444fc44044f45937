// The same figures as a table, as JSON and as CSV.

#include "findings/cases.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <nlohmann/json.hpp>
#include <sstream>

#include "findings/conditions.hpp"
#include "findings/example.hpp"
#include "scenario/scenario.hpp"

namespace floes {
namespace formats_test {

using nlohmann::json;
using testing::HasSubstr;
using testing::Not;

std::vector<std::string> lines_of(const std::string& text) {
    std::vector<std::string> lines;
    std::istringstream stream{text};
    for (std::string line; std::getline(stream, line);) lines.push_back(line);
    return lines;
}

std::string summary_json(const Summary& summary, Reference reference = {}) {
    return floes::json(std::vector{summary_section(summary, reference)});
}

std::string summary_csv(const Summary& summary, Reference reference = {}) {
    return csv(std::vector{summary_section(summary, reference)});
}

std::string summary_table(const Summary& summary, int width, Reference reference = {}) {
    return text(std::vector{summary_section(summary, reference)}, width);
}

// -- JSON

TEST(SummaryJson, HasEveryNameOfTheFormat) {
    const json summary = json::parse(summary_json(summarise(example::campaign())));
    ASSERT_EQ(summary.at("cases").size(), 3u);
    EXPECT_EQ(summary.at("complete"), false);
    const json& row = summary.at("cases").at(0);
    EXPECT_EQ(row.at("name"), "E30");
    EXPECT_EQ(row.at("cfm"), 0.03);
    EXPECT_EQ(row.at("elastic_modulus_MPa"), 30.0);
    EXPECT_EQ(row.at("members"), 4);
    EXPECT_EQ(row.at("failed_members"), 0);
    EXPECT_EQ(row.at("not_steady"), 1);
    for (const char* name : {"mean_load", "maximum_load", "mean_maximum", "failure_ratio", "failures_bending"}) {
        for (const char* part : {"", "_low", "_high", "_prediction_low"}) {
            EXPECT_TRUE(row.at(std::string(name) + part).is_number()) << name << part;
        }
    }
    EXPECT_EQ(row.at("mean_load"), 27.0);
    EXPECT_EQ(row.at("failures_bending_total"), 10);
    EXPECT_EQ(row.at("failures_shear_total"), 4);
    EXPECT_EQ(row.at("failures_compression_total"), 0);
    EXPECT_FALSE(row.contains("mean_load_difference_percent"));
    EXPECT_FALSE(summary.contains("reference"));
}

TEST(SummaryJson, CarriesTheConditions) {
    const json summary = json::parse(summary_json(summarise(example::campaign())));
    const json row = summary.at("cases").at(2);
    const json expected = json::parse(R"({"far_end": "ice_sheet", "contact_erp": 0.2, "friction": "one_direction",
        "contact_law": "rigid", "internal_edges": true, "steady_start": 120, "window": 150, "segments": 3})");
    for (const auto& [name, value] : expected.items()) EXPECT_EQ(row.at(name), value) << name;
    EXPECT_FALSE(row.contains("crushing_pressure_kPa"));
    EXPECT_EQ(summary.at("profiles").at(4), json::parse(R"({"case": "E200", "height": -0.443, "radius": 0.171})"));
    EXPECT_EQ(summary.at("profiles").at(5), json::parse(R"({"case": "E200", "height": 0.122, "radius": 0.736})"));
}

TEST(SummaryJson, SaysThePressureWhereEdgesCrush) {
    CampaignTable table = example::campaign();
    table.cases[0].contact = with_preset({.crushing_pressure = 145.6e3}, ContactPreset::physical);
    const Summary summary = summarise(table);
    const json conditions = json::parse(summary_json(summary)).at("cases").at(0);
    EXPECT_DOUBLE_EQ(conditions.at("crushing_pressure_kPa"), 145.6);
    EXPECT_EQ(conditions.at("contact_law"), "crushing");
    EXPECT_EQ(contact_words(table.cases[0].contact).text(),
              "preset physical, friction in the contact plane, crushing at 145.6 kPa");
    table.cases[0].contact.internal_edges = true;
    EXPECT_EQ(contact_words(table.cases[0].contact).text(),
              "friction in the contact plane, crushing at 145.6 kPa, internal edges act");
}

TEST(SummaryJson, HasNullWhereUndefined) {
    CampaignTable table = example::campaign();
    table.members.resize(2);
    const json cases = json::parse(summary_json(summarise(table))).at("cases");
    EXPECT_EQ(cases.at(0).at("mean_load"), 26);
    for (const char* part : {"low", "high", "prediction_low", "prediction_high"})
        EXPECT_TRUE(cases.at(0).at(std::string("mean_load_") + part).is_null()) << part;
    EXPECT_TRUE(cases.at(2).at("mean_load").is_null());
    EXPECT_TRUE(cases.at(2).at("failures_bending_total").is_null());
    EXPECT_EQ(cases.at(2).at("members"), 0);
}

TEST(SummaryJson, KeepsEveryDigit) {
    CampaignTable table = example::campaign();
    table.members = {example::done(0, 0, 0.1 + 0.2, 0, 0)};
    EXPECT_EQ(json::parse(summary_json(summarise(table))).at("cases").at(0).at("mean_load"), 0.1 + 0.2);
}

TEST(SummaryJson, ComparesWithAReference) {
    const json summary = json::parse(summary_json(summarise(example::campaign()), 1));
    EXPECT_EQ(summary.at("reference"), "E60");
    const json& cases = summary.at("cases");
    EXPECT_DOUBLE_EQ(cases.at(0).at("mean_load_difference_percent").get<double>(), 100.0 * (27 - 32) / 32);
    EXPECT_EQ(cases.at(1).at("mean_load_difference_percent"), 0.0);
}

// -- CSV

TEST(SummaryCsv, HasOneLineACaseAndAValueForEveryColumn) {
    CampaignTable table = example::campaign();
    table.cases[1].name = "E60, \"stiff\"";
    const auto lines = lines_of(summary_csv(summarise(table)));
    ASSERT_EQ(lines.size(), 4u);
    EXPECT_TRUE(
        lines[0].starts_with("name,cfm,elastic_modulus_MPa,members,done,failed_members,missing_members,not_steady,"
                             "trend,change_over_window,change_over_window_low,change_over_window_high,"
                             "mean_load,mean_load_low,mean_load_high,mean_load_prediction_low,"))
        << lines[0];
    EXPECT_TRUE(lines[1].starts_with("E30,0.03,30,4,4,0,0,1,steady,0,0,0,27,")) << lines[1];
    EXPECT_TRUE(lines[2].starts_with("\"E60, \"\"stiff\"\"\",0.016,60,4,2,1,1,0,not known,0,,,32,")) << lines[2];
    EXPECT_THAT(lines[3], HasSubstr(",34,4,0,"));  // failures by mode
    EXPECT_TRUE(lines[3].ends_with(",ice_sheet,0.2,one_direction,rigid,1,,120,150,3")) << lines[3];
    const auto commas = [](const std::string& line) { return std::ranges::count(line, ','); };
    // The wall's words hold no comma of their own but the one after "straight", inside quotes.
    EXPECT_EQ(commas(lines[1]), commas(lines[0]) + 1);
}

TEST(SummaryCsv, LeavesUndefinedEmpty) {
    CampaignTable table = example::campaign();
    table.members.resize(2);
    const auto lines = lines_of(summary_csv(summarise(table)));
    EXPECT_THAT(lines[1], HasSubstr(",26,,,,,0,13,,,,,"));
    EXPECT_TRUE(lines[3].starts_with("E200,1e-10,200,0,0,0,0,0,not known,,,,,")) << lines[3];
    EXPECT_THAT(lines[3], Not(HasSubstr("nan")));
}

TEST(SummaryCsv, ComparesWithAReference) {
    const auto lines = lines_of(summary_csv(summarise(example::campaign()), 1));
    EXPECT_THAT(lines[0], HasSubstr("mean_load_standing_out,mean_load_difference_percent,sd_load,"));
    EXPECT_THAT(lines[1], HasSubstr(",-15.625,"));
}

// -- table

TEST(SummaryTable, SaysWallFarEndAndContact) {
    const std::string text = summary_table(summarise(example::campaign()), 120);
    EXPECT_THAT(
        text,
        HasSubstr("Structure wall: straight, 45.0° from the horizontal (radius 0.171 m at -0.443 m to 0.736 m "
                  "at +0.122 m).\nFar end: an ice sheet.\nContacts: preset paper, friction in one direction, "
                  "rigid with Γ 0.2.\nLoad measured: for 150 s, from 120 s after the tow began, in 3 segments.\n"));
}

TEST(SummaryTable, SaysOfThePapersConeThatItIsTheDefault) {
    CampaignTable table = example::campaign();
    for (CaseRow& row : table.cases) row.shape = Shape();
    EXPECT_THAT(summary_table(summarise(table), 120), Not(HasSubstr("where no hull is stated")));
    for (CaseRow& row : table.cases) row.contact = with_preset(row.contact, ContactPreset::physical);
    EXPECT_THAT(summary_table(summarise(table), 120),
                HasSubstr("at +0.122 m); the paper's cone, which is towed where no\nhull is stated.\nFar end: "));
}

TEST(SummaryTable, SaysWhatIsMissing) {
    const std::string text = summary_table(summarise(example::campaign()), 120);
    EXPECT_TRUE(
        text.starts_with("Campaign example: 12 members in 3 cases, 1 failed. INCOMPLETE: 1 without a result yet.\n"))
        << text;
    EXPECT_THAT(text, HasSubstr("Member 4 failed: floe 3 sank\n"));
    EXPECT_THAT(text, testing::ContainsRegex("load through the window +steady +not known +steady\n"));
    CampaignTable whole = example::campaign();
    whole.members.resize(3);
    EXPECT_THAT(summary_table(summarise(whole), 120), Not(HasSubstr("INCOMPLETE")));
}

TEST(SummaryTable, ShowsTheFigures) {
    const std::string text = summary_table(summarise(example::campaign()), 150, 1);
    EXPECT_THAT(text, testing::ContainsRegex("mean, N +27\\.00 \\[22\\.89, 31\\.11\\] +32\\.00 – +26\\.00 "));
    EXPECT_THAT(text, testing::ContainsRegex("against E60, % +-15\\.6 +0\\.0 +-18\\.8"));
    EXPECT_THAT(text, testing::ContainsRegex("mean maximum, N +108\\.0 "));
    EXPECT_THAT(text, testing::ContainsRegex("broken floes, % +2\\.0 "));
    EXPECT_THAT(text, testing::ContainsRegex("joints failed in bending +2\\.5 \\[0\\.4, 4\\.6\\] +5\\.5 – +8\\.5 "));
}

// Without a criterion no joint can fail in tension; a file of before layout 1.9 does not know the mode.
TEST(SummaryTable, LeavesOutModesInWhichNoJointFailed) {
    CampaignTable table = example::campaign();
    for (MemberRow& row : table.members) row.failures[3] = std::numeric_limits<double>::quiet_NaN();
    const std::string text = summary_table(summarise(table), 150);
    EXPECT_THAT(text, HasSubstr("\n  in shear "));
    EXPECT_THAT(text, Not(HasSubstr("in compression")));
    EXPECT_THAT(text, Not(HasSubstr("in tension")));
    for (MemberRow& row : table.members) row.failures[0] = row.failures[1] = 0;
    EXPECT_THAT(summary_table(summarise(table), 150), HasSubstr("joints failed in bending "));
}

TEST(SummaryTable, FitsTheWidth) {
    const Summary summary = summarise(example::campaign());
    const std::string wide = summary_table(summary, 140, 1);
    const std::string narrow = summary_table(summary, 60, 1);
    const auto headers = [](const std::string& text) {
        std::size_t count = 0;
        for (const std::string& line : lines_of(text)) count += line.starts_with("case ");
        return count;
    };
    EXPECT_EQ(headers(wide), 1u);
    EXPECT_EQ(headers(narrow), 3u);
    const std::string panels =
        narrow.substr(narrow.find("case "), narrow.find("One arrangement") - narrow.find("case "));
    EXPECT_THAT(panels, HasSubstr("E200"));
    for (const std::string& line : lines_of(panels)) EXPECT_LE(text_width(line), 60u) << line;
}

TEST(SummaryTable, OfACaseWithoutResultsHasNoFigures) {
    CampaignTable table = example::campaign();
    table.members.clear();
    table.members.push_back(example::without_result(0, 0, RowStatus::failed, "gone"));
    const std::string text = summary_table(summarise(table), 120);
    EXPECT_THAT(text, testing::ContainsRegex("mean, N +– +– +–\n"));
    EXPECT_THAT(text, Not(HasSubstr("nan")));
}

// -- conditions

TEST(Conditions, SayWhatHoldsAndDrivesTheIce) {
    CampaignTable table = example::campaign();
    for (CaseRow& row : table.cases) {
        row.shape = Shape({{-0.4, 0.5}, {0.0, 0.5}, {0.1, 0.6}});
        row.field.half_width = 1.25;
        row.field_length = 4.61;
    }
    EXPECT_THAT(
        condition_lines(summarise(table)),
        testing::Contains(
            "Channel: 2.5 m wide (2.5 times the hull at the waterline), field 4.61 m long, between ice sheets."));
    EXPECT_THAT(condition_lines(summarise(table)), Not(testing::Contains(testing::StartsWith("Drift"))));
    table.cases[2].field.confining = 20;
    table.cases[2].current = {0, 0.1};
    table.cases[2].wind.speed = 5;
    const auto lines = condition_lines(summarise(table));
    EXPECT_THAT(lines,
                testing::Contains("Channel: 2.5 m wide (2.5 times the hull at the waterline), field 4.61 m long, "
                                  "between ice sheets; its sheets press with 20 N/m (E200)."));
    EXPECT_THAT(lines, Not(testing::Contains(testing::StartsWith("Gap"))));
    EXPECT_THAT(lines, testing::Contains("Drift: current 0.1 m/s towards 90°, wind 5 m/s towards 0° (E200)."));
}

TEST(Conditions, BeginWithTheIceAndHowTheStructureMoves) {
    CampaignTable table = example::campaign();
    for (CaseRow& row : table.cases) {
        row.floes = "24 floes of 0.6 m x 0.6 m, 0.033 m thick";
        row.motion = "towed at 0.1 m/s";
    }
    table.cases[2].motion = "led along a path";
    const auto lines = condition_lines(summarise(table));
    ASSERT_GE(lines.size(), 3U);
    EXPECT_EQ(lines[0], "Ice: 24 floes of 0.6 m x 0.6 m, 0.033 m thick.");
    EXPECT_EQ(lines[1], "Structure: towed at 0.1 m/s (E30, E60).");
    EXPECT_EQ(lines[2], "Structure: led along a path (E200).");
}

TEST(Conditions, HaveTheGapBesideTheStructure) {
    CampaignTable table = example::campaign();
    for (CaseRow& row : table.cases) row.gap = BankGap{0.636, 1.06};
    EXPECT_THAT(condition_lines(summarise(table)),
                testing::Contains("Gap: 0.636 m between the structure and the bank, 1.06 sides of a floe."));
    table.cases[2].gap.reset();
    EXPECT_THAT(condition_lines(summarise(table)),
                testing::Contains("Gap: none, as the sides are open or the structure goes along a path (E200)."));
    const json cases = json::parse(summary_json(summarise(table))).at("cases");
    EXPECT_EQ(cases.at(0).at("gap"), 0.636);
    EXPECT_EQ(cases.at(0).at("gap_floes"), 1.06);
    EXPECT_FALSE(cases.at(2).contains("gap"));
}

TEST(Conditions, SayWhichCasesDiffer) {
    CampaignTable table = example::campaign();
    table.cases[1].far_end = FarEnd::open;
    const auto lines = condition_lines(summarise(table));
    EXPECT_THAT(lines, testing::Contains("Far end: an ice sheet (E30, E200)."));
    EXPECT_THAT(lines, testing::Contains("Far end: open (E60)."));
    EXPECT_THAT(lines, testing::Contains("Contacts: preset paper, friction in one direction, rigid with Γ 0.2."));
    table.cases[1].cfm = std::numeric_limits<double>::quiet_NaN();  // of beam joints
    EXPECT_THAT(
        condition_lines(summarise(table)),
        testing::IsSupersetOf({"Joints: they follow Σ (E30, E200).",
                               "Joints: elastic beams, solved exactly; they fail by the stress in the ice (E60)."}));
}

}  // namespace formats_test
}  // namespace floes
