// floes report, from a campaign file on the disk to a page.

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>

#include "cli/answer.hpp"
#include "cli/verb_output.hpp"
#include "core/error.hpp"
#include "support/file_bytes.hpp"
#include "support/published.hpp"
#include "support/temporary_folder.hpp"

namespace floes {
namespace report_test {

using testing::HasSubstr;
using testing::Not;

/// The letters of a picture may be any word.
std::string without_pictures(std::string page) {
    const std::string begin = "base64,";
    for (std::size_t at = 0; (at = page.find(begin, at)) != std::string::npos; at += begin.size())
        page.erase(at + begin.size(), page.find_first_of("\"')", at) - at - begin.size());
    return page;
}

class Report : public testing::Test {
  protected:
    void run(const std::string& arguments) {
        EXPECT_EQ(verb_output(add_report, "report " + arguments), page_.string() + "\n");
    }

    TemporaryFolder folder_;
    std::filesystem::path file_ = folder_ / "synthetic.h5";
    std::filesystem::path page_ = folder_ / "page.html";
};

TEST_F(Report, TellsOfEveryCaseAndHowToRepeatIt) {
    const Campaign campaign = synthetic::campaign();
    synthetic::publish(file_, campaign);
    run(file_.string() + " -o " + page_.string());
    const std::string page = file_text(page_);
    for (const Case& one : campaign.cases) EXPECT_THAT(page, HasSubstr("<td>" + one.name + "</td>"));
    EXPECT_THAT(page, HasSubstr("floes run CONFIG.toml -o synthetic.h5"));
    EXPECT_THAT(page, HasSubstr("name = &quot;stiff&quot;"));  // the configuration
    EXPECT_THAT(without_pictures(page), Not(HasSubstr("nan")));
    EXPECT_THAT(page, HasSubstr("1 set aside as failed"));
}

TEST_F(Report, SaysWhenThereAreNoHistoriesAndDrawsTheLevelsCounted) {
    const Campaign campaign = synthetic::campaign();
    auto records = synthetic::records(campaign);
    for (MemberRecord& record : records) record.result.history = {};
    synthetic::publish(file_, campaign, records);
    run(file_.string() + " --no-plate-tests -o " + page_.string());
    EXPECT_THAT(file_text(page_), HasSubstr("the file has no load histories"));
    EXPECT_THAT(file_text(page_), HasSubstr("Share of the time with a surge load above a level"));
}

// Histories of the first arrangement reach up to 600 N, those of the second file to 0.6 N: shifts of 500 and 0.5 N.
TEST_F(Report, DrawsLoadsOverTimeAsLargeAsTheyAre) {
    const Campaign campaign = synthetic::campaign_with_design();
    std::vector<MemberRecord> records = synthetic::all_done_records(campaign);
    synthetic::publish(file_, campaign, records);
    run(file_.string() + " --no-plate-tests --pictures none -o " + page_.string());
    EXPECT_THAT(file_text(page_), HasSubstr("each case shifted by 500 N"));
    for (MemberRecord& record : records)
        for (double& load : record.result.history.surge) load *= 1e-3;
    synthetic::publish(file_, campaign, records);
    run(file_.string() + " --no-plate-tests --pictures none -o " + page_.string());
    EXPECT_THAT(file_text(page_), HasSubstr("each case shifted by 0.5 N"));
    EXPECT_THAT(file_text(page_), HasSubstr("soft: thickness 0.05 m, Σ 0.1"));  // the point by its keys
}

TEST_F(Report, TellsOfACampaignWithoutAnyResult) {
    synthetic::publish(file_, synthetic::campaign(), {});
    run(file_.string() + " --no-plate-tests -o " + page_.string());
    EXPECT_THAT(file_text(page_), HasSubstr("0 simulations done"));
}

TEST_F(Report, TellsWhatDecidesTheLoadOfADesign) {
    const Campaign campaign = synthetic::campaign_with_design();
    synthetic::publish(file_, campaign, {});
    run(file_.string() + " --no-plate-tests -o " + page_.string());
    EXPECT_THAT(file_text(page_), HasSubstr("no plane"));
    synthetic::publish(file_, campaign, {synthetic::record(campaign, 0)});
    run(file_.string() + " --no-plate-tests -o " + page_.string());
    EXPECT_THAT(file_text(page_), HasSubstr("<h2>What decides the load?</h2>"));
    EXPECT_THAT(file_text(page_), HasSubstr("<td>soft+0.05_0.1</td><td>0.05</td><td>0.1</td>"));
}

TEST_F(Report, SaysWhatItCannotReadOrWrite) {
    EXPECT_THROW(run(file_.string()), InputError);
    synthetic::publish(file_);
    EXPECT_THROW(run(file_.string() + " --no-plate-tests -o " + (folder_ / "no/such/folder.html").string()),
                 CommandLineEnd);
    std::filesystem::create_directories(page_ / "with something in it");
    EXPECT_THROW(run(file_.string() + " --no-plate-tests -o " + page_.string()), CommandLineEnd);
    EXPECT_FALSE(std::filesystem::exists(page_.string() + ".tmp"));
}

TEST_F(Report, ExtrapolatesToTheExposureThatIsAskedFor) {
    const Campaign campaign = synthetic::campaign();
    synthetic::publish(file_, campaign);
    const std::string time = fmt::format("{:g}", campaign.cases.front().scenario.analysis.averaging.back());
    run(file_.string() + " --pictures none --exposure-h 7 --averaging-s " + time + " -o " + page_.string());
    EXPECT_THAT(file_text(page_), HasSubstr("the largest load averaged over " + time + " s in 7 h"));
    EXPECT_THROW(run(file_.string() + " --pictures none --averaging-s 0.321 -o " + page_.string()), InputError);
}

/// A program that stands for a browser: it writes the file that it is asked for, or nothing.
class PrintedReport : public Report {
  protected:
    void browser(const std::string& does) {
        const std::filesystem::path program = folder_ / "browser";
        std::ofstream(program) << "#!/bin/sh\n" << does << "\n";
        std::filesystem::permissions(program, std::filesystem::perms::owner_all);
        setenv("FLOES_BROWSER", program.c_str(), 1);
    }
    void SetUp() override {
        synthetic::publish(file_);
        page_ = folder_ / "page.pdf";
    }
    void TearDown() override { unsetenv("FLOES_BROWSER"); }
    std::size_t files() const {
        return static_cast<std::size_t>(std::ranges::distance(std::filesystem::directory_iterator(folder_ / ".")));
    }
};

TEST_F(PrintedReport, IsWhatTheBrowserPrints) {
    browser(
        "for word; do case $word in --print-to-pdf=*) (echo %PDF-1.4; cat \"${word#*=}\") 2>/dev/null "
        ">\"${word#*=}\";; esac; done");
    const std::size_t before = files();
    run(file_.string() + " --pictures none -o " + page_.string());
    EXPECT_THAT(file_text(page_), testing::StartsWith("%PDF"));
    EXPECT_EQ(files(), before + 1);
}

TEST_F(PrintedReport, SaysWhichBrowserFailed) {
    browser("exit 3");
    const std::size_t before = files();
    EXPECT_THAT([&] { run(file_.string() + " --pictures none -o " + page_.string()); },
                testing::ThrowsMessage<RunError>(HasSubstr("could not print " + page_.string() + " (exit status 3)")));
    setenv("FLOES_BROWSER", (folder_ / "none").c_str(), 1);
    EXPECT_THAT([&] { run((folder_ / "no_such_file.h5").string() + " -o " + page_.string()); },
                testing::ThrowsMessage<CommandLineEnd>(HasSubstr("name it with FLOES_BROWSER")))
        << "before anything is read";
    EXPECT_EQ(files(), before);
}

TEST_F(PrintedReport, DoesNotWaitForABrowserThatHangs) {
    browser("exec sleep 300");
    EXPECT_THAT([&] { write_page(page_, "<html></html>", Seconds(0.3)); },
                testing::ThrowsMessage<RunError>(
                    HasSubstr("could not print " + page_.string() + " (it took longer than 0.3 s)")));
    EXPECT_FALSE(std::filesystem::exists(page_));
}

TEST_F(Report, HasACommandThatAShellTakes) {
    Campaign campaign = synthetic::campaign();
    campaign.name = "my channel";
    synthetic::publish(file_, campaign);
    run(file_.string() + " --pictures none -o " + page_.string());
    EXPECT_THAT(file_text(page_), HasSubstr("floes run CONFIG.toml -o 'my channel.h5'"));
}

}  // namespace report_test
}  // namespace floes
