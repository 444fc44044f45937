// kill -9 at a random moment: everything that the writer reported as stored is stored, and the campaign file is always
// whole.

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <csignal>
#include <random>
#include <thread>

#include "campaign_file/publish.hpp"
#include "campaign_file/read.hpp"
#include "store/journal.hpp"
#include "support/synthetic.hpp"
#include "support/temporary_folder.hpp"
#include "support/whole_records.hpp"

namespace floes {
namespace killed_writer_test {

constexpr int rounds = 60;

// Forks, lets `work` run in the child for at most `life`, kills it, and gives what it wrote to the pipe.
template <class Work>
std::string run_and_kill(std::chrono::microseconds life, const Work& work) {
    int ends[2];
    if (pipe(ends) != 0) throw std::runtime_error("no pipe");
    const pid_t child = fork();
    if (child == 0) {
        close(ends[0]);
        try {
            work(ends[1]);
        } catch (...) {
            _exit(1);
        }
        _exit(0);
    }
    close(ends[1]);
    std::this_thread::sleep_for(life);
    kill(child, SIGKILL);
    std::string said;
    char buffer[4096];
    for (ssize_t got = 0; (got = read(ends[0], buffer, sizeof buffer)) > 0;)
        said.append(buffer, static_cast<std::size_t>(got));
    close(ends[0]);
    waitpid(child, nullptr, 0);
    return said;
}

TEST(KilledWriter, LosesNoRecordThatItAcknowledged) {
    const TemporaryFolder folder;
    const auto path = folder / "a.journal";
    const Campaign campaign = synthetic::campaign(1);
    const MemberRecord model = synthetic::record(campaign, 0);
    std::mt19937 random(20);
    std::uniform_int_distribution<int> life(0, 15000);
    std::size_t acknowledged = 0;
    constexpr std::size_t enough = 100;  // on a busy machine in more and longer rounds
    for (int round = 0; round < rounds || (acknowledged <= enough && round < 10 * rounds); ++round) {
        SCOPED_TRACE(round);
        const std::chrono::microseconds lives(life(random) * (1 + round / rounds));
        const std::string said = run_and_kill(lives, [&](int out) {
            Journal journal = open_journal(path, "", Existing::resume);
            MemberRecord record = model;
            while (true) {
                record.attempt = static_cast<int>(journal.members().notes().size());
                journal.append(record);
                journal.hand_over();
                if (record.attempt % 16 == 0) journal.sync();
                if (::write(out, "a", 1) != 1) _exit(1);
            }
        });
        acknowledged += said.size();
        const Journal journal = open_journal(path, "", Existing::resume);
        // One record more may be stored whose acknowledgement the kill came before.
        ASSERT_GE(journal.members().notes().size(), acknowledged);
        ASSERT_LE(journal.members().notes().size(), acknowledged + 1);
        acknowledged = journal.members().notes().size();
        MemberRecord expected = model;
        expected.attempt = 0;
        for (const MemberRecord& record : whole_records(journal.members())) {
            ASSERT_EQ(encode(record), encode(expected));
            ++expected.attempt;
        }
    }
    EXPECT_GT(acknowledged, enough);
}

TEST(KilledWriter, LeavesTheOldCampaignFileOrTheNewOne) {
    const TemporaryFolder folder;
    const auto path = folder / "a.h5";
    const Campaign campaign = synthetic::campaign(20);
    const auto records = synthetic::records(campaign);
    const std::span<const MemberRecord> all(records);
    const auto begin = std::chrono::steady_clock::now();
    publish(path, campaign, all.first(1), {});
    const std::chrono::duration<double, std::micro> one_publish = std::chrono::steady_clock::now() - begin;
    std::mt19937 random(21);
    double longest = 3 * std::clamp(one_publish.count(), 10e3, 200e3);
    std::size_t published = 0;
    for (int round = 0; round < rounds; ++round) {
        SCOPED_TRACE(round);
        std::uniform_real_distribution<double> life(0, longest);
        const std::string said = run_and_kill(std::chrono::microseconds(std::lround(life(random))), [&](int out) {
            for (std::size_t count = 1;; count = 1 + count % 30) {
                publish(path, campaign, all.first(count), {});
                if (::write(out, "p", 1) != 1) _exit(1);
            }
        });
        published += said.size();
        if (said.empty()) longest *= 1.1;  // a disk that others use is slower than it was for the first
        const CampaignTable table = read_campaign_file(path);
        ASSERT_EQ(table.members.size(), 60u);
        std::size_t known = 0;
        while (known < 60 && table.members[known].status != RowStatus::missing) ++known;
        ASSERT_GE(known, 1u);
        for (std::size_t k = 0; k < known; ++k) {
            const bool failed = table.members[k].status == RowStatus::failed;
            ASSERT_TRUE(failed || table.members[k].load.mean == records[k].result.load.mean) << k;
        }
    }
    EXPECT_GT(published, 5u);
}

}  // namespace killed_writer_test
}  // namespace floes
