// Other programs are started, heard and, where they hang, ended.

#include "core/started_program.hpp"

#include <gtest/gtest.h>

#include <csignal>
#include <cstdlib>

namespace floes {
namespace started_program_test {

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point begin) {
    return Seconds(Clock::now() - begin).count();
}

ProgramAnswer shell(const std::string& script, double longest) {
    return answer_of({"sh", "-c", script}, Seconds(longest));
}

TEST(StartedProgram, IsHeard) {
    const ProgramAnswer answer = shell("echo 1:30; echo unheard >&2; read nothing; exit 3", 60);
    EXPECT_EQ(answer.output, "1:30\n");
    EXPECT_EQ(answer.status, 3);
    EXPECT_FALSE(answer.good());
    EXPECT_TRUE(shell("true", 60).good());
    EXPECT_EQ(shell("kill -TERM $$", 60).status, 128 + SIGTERM);
    EXPECT_EQ(shell("yes | head -c 100000", 60).output.size(), 4096u);
}

TEST(StartedProgram, IsEndedWhenItHangs) {
    const Clock::time_point begin = Clock::now();
    for (const char* script : {"exec sleep 300", "trap '' TERM HUP INT; while :; do :; done", "exec yes"}) {
        const ProgramAnswer answer = shell(script, 0.3);
        EXPECT_TRUE(answer.fault.empty());
        EXPECT_FALSE(answer.status) << script;
    }
    EXPECT_LT(seconds_since(begin), 60);
}

TEST(StartedProgram, IsNotWaitedForThroughAProcessThatItLeaves) {
    const Clock::time_point begin = Clock::now();
    const ProgramAnswer answer = shell("echo here; sleep 100 & exit 0", 90);
    EXPECT_LT(seconds_since(begin), 60);
    EXPECT_TRUE(answer.good());
    EXPECT_EQ(answer.output, "here\n");
}

TEST(StartedProgram, SaysWhyItCannotBe) {
    const ProgramAnswer answer = answer_of({"no_such_program_of_floes"}, Seconds(60));
    EXPECT_EQ(answer.fault, "No such file or directory");
    EXPECT_FALSE(answer.status);
}

TEST(StartedProgram, IsKnownBeforehand) {
    EXPECT_TRUE(is_program("sh"));
    EXPECT_TRUE(is_program("/bin/sh"));
    EXPECT_FALSE(is_program("no_such_program_of_floes"));
    EXPECT_FALSE(is_program("/etc/passwd"));
    EXPECT_FALSE(is_program("/etc"));
}

TEST(StartedProgram, HasTheUsualSignals) {
    std::signal(SIGPIPE, SIG_IGN);
    EXPECT_EQ(shell("kill -PIPE $$; echo survived", 60).status, 128 + SIGPIPE);
    std::signal(SIGPIPE, SIG_DFL);
}

}  // namespace started_program_test
}  // namespace floes
