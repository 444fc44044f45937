// The picture of floes status --watch, without a terminal.

#include "cli/watch.hpp"

#include <gmock/gmock.h>

#include <fmt/ranges.h>

#include <algorithm>
#include <string>
#include <vector>

#include "core/text.hpp"
#include "support/synthetic.hpp"
#include "tables/table.hpp"

namespace floes {
namespace watch_test {

using testing::HasSubstr;
using testing::Not;

/// Three cases of eight: running, with a failure and a stop rule's worth of words.
WatchedRun some_run() {
    CampaignSnapshot snapshot;
    snapshot.campaign = synthetic::campaign(8);
    std::vector<MemberRecord> records = synthetic::records(snapshot.campaign);
    records.resize(16);  // up to number 16
    snapshot.table = campaign_table(snapshot.campaign, std::span<const MemberRecord>(records));
    CampaignStatus& status = snapshot.status;
    status.title = "synthetic";
    status.cases = {{"soft", 6, 0, 2}, {"stiff", 4, 1, 3}, {"open", 5, 0, 3}};
    status.failures = {{4, "stiff", 1, "an element ran away at 12.34 s: 11 m/s, allowed ≤ 10 m/s"}};
    status.sessions = {synthetic::session()};
    status.at_work = true;
    status.rate = 0.07;
    status.seconds_left = 300;
    status.under_way = {{7, "stiff", 2, 2, 95, 43, 100}, {18, "soft", 6, 1, 20}};
    status.slowest = {{9, "soft", 3, 1, 120}};
    WatchedRun run = watched(snapshot);
    run.memory = 312.0 * 1024 * 1024;
    run.at_hand = 18.25 * 1024 * 1024 * 1024;
    return run;
}

std::string frame(const WatchedRun& run, int columns, int rows, Letters letters = Letters::unicode) {
    const std::vector<std::string> lines = watch_frame(run, {columns, rows, letters});
    EXPECT_LE(std::ssize(lines), rows);
    for (const std::string& line : lines) EXPECT_LE(static_cast<int>(text_width(line)), columns) << line;
    return fmt::format("{}\n", fmt::join(lines, "\n"));
}

TEST(WatchFrame, SaysWhatIsDoneRunningFailedAndLeft) {
    const std::string text = frame(some_run(), 100, 50);
    EXPECT_THAT(text, HasSubstr("synthetic: 15 of 24 members done, 1 failed, 8 to do\n"));
    EXPECT_THAT(text, HasSubstr("4.2 members/min, about 5 min"));
    EXPECT_THAT(text, HasSubstr("Memory: 312 MiB of this run on this host, 18.2 GiB at hand."));
    EXPECT_THAT(text, HasSubstr("failed: 1 member\n  4 (stiff): an element ran away"));
    EXPECT_THAT(
        text,
        HasSubstr("running, longest first\n  7 (stiff, attempt 2): 95 s, at 43 % (43 of 100 s)\n  18 (soft): 20 s"));
    EXPECT_THAT(text, HasSubstr("slowest\n  9 (soft): 2 min"));
}

TEST(WatchFrame, DrawsABarAndTheIntervalOfEachCase) {
    const std::string text = frame(some_run(), 60, 24);
    const std::string stiff =
        text.substr(text.find("stiff "), text.find('\n', text.find("stiff ")) - text.find("stiff "));
    for (const char* sign : {"█", "▓", "×", "░"}) EXPECT_THAT(stiff, HasSubstr(sign));
    EXPECT_THAT(stiff, HasSubstr("4 of 8"));
    // Means of members 1, 10, 13 and 16 of 200 to 1700 N: 1100 N, and t(3) s / √4.
    EXPECT_THAT(stiff, HasSubstr("1100 ± 1031 N"));
    EXPECT_THAT(text, HasSubstr("± 95 % interval"));
}

TEST(WatchFrame, DrawsHalfWidthsOverMembersWhereThereIsRoom) {
    const std::string text = frame(some_run(), 100, 60);
    EXPECT_THAT(text, HasSubstr("± of the mean load over members, %"));
    EXPECT_THAT(text, HasSubstr("a soft  b stiff  c open"));
    EXPECT_THAT(frame(some_run(), 100, 20), Not(HasSubstr("over members, %")));
}

TEST(WatchFrame, StandsSideBySideOnAWideScreen) {
    const std::string text = frame(some_run(), 200, 30);
    const std::size_t line = text.find("case ");
    EXPECT_THAT(text.substr(line, text.find('\n', line) - line), HasSubstr("over members, %"));
}

TEST(WatchFrame, HasAsciiAloneWhereTheTerminalHas) {
    const std::string text = frame(some_run(), 60, 60, Letters::ascii);
    EXPECT_TRUE(
        std::ranges::all_of(text, [](char letter) { return letter == '\n' || (letter >= ' ' && letter <= '~'); }));
    EXPECT_THAT(text, HasSubstr("1100 +- 1031 N\n"));
    EXPECT_THAT(text, HasSubstr("<= 10 m/s\n"));
    EXPECT_THAT(text, HasSubstr("# done  + running  x failed  . to do"));
}

TEST(WatchFrame, FitsIntoAnyScreen) {
    WatchedRun run = some_run();
    for (int k = 0; k < 300; ++k) {
        run.status.cases.push_back({"a case of a long name, number " + std::to_string(k), 1, 0, k % 2});
        run.loads.push_back(run.loads.front());
    }
    for (const int columns : {20, 40, 60, 80, 119, 120, 200, 400})
        for (const int rows : {1, 5, 12, 24, 60}) frame(run, columns, rows);
    EXPECT_THAT(frame(run, 80, 24), HasSubstr("further cases"));
}

TEST(WatchFrame, OfNothingDoneHasNoFigures) {
    CampaignSnapshot snapshot;
    snapshot.campaign = synthetic::campaign();
    snapshot.table = campaign_table(snapshot.campaign, std::span<const MemberRecord>{});
    snapshot.status.title = "synthetic";
    for (const Case& one : snapshot.campaign.cases) snapshot.status.cases.push_back({one.name, 0, 0, 4});
    const std::string text = frame(watched(snapshot), 80, 40);
    EXPECT_THAT(text, HasSubstr("0 of 12 members done"));
    EXPECT_THAT(text, Not(HasSubstr("nan")));
    EXPECT_THAT(text, Not(HasSubstr("over members, %")));
}

}  // namespace watch_test
}  // namespace floes
