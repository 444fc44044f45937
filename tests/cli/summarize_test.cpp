// The verb `summarize`, from a campaign file on the disk to standard output.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <numbers>

#include <fmt/format.h>

#include "campaign_file/read.hpp"
#include "cli/verb_output.hpp"
#include "core/error.hpp"
#include "support/file_bytes.hpp"
#include "support/published.hpp"
#include "support/refusal.hpp"
#include "support/temporary_folder.hpp"

namespace floes {
namespace summarize_test {

using nlohmann::json;
using testing::HasSubstr;
using testing::Not;

class Summarize : public testing::Test {
  protected:
    // Three cases, four arrangements; of the case "stiff" member 4 failed and member 7 is missing.
    Summarize() { synthetic::publish(file_); }

    // Standard output of `floes summarize FILE arguments…`.
    std::string summarize(const std::string& arguments) {
        return verb_output(add_summarize, "summarize " + file_.string() + " " + arguments);
    }

    TemporaryFolder folder_;
    std::filesystem::path file_ = folder_ / "synthetic.h5";
};

TEST_F(Summarize, WantsANameBeforeTheEnding) {
    EXPECT_THAT(refusal([&] { summarize("-o .csv"); }), HasSubstr(".csv is an ending without a name"));
}

TEST_F(Summarize, GivesJsonOfWhatTheFileHolds) {
    const json summary = json::parse(summarize("--format json"));
    EXPECT_EQ(summary.at("campaign"), "synthetic");
    EXPECT_EQ(summary.at("complete"), false);
    const json& soft = summary.at("cases").at(0);
    EXPECT_EQ(soft.at("name"), "soft");
    // Members 0, 3, 6 and 9: mean loads of 100, 400, 700 and 1000 N and a tenth; odd ones are not steady.
    EXPECT_DOUBLE_EQ(soft.at("mean_load").get<double>(), 550.1);
    EXPECT_EQ(soft.at("not_steady"), 2);
    EXPECT_EQ(soft.at("failures_bending_total"), 3 * (0 + 3 + 6 + 9));
    const json& stiff = summary.at("cases").at(1);
    EXPECT_EQ(stiff.at("elastic_modulus_MPa"), 200.0);
    EXPECT_EQ(stiff.at("members"), 4);
    EXPECT_EQ(stiff.at("failed_members"), 1);
    EXPECT_EQ(stiff.at("missing_members"), 1);
    // Members 1 and 10 alone.
    EXPECT_DOUBLE_EQ(stiff.at("mean_load").get<double>(), 650.1);
    const json& open = summary.at("cases").at(2);
    EXPECT_EQ(open.at("far_end"), "open");
    EXPECT_EQ(open.at("contact_erp"), 0.8);
    EXPECT_EQ(std::ranges::count(summary.at("profiles"), "open", [](const json& row) { return row.at("case"); }), 3);
    EXPECT_EQ(open.at("window"), synthetic::campaign().cases.at(2).scenario.analysis.window);
    EXPECT_EQ(open.at("segments"), 2);
}

TEST_F(Summarize, GivesATable) {
    const std::string text = summarize("--full --reference soft");
    EXPECT_THAT(text,
                HasSubstr("Campaign synthetic: 12 members in 3 cases, 1 failed. INCOMPLETE: 1 without a result yet."));
    EXPECT_THAT(text, HasSubstr("Far end: an ice sheet (soft, stiff).\nFar end: open (open).\n"));
    EXPECT_THAT(text, HasSubstr("against soft"));
    EXPECT_THAT(text, HasSubstr("Member 4 failed: "));
}

TEST_F(Summarize, FitsAScreenUnlessAskedForAll) {
    const std::string text = summarize("");
    EXPECT_LT(std::ranges::count(text, '\n'), 24) << text;
    EXPECT_THAT(text, HasSubstr("! 1 of 12 members failed"));
    EXPECT_THAT(text, HasSubstr(" report " + file_.string()));
    EXPECT_THAT(text, HasSubstr(" replay " + file_.string() + " --worst -o worst.html"));
    EXPECT_THAT(summarize("--parts overview"), Not(HasSubstr(" report ")));
    EXPECT_GT(std::ranges::count(summarize("--full"), '\n'), 60);
}

TEST_F(Summarize, GivesCsv) {
    const std::string text = summarize("--format csv");
    EXPECT_EQ(std::ranges::count(text, '\n'), 4);
    EXPECT_THAT(text, HasSubstr("\nstiff,1e-10,200,4,2,1,1,"));
}

// Campaigns with a design are read from the file's own configuration.
TEST_F(Summarize, SaysWhatDecidesTheLoad) {
    EXPECT_THAT(summarize("--parts sensitivity"), HasSubstr("has no design"));
    const Campaign campaign = synthetic::campaign_with_design();
    synthetic::publish(file_, campaign, synthetic::all_done_records(campaign));
    const json found = json::parse(summarize("--format json")).at("sensitivity");
    // A row for each of two axes; SD and mean maximum over two averaging times as well.
    ASSERT_EQ(found.at("rows").size(), 2 * (4u + 2 * 2));
    EXPECT_EQ(found.at("rows").at(6).at("quantity"), "sd_load_0.4s");
    EXPECT_NEAR(found.at("rows").at(6).at("slope").get<double>(), 200, 1e-9);
    // Member m has a mean load of 100 (m + 1) and a tenth, and its case is m modulo 6: 2 to a thickness, 1 to a Σ.
    EXPECT_NEAR(found.at("rows").at(0).at("slope").get<double>(), 200, 1e-9);
    EXPECT_NEAR(found.at("rows").at(1).at("slope_high").get<double>(), 50, 1e-9);
    EXPECT_TRUE(json::parse(summarize("--format json")).contains("pairs"));  // for programs as before
    EXPECT_THAT(summarize("--format csv --parts points"), HasSubstr("\nsoft+0.05_0.01,soft,4,0.05,0.01,4,"));
    EXPECT_THAT(summarize("--full"), HasSubstr("What decides the load"));
    EXPECT_THAT(summarize("--full"), Not(HasSubstr("Pairs over the same arrangements")));  // nobody asked for them
    EXPECT_THAT(summarize(""), HasSubstr("soft: thickness from 0.03 to 0.05 m changes the mean load by +400 N"));
}

TEST_F(Summarize, RefusesWhatItDoesNotKnow) {
    EXPECT_THROW(summarize("--format yaml"), CommandLineEnd);
    EXPECT_THROW(summarize("--reference hard"), InputError);
    std::filesystem::remove(file_);
    EXPECT_THROW(summarize(""), InputError);
}

TEST_F(Summarize, ReadsSteadyStatesFromThinnedHistoriesButMeasuresNothingAnew) {
    Campaign campaign = synthetic::campaign();
    for (Case& one : campaign.cases) one.scenario.analysis.history_stride = 2;
    publish(file_, campaign, synthetic::records(campaign), {});
    EXPECT_THAT(summarize("--parts steady"), HasSubstr("decorrelation, s"));
    EXPECT_THAT(refusal([&] { summarize("--window auto"); }),
                HasSubstr("the histories of case soft are means over 2 steps"));
}

TEST_F(Summarize, SaysThatThereAreNoHistories) {
    Campaign campaign = synthetic::campaign();
    auto records = synthetic::records(campaign);
    for (MemberRecord& record : records) record.result.history = {};
    publish(file_, campaign, records, {});
    EXPECT_THAT(summarize("--parts steady"), HasSubstr("the file has no load histories"));
    testing::internal::CaptureStderr();
    summarize("--parts steady --format json");
    EXPECT_THAT(testing::internal::GetCapturedStderr(), HasSubstr("the file has no load histories"));
    EXPECT_THROW(summarize("--window auto"), InputError);
}

TEST_F(Summarize, CountsLevelsInTheWindowThatItMeasures) {
    const json given = json::parse(summarize("--parts exceedance --format json")).at("load_levels");
    ASSERT_EQ(given.size(), 6u);
    EXPECT_EQ(given[0].at("level"), 100);
    // Members 0, 3, 6 and 9 have 20 and their number of 60 steps above it.
    EXPECT_DOUBLE_EQ(given[0].at("time_above").get<double>(), 24.5 / 60);
    // Counted anew in the histories: sines of 100 (number + 1), over the same window.
    const json anew = json::parse(summarize("--parts exceedance --format json --window auto")).at("load_levels");
    EXPECT_NE(anew[0].at("time_above"), given[0].at("time_above"));
}

TEST_F(Summarize, GivesAValueALineForProgramsThatWantItSo) {
    std::istringstream lines(summarize("--format csv --long"));
    std::string line;
    std::getline(lines, line);
    EXPECT_EQ(line, "case,arrangement,quantity,unit,value");
    std::getline(lines, line);
    EXPECT_THAT(line, testing::MatchesRegex("soft,0,mean_load,N,[0-9.e+-]+"));
    const CampaignTable table = read_campaign_file(CampaignFile(file_));
    std::size_t expected = 0;
    for (const MemberRow& row : table.members)
        for (const Quantity& one : table.quantities()) expected += row.done() && std::isfinite(row.value(one)) ? 1 : 0;
    std::size_t count = 1;
    while (std::getline(lines, line)) ++count;
    EXPECT_EQ(count, expected);
    EXPECT_THROW(summarize("--format csv --long --parts pairs"), CommandLineEnd);
    EXPECT_THROW(summarize("--long"), InputError);
}

TEST_F(Summarize, WritesFilesOnRequest) {
    const std::string csv = folder_ / "a.csv";
    EXPECT_EQ(summarize("--format csv -o " + csv), csv + "\n");
    EXPECT_EQ(file_text(csv), summarize("--format csv"));
    const std::string book = folder_ / "a.xlsx";
    EXPECT_EQ(summarize("-o " + book), book + "\n");
    EXPECT_THAT(file_text(book), testing::StartsWith("PK"));
    EXPECT_FALSE(std::filesystem::exists(book + ".tmp"));
    EXPECT_THROW(summarize("--format xlsx"), InputError);
    EXPECT_THROW(summarize("--format csv -o " + book), InputError);
    EXPECT_THROW(summarize("-o " + (folder_ / "no/a.xlsx").string()), CommandLineEnd);
}

TEST_F(Summarize, MovesAMooredHull) {
    Campaign campaign = synthetic::campaign();
    for (const std::size_t index : {0u, 1u}) {
        campaign.cases[index].scenario.structure.speed = 1.1;  // or the hull meets the field's end
        campaign.cases[index].scenario.analysis.window = 3;
    }
    std::vector<MemberRecord> records = synthetic::records(campaign);
    std::ranges::fill(records.at(2).result.history.surge, 0.0);  // ice passed by
    synthetic::publish(file_, campaign, records);
    const std::string hull = "--mooring-kN-m 1000 --mass-t 6.333 --damping-percent 30";
    const std::string told = summarize(hull);
    EXPECT_THAT(told, HasSubstr("natural period 0.5 s"));
    EXPECT_THAT(told, HasSubstr("Response spectrum"));
    EXPECT_THAT(told, Not(HasSubstr("nan")));
    // At 10 % the entry of the hull has not faded, whatever its period.
    EXPECT_THAT(summarize("--parts moored"), HasSubstr("Moored hull: unknown"));
    // Froude: the same hull of a model at 1 : 4.
    const auto moored = [&](const std::string& options) {
        return json::parse(summarize(options + " --format json")).at("moored");
    };
    const auto force = [&](const std::string& options) {
        return moored(options).at("cases").at(0).at("largest_force").get<double>();
    };
    EXPECT_NEAR(force("--mooring-kN-m 16000 --mass-t 405.312 --damping-percent 30 --scale 4"), 64 * force(hull), 1e-6);
    // A point of the spectrum is the hull of its period.
    const json point = moored(hull).at("spectrum").at(5);
    const double omega = 2 * std::numbers::pi / point.at("period").get<double>();
    const json same =
        moored(fmt::format("--mooring-kN-m 1000 --mass-t {} --damping-percent 30", 1000 / (omega * omega)));
    EXPECT_EQ(same.at("cases").at(0).at("case"), point.at("case"));
    EXPECT_NEAR(same.at("cases").at(0).at("amplification").get<double>(), point.at("amplification").get<double>(),
                1e-6);
    EXPECT_THAT(refusal([&] { summarize("--scale 4"); }), HasSubstr("--parts hull"));
    EXPECT_THAT(summarize(hull + " --parts fatigue"), HasSubstr("Cycles and duration of the mooring force k x"));
}

}  // namespace summarize_test
}  // namespace floes
