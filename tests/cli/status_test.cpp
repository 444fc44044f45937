#include <gmock/gmock.h>
#include <sys/wait.h>
#include <unistd.h>

#include <nlohmann/json.hpp>

#include "campaign_file/publish.hpp"
#include "cli/verb_output.hpp"
#include "core/error.hpp"
#include "run/campaign_status.hpp"
#include "store/journal.hpp"
#include "support/file_bytes.hpp"
#include "support/synthetic.hpp"
#include "support/temporary_folder.hpp"

namespace floes {
namespace status_test {

using testing::HasSubstr;
using testing::Not;

// Twelve members: eight done, number 4 failed, numbers 7, 10 and 11 not computed.
std::vector<MemberRecord> some_records(const Campaign& campaign) {
    std::vector<MemberRecord> records = synthetic::records(campaign);
    records.resize(records.size() - 2);
    return records;
}

void expect_counts(const CampaignStatus& status) {
    EXPECT_EQ(status.title, "synthetic");
    ASSERT_EQ(status.cases.size(), 3u);
    EXPECT_EQ(status.cases[0].done, 4);
    EXPECT_EQ(status.cases[1].name, "stiff");
    EXPECT_EQ(status.cases[1].done, 1);
    EXPECT_EQ(status.cases[1].failed, 1);
    EXPECT_EQ(status.cases[1].missing, 2);
    EXPECT_EQ(status.cases[2].missing, 1);
    ASSERT_EQ(status.failures.size(), 1u);
    EXPECT_EQ(status.failures[0].number, 4);
    EXPECT_EQ(status.failures[0].case_name, "stiff");
    EXPECT_EQ(status.failures[0].arrangement, 1);
    EXPECT_THAT(status.failures[0].reason, HasSubstr("ran away"));
}

TEST(Status, IsReadFromTheJournalDuringARunAndAfterIt) {
    const TemporaryFolder folder;
    const Campaign campaign = synthetic::campaign();
    {
        Journal journal = open_journal(journal_path(folder / "a.h5"), campaign, Existing::refuse);
        journal.begin_session(synthetic::session(0));
        for (const MemberRecord& record : some_records(campaign)) journal.append(record);
        journal.hand_over();
        const CampaignStatus live = read_status(folder / "a.h5");
        expect_counts(live);
        EXPECT_TRUE(live.at_work);
        ASSERT_TRUE(live.seconds_left.has_value());
        // Done members took 12.5 to 21.5 s each; three are left on four threads.
        EXPECT_NEAR(*live.seconds_left, 3 * 16.5 / 4, 3.0);
        EXPECT_THAT(status_table(live), HasSubstr("Running: 2 ranks, 4 threads from node0"));
    }
    const CampaignStatus killed = read_status(folder / "a.h5");
    expect_counts(killed);
    EXPECT_FALSE(killed.at_work);
    EXPECT_FALSE(killed.seconds_left.has_value());
    EXPECT_THAT(status_table(killed), HasSubstr("--resume"));
}

TEST(Status, TellsFromTheHeartbeatWhatIsUnderWay) {
    const TemporaryFolder folder;
    const Campaign campaign = synthetic::campaign();
    Heartbeat heartbeat;
    heartbeat.elapsed = 60;
    heartbeat.finished = 6;
    heartbeat.finished_cost = 10;
    heartbeat.remaining_cost = 30;
    heartbeat.under_way = {{7, 2, 33.0}, {5, 2, 20.0}};  // 5 was done since
    write_heartbeat(folder / "a.alive", heartbeat);
    {
        Journal journal = open_journal(journal_path(folder / "a.h5"), campaign, Existing::refuse);
        journal.begin_session(synthetic::session(0));
        for (const MemberRecord& record : some_records(campaign)) journal.append(record);
        journal.hand_over();
        const CampaignStatus live = read_status(folder / "a.h5");
        EXPECT_DOUBLE_EQ(*live.rate, 0.1);
        EXPECT_DOUBLE_EQ(*live.seconds_left, 180);
        const std::string text = status_table(live);
        EXPECT_THAT(text, HasSubstr(", 6.0 members/min, about 3 min left"));
        EXPECT_THAT(text, HasSubstr("running\n  member 7 (case stiff, arrangement 2, attempt 2): 33 s\n"));
        EXPECT_EQ(live.under_way.size(), 1u) << "a member that is done is not running";
        EXPECT_THAT(text, HasSubstr("slowest\n  member 9 (case soft, arrangement 3, attempt 2): 22 s\n"));
        const auto json = nlohmann::json::parse(status_json(live));
        EXPECT_EQ(json["heartbeat"]["stale"], false);
        EXPECT_EQ(json["under_way"].size(), 1u);
        EXPECT_EQ(json["under_way"][0]["member"], 7);
        EXPECT_EQ(json["slowest"].size(), 5u);
        EXPECT_EQ(json["sessions"][0]["computed"], 8);
    }
    // The run was killed: no lock, and no process.
    const pid_t child = fork();
    if (child == 0) {
        write_heartbeat(folder / "a.alive", heartbeat);
        _exit(0);
    }
    waitpid(child, nullptr, 0);
    const CampaignStatus killed = read_status(folder / "a.h5");
    EXPECT_FALSE(killed.at_work);
    EXPECT_FALSE(killed.rate.has_value());
    EXPECT_TRUE(killed.under_way.empty());
    EXPECT_THAT(status_table(killed), HasSubstr("sent its last heartbeat"));
    EXPECT_EQ(nlohmann::json::parse(status_json(killed))["heartbeat"]["stale"], true);
}

TEST(Status, IsReadFromTheCampaignFileAlone) {
    const TemporaryFolder folder;
    const Campaign campaign = synthetic::campaign();
    publish(folder / "a.h5", campaign, some_records(campaign), {});
    expect_counts(read_status(folder / "a.h5"));
}

TEST(Status, WritesAPageOnRequest) {
    const TemporaryFolder folder;
    const std::string file = folder / "a.h5";
    const std::string page = folder / "a.html";
    const Campaign campaign = synthetic::campaign();
    publish(file, campaign, some_records(campaign), {});
    EXPECT_EQ(verb_output(add_status, "status " + file + " --html " + page + " --watch"), page + "\n") << "no run";
    EXPECT_THAT(file_text(page), HasSubstr("<h1>synthetic: 8 of 12 members done, 1 failed, 3 to do</h1>"));
    EXPECT_FALSE(std::filesystem::exists(page + ".tmp"));
    EXPECT_THROW(verb_output(add_status, "status " + file + " --html " + page + " --format json"), CommandLineEnd);
    EXPECT_THROW(verb_output(add_status, "status " + file + " --html " + (folder / "no/such.html").string()),
                 CommandLineEnd);
}

TEST(Status, OfNothingIsRefused) {
    const TemporaryFolder folder;
    EXPECT_THROW(read_status(folder / "a.h5"), InputError);
}

TEST(Status, TableNamesCasesAndFailures) {
    const TemporaryFolder folder;
    const Campaign campaign = synthetic::campaign();
    publish(folder / "a.h5", campaign, some_records(campaign), {});
    const std::string text = status_table(read_status(folder / "a.h5"));
    EXPECT_THAT(text, HasSubstr("synthetic: 8 of 12 members done, 1 failed, 3 to do"));
    EXPECT_THAT(text, HasSubstr("stiff       1       1       2       4"));
    EXPECT_THAT(text, HasSubstr("member 4 (case stiff, arrangement 1): an element ran away"));
    publish(folder / "b.h5", synthetic::campaign(1), synthetic::records(synthetic::campaign(1)), {});
    EXPECT_THAT(status_table(read_status(folder / "b.h5")), Not(HasSubstr("--resume")));
}

TEST(Status, JsonHasTheSameFigures) {
    const TemporaryFolder folder;
    const Campaign campaign = synthetic::campaign();
    Journal journal = open_journal(journal_path(folder / "a.h5"), campaign, Existing::refuse);
    journal.begin_session(synthetic::session(0));
    EXPECT_TRUE(nlohmann::json::parse(status_json(read_status(folder / "a.h5")))["seconds_left"].is_null());
    for (const MemberRecord& record : some_records(campaign)) journal.append(record);
    journal.hand_over();
    const auto json = nlohmann::json::parse(status_json(read_status(folder / "a.h5")));
    EXPECT_EQ(json["done"], 8);
    EXPECT_EQ(json["failed"], 1);
    EXPECT_EQ(json["missing"], 3);
    EXPECT_EQ(json["total"], 12);
    EXPECT_EQ(json["at_work"], true);
    EXPECT_TRUE(json["seconds_left"].is_number());
    EXPECT_EQ(json["cases"][1]["name"], "stiff");
    EXPECT_EQ(json["cases"][1]["missing"], 2);
    EXPECT_EQ(json["failures"][0]["member"], 4);
    EXPECT_EQ(json["sessions"][0]["ranks"], 2);
}

/// The rule holds after two arrangements of four; of the third one member is done.
struct Precise {
    Precise() {
        campaign.stop.half_width = 0.5;
        campaign.stop.minimum = 2;
        campaign.stop.look_ahead = 0;
        for (int number = 0; number < 7; ++number) {
            records.push_back(synthetic::record(campaign, number));
            records.back().result.load.mean = 100 + number;
        }
    }
    Campaign campaign = synthetic::campaign();
    std::vector<MemberRecord> records;
};

TEST(Status, MissesNothingBeyondThePrecisionThatWasWanted) {
    const TemporaryFolder folder;
    Precise precise;
    {
        Journal journal = open_journal(journal_path(folder / "a.h5"), precise.campaign, Existing::refuse);
        journal.begin_session(synthetic::session(0));
        for (const MemberRecord& record : precise.records) journal.append(record);
        journal.hand_over();
        journal.end_session("complete");
    }
    const CampaignStatus status = read_status(folder / "a.h5");
    const std::string text = status_table(status);
    EXPECT_THAT(text, HasSubstr("synthetic: 6 of 6 members done, 0 failed, 0 to do\n"));
    EXPECT_THAT(text, Not(HasSubstr("--resume")));
    // 102 ± 1.5 t(1) / √1: half-widths of 12.706 · 1.5 over 101.5, the smallest of the three means.
    EXPECT_THAT(text, HasSubstr("Precise enough after 2 arrangements of at most 4, no more are needed. Half-width "
                                "for mean_load of every case: 18.8 %, target 50 %.\n"));
    const auto json = nlohmann::json::parse(status_json(status));
    EXPECT_EQ(json["missing"], 0);
    EXPECT_EQ(json["stop"]["met"], true);
    EXPECT_EQ(json["stop"]["arrangements"], 2);
    EXPECT_EQ(json["stop"]["most_arrangements"], 4);
    EXPECT_NEAR(json["stop"]["half_width_percent"].get<double>(), 100 * 12.7062 * 1.5 / 101.5, 1e-3);
    EXPECT_EQ(json["stop"]["wanted_percent"], 50);
}

TEST(Status, TellsHowFarThePrecisionIsThatIsWanted) {
    const TemporaryFolder folder;
    Precise precise;
    precise.campaign.stop.half_width = 0.1;
    precise.campaign.stop.contrast = "stiff - soft";
    precise.campaign.stop.case_name = "soft";
    publish(folder / "a.h5", precise.campaign, precise.records, {});
    const CampaignStatus status = read_status(folder / "a.h5");
    EXPECT_THAT(status_table(status), HasSubstr("5 to do"));
    EXPECT_THAT(status_table(status), HasSubstr("Half-width for mean_load of case soft and of stiff - soft after 2 "
                                                "arrangements of at most 4: 18.8 %, target 10 %.\n"));
    EXPECT_EQ(nlohmann::json::parse(status_json(status))["stop"]["met"], false);
    publish(folder / "b.h5", precise.campaign, {}, {});
    const CampaignStatus none = read_status(folder / "b.h5");
    EXPECT_THAT(status_table(none), HasSubstr("not known yet, target 10 %"));
    EXPECT_TRUE(nlohmann::json::parse(status_json(none))["stop"]["half_width_percent"].is_null());
    publish(folder / "c.h5", synthetic::campaign(), {}, {});
    EXPECT_TRUE(nlohmann::json::parse(status_json(read_status(folder / "c.h5")))["stop"].is_null());
}

}  // namespace status_test
}  // namespace floes
