#include "run/progress.hpp"

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include "support/file_bytes.hpp"
#include "support/temporary_folder.hpp"

namespace floes {
namespace heartbeat_test {

Heartbeat sample() {
    Heartbeat heartbeat;
    heartbeat.elapsed = 12.5;
    heartbeat.finished = 3;
    heartbeat.finished_cost = 30;
    heartbeat.remaining_cost = 90;
    heartbeat.under_way = {{5, 2, 7.25, 86.5, 200}, {6, 1, 0.5}};
    return heartbeat;
}

TEST(Heartbeat, GivesBackWhatWasWritten) {
    const TemporaryFolder folder;
    const auto path = heartbeat_path(folder / "a.h5");
    EXPECT_EQ(path, folder / "a.alive");
    EXPECT_FALSE(read_heartbeat(path));
    write_heartbeat(path, sample());
    const auto read = read_heartbeat(path);
    ASSERT_TRUE(read);
    EXPECT_EQ(read->process, getpid());
    EXPECT_EQ(read->elapsed, 12.5);
    EXPECT_EQ(read->finished, 3);
    EXPECT_EQ(read->finished_cost, 30);
    EXPECT_EQ(read->remaining_cost, 90);
    ASSERT_EQ(read->under_way.size(), 2u);
    EXPECT_EQ(read->under_way[0].number, 5);
    EXPECT_EQ(read->under_way[0].attempt, 2);
    EXPECT_EQ(read->under_way[0].seconds, 7.25);
    EXPECT_EQ(read->under_way[0].time, 86.5);
    EXPECT_EQ(read->under_way[0].end, 200);
    EXPECT_EQ(read->under_way[1].end, 0);
    EXPECT_LT(age_of(*read), 10);
    EXPECT_FALSE(is_stale(*read));
    EXPECT_FALSE(std::filesystem::exists(folder / "a.alive.tmp"));
}

TEST(Heartbeat, IsStaleWhenItsProcessIsGoneOrSilent) {
    const TemporaryFolder folder;
    write_heartbeat(folder / "a.alive", sample());
    Heartbeat read = *read_heartbeat(folder / "a.alive");
    const std::string here = read.host;
    read.time -= 120;
    read.written -= 120;
    EXPECT_TRUE(is_stale(read));
    read.time += 120;
    read.written += 120;
    const pid_t child = fork();
    if (child == 0) _exit(0);
    waitpid(child, nullptr, 0);
    read.process = child;
    EXPECT_TRUE(is_stale(read));
    read.host = "elsewhere";
    EXPECT_FALSE(is_stale(read)) << "processes of another machine cannot be asked for";
}

TEST(Heartbeat, OfAHostWhoseClockIsOffIsJudgedByTheFileSystem) {
    const TemporaryFolder folder;
    write_heartbeat(folder / "a.alive", sample());
    for (const int off : {-3600, 3600}) {
        Heartbeat read = *read_heartbeat(folder / "a.alive");
        read.host = "elsewhere";
        read.time += off;
        EXPECT_FALSE(is_stale(read)) << off;
        EXPECT_LT(age_of(read), 30);
        read.time -= 1800;
        read.written -= 1800;  // it died half an hour ago
        EXPECT_TRUE(is_stale(read)) << off;
        EXPECT_NEAR(age_of(read), 1800, 30);
    }
}

TEST(Heartbeat, ThatCannotBeWrittenOrUnderstoodIsNoTrouble) {
    const TemporaryFolder folder;
    write_heartbeat(folder / "no/folder/a.alive", sample());
    for (const std::string text :
         {"", "host\n", "Dear reader", "host h\nprocess many\n", "host h\nprocess 1\nmember 2\n"}) {
        write_file_bytes(folder / "a.alive", std::as_bytes(std::span(text)));
        EXPECT_FALSE(read_heartbeat(folder / "a.alive")) << text;
    }
}

TEST(Metrics, AreInTheTextFormatOfPrometheus) {
    const std::string text =
        metrics_text({.campaign = "a \"b\"\\", .done = 5, .failed = 1, .running = 2, .to_do = 4, .seconds_left = 90});
    EXPECT_NE(text.find("# TYPE floes_members gauge\nfloes_members{campaign=\"a \\\"b\\\"\\\\\",state=\"done\"} 5\n"),
              std::string::npos)
        << text;
    EXPECT_NE(text.find(",state=\"to_do\"} 4\n"), std::string::npos);
    EXPECT_NE(text.find("floes_run_active{campaign="), std::string::npos);
    EXPECT_NE(text.find("} 90\n"), std::string::npos);
    EXPECT_EQ(metrics_text({}).find("floes_left_seconds"), std::string::npos) << "not known";
}

TEST(Metrics, ReplaceTheFile) {
    const TemporaryFolder folder;
    write_metrics(folder / "a.prom", {.done = 1});
    write_metrics(folder / "a.prom", {.at_work = false, .done = 2});
    EXPECT_EQ(file_text(folder / "a.prom"), metrics_text({.at_work = false, .done = 2}));
    EXPECT_FALSE(std::filesystem::exists(folder / "a.prom.tmp"));
}

}  // namespace heartbeat_test
}  // namespace floes
