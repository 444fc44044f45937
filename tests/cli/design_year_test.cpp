// floes design --regimes, from files on the disk to standard output, pages and workbooks.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <nlohmann/json.hpp>

#include "cli/verb_output.hpp"
#include "core/error.hpp"
#include "support/file_bytes.hpp"
#include "support/published.hpp"
#include "support/refusal.hpp"
#include "support/temporary_folder.hpp"

namespace floes {
namespace design_year_test {

using testing::HasSubstr;

/// Levels that so few peaks say something of.
const std::string likely = "--per-year 0.5,0.45 ";

/// Of the synthetic campaign with exponential peaks of 20 N above 30 N, eight in a window.
class DesignYear : public testing::Test {
  protected:
    DesignYear() {
        Campaign campaign = synthetic::campaign(24);
        for (Case& one : campaign.cases) one.scenario.analysis.peak_separation = 0.01;  // peaks hide none
        std::vector<MemberRecord> records;
        for (int number = 0; number < member_count(campaign); ++number)
            records.push_back(synthetic::record_with_peaks(campaign, number));
        synthetic::publish(file_, campaign, records);
        put("year.toml",
            "[[regime]]\nhours_per_year = 3\ncase = \"soft\"\n[[regime]]\nhours_per_year = 1\ncase = "
            "\"stiff\"\n");
        put("year.CSV", "case,hours_per_year\nsoft,3\nstiff,1\n");
    }

    std::string got(const std::string& name) const { return file_text(folder_ / name); }

    void put(const std::string& name, const std::string& text) { std::ofstream(folder_ / name) << text; }

    std::string year(const std::string& regimes, const std::string& arguments = {}, int wanted = 0) {
        const auto [output, status] =
            verb_answer(add_design, words_of("design " + file_.string() + " --averaging-s 0.4 --regimes " +
                                             (folder_ / regimes).string() + " " + arguments));
        EXPECT_EQ(status, wanted) << output;
        return output;
    }

    TemporaryFolder folder_;
    std::filesystem::path file_ = folder_ / "synthetic.h5";
};

TEST_F(DesignYear, IsTheSameFromTomlAndFromAScatterDiagram) {
    const std::string told = year("year.toml", likely + "--format json");
    EXPECT_EQ(told, year("year.CSV", likely + "--format json"));
    const auto loads = nlohmann::json::parse(told).at("year").at("loads");
    EXPECT_EQ(loads.size(), 2u);
    EXPECT_GT(loads.at(1).at("load").get<double>(), loads.at(0).at("load").get<double>());
}

// The exit status says so, and no file has what the screen leaves out.
TEST_F(DesignYear, HasNoLoadWhereTheTailsCannotSay) {
    const std::string told = year("year.toml", "--format csv -o " + (folder_ / "y.xlsx").string(), 1);
    EXPECT_THAT(told, HasSubstr("\n0.01,0.4,1,,"));
    EXPECT_THAT(year("year.toml", "", 1), HasSubstr("10^-2: the tail cannot say"));
}

TEST_F(DesignYear, IsAlsoAPageAPictureAndAWorkbook) {
    for (const char* name : {"y.html", "y.svg", "y.xlsx"})
        year("year.toml", likely + "-o " + (folder_ / name).string());
    EXPECT_THAT(got("y.html"), HasSubstr("probability of exceedance in a year"));
    EXPECT_THAT(got("y.html"), HasSubstr("--per-year 0.5,0.45"));
    EXPECT_THAT(got("y.svg"), testing::StartsWith("<svg xmlns="));
    EXPECT_THAT(got("y.svg"), testing::Not(HasSubstr("var(")));  // Word and librsvg know no names of colours
    EXPECT_THAT(got("y.xlsx"), testing::StartsWith("PK"));
    EXPECT_THAT(refusal([&] { year("year.toml", "-o y.docx"); }), HasSubstr("ends with .html, .pdf, .svg or .xlsx"));
}

TEST_F(DesignYear, NamesTheCommandThatHelps) {
    const std::string told = year("year.toml", "--next --per-year 0.5,0.1");
    EXPECT_THAT(told, HasSubstr("10^-1"));
    EXPECT_THAT(told, HasSubstr("--set campaign.arrangements=48 --resume"));
}

TEST_F(DesignYear, RefusesWhatItCannotAnswer) {
    EXPECT_THAT(refusal([&] { year("missing.toml"); }), HasSubstr("missing.toml"));
    EXPECT_THROW(year("year.toml", "--exposure-h 3"), CommandLineEnd);
    EXPECT_THROW(verb_output(add_design, "design " + file_.string() + " --next"), CommandLineEnd);
    EXPECT_THROW(year("year.toml", "--per-year 2"), CommandLineEnd);
}

}  // namespace design_year_test
}  // namespace floes
