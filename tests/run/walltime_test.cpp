#include "run/signals.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>

#include "run/worker.hpp"
#include "support/temporary_folder.hpp"

namespace floes {
namespace walltime_test {

using std::chrono::milliseconds;
using std::chrono::seconds;

TEST(TimeLeftText, IsReadInEveryShapeThatSqueueHas) {
    EXPECT_EQ(parse_time_left("1-02:03:04\n"), 93784.0);
    EXPECT_EQ(parse_time_left("2:03:04"), 7384.0);
    EXPECT_EQ(parse_time_left("12:34"), 754.0);
    EXPECT_EQ(parse_time_left("0:00"), 0.0);
    for (const char* text : {"", "\n", "UNLIMITED", "NOT_SET", "INVALID", "1:2:3:4", "-5", "1-", "a:10"}) {
        EXPECT_FALSE(parse_time_left(text)) << text;
    }
}

TEST(TimeLeft, IsWhatTheUserSaysFirst) {
    EXPECT_EQ(find_time_left(120).seconds, 120.0);
}

/// Programs that stand for squeue, inside a job.
class TimeLeftInAJob : public testing::Test {
  protected:
    TimeLeftInAJob() {
        ::setenv("SLURM_JOB_ID", "12", 1);
        ::setenv("PATH", ((folder_ / "").parent_path().string() + ":" + path_).c_str(), 1);
    }
    ~TimeLeftInAJob() override {
        ::setenv("PATH", path_.c_str(), 1);
        for (const char* name : {"SLURM_JOB_ID", "SLURM_ARRAY_JOB_ID", "SLURM_ARRAY_TASK_ID"}) ::unsetenv(name);
    }

    JobTimeLeft with(const std::string& does, double longest = 60) {
        std::ofstream(folder_ / "squeue") << "#!/bin/sh\n" << does << "\n";
        std::filesystem::permissions(folder_ / "squeue", std::filesystem::perms::owner_all);
        return find_time_left(0, Seconds(longest));
    }

    TemporaryFolder folder_;
    std::string path_ = std::getenv("PATH");
};

TEST_F(TimeLeftInAJob, IsWhatSqueueSays) {
    EXPECT_EQ(with("test \"$*\" = '-h -j 12 -o %L' && echo 1:30").seconds, 90.0);
    const JobTimeLeft unlimited = with("echo UNLIMITED");
    EXPECT_FALSE(unlimited.seconds);
    EXPECT_EQ(unlimited.remark, "");
}

// One task of an array has the number of the whole array.
TEST_F(TimeLeftInAJob, IsThatOfTheTaskInAnArray) {
    ::setenv("SLURM_ARRAY_JOB_ID", "12", 1);
    ::setenv("SLURM_ARRAY_TASK_ID", "3", 1);
    EXPECT_EQ(with("test \"$*\" = '-h -j 12_3 -o %L' && echo 1:30").seconds, 90.0);
}

TEST_F(TimeLeftInAJob, IsNotKnownWhereSqueueHangsOrFails) {
    for (const auto& [does, said] :
         {std::pair{"exec sleep 300", "squeue did not answer within 300 ms"},
          {"echo slurm_load_jobs; exit 1", "squeue answers \"slurm_load_jobs\" and ends with status 1"},
          {"echo INVALID", "squeue answers \"INVALID\" and ends with status 0"}}) {
        const JobTimeLeft left = with(does, std::string(does).starts_with("exec") ? 0.3 : 60);
        EXPECT_FALSE(left.seconds);
        EXPECT_THAT(left.remark, testing::HasSubstr(said));
        EXPECT_THAT(left.remark, testing::HasSubstr("or give --time-left SECONDS"));
    }
    ::setenv("PATH", "/nowhere", 1);
    EXPECT_THAT(find_time_left(0).remark, testing::HasSubstr("squeue cannot be started (No such file or directory)"));
}

TEST(WalltimeClock, KeepsTimeForPublishing) {
    const Walltime::Time now{};
    const Walltime longer(7200.0, now);
    EXPECT_DOUBLE_EQ(*longer.left(now), 7140);
    EXPECT_DOUBLE_EQ(*longer.left(now + seconds(7200)), -60);
    EXPECT_DOUBLE_EQ(*Walltime(100.0, now).left(now), 90);
    EXPECT_FALSE(Walltime().left(now));
}

TEST(SilenceOfRanks, CountsOnlyWhileSomebodyListens) {
    const Silence::Time begin{};
    Silence silence(3, begin);
    silence.listened(begin + milliseconds(500));
    silence.heard(1);
    silence.listened(begin + seconds(1000));  // this process was stopped meanwhile
    EXPECT_DOUBLE_EQ(silence.of(1), 1.0);
    EXPECT_DOUBLE_EQ(silence.of(2), 1.5);
}

}  // namespace walltime_test
}  // namespace floes
