// floes replay: what it makes, by the ending of its name, and what it refuses.

#include "draw/replay_output.hpp"

#include <gmock/gmock.h>

#include <fstream>

#include "cli/commands.hpp"
#include "core/error.hpp"
#include "draw/synthetic_recording.hpp"
#include "support/published.hpp"
#include "support/refusal.hpp"
#include "support/temporary_folder.hpp"

namespace floes {
namespace replay_test {

using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

int run(const std::vector<std::string>& words) {
    CommandLine line;
    add_replay(line);
    return line.run(words);
}

TEST(ReplayOutput, IsWhatItsEndingSays) {
    EXPECT_EQ(kind_of("a.h5"), ReplayOutput::recording);
    EXPECT_EQ(kind_of("a.html"), ReplayOutput::page);
    EXPECT_EQ(kind_of("a.svg"), ReplayOutput::picture);
    EXPECT_EQ(kind_of("a.b.webm"), ReplayOutput::film);
    EXPECT_EQ(kind_of("a.xdmf2"), ReplayOutput::series);
    EXPECT_THAT(refusal([] { kind_of("a.avi"); }), HasSubstr(".html a page that plays, .png or .svg a picture"));
}

TEST(ReplayOutput, ThatCannotHaveItsNameLeavesNothingBehind) {
    const TemporaryFolder folder;
    synthetic::write_recording(folder / "recording.h5", 3);
    const std::filesystem::path path = folder / "a.html";
    std::filesystem::create_directories(path / "taken");
    EXPECT_THAT([&] { write_replay_output(path, Recording(folder / "recording.h5"), {}, [](double) {}); },
                testing::ThrowsMessage<RunError>(HasSubstr("renaming ")));
    EXPECT_FALSE(std::filesystem::exists(folder / "a.part.html"));
}

TEST(ReplayVerb, RefusesATimeWithoutAFrame) {
    const TemporaryFolder folder;
    const std::string recording = folder / "recording.h5";
    synthetic::write_recording(recording, 3);
    const std::string picture = folder / "a.png";
    EXPECT_THAT(refusal([&] {
                    run({"replay", recording, "-o", picture, "--at", "99"});
                }),
                HasSubstr("--at 99: there is no frame at that time; the frames go from "));
    EXPECT_FALSE(std::filesystem::exists(picture));
    check_time({.at = 9.99}, 10, 20, 0.1);
    check_time({}, 10, 20, 0.1);
    EXPECT_THROW(check_time({.at = 9.8}, 10, 20, 0.1), InputError);
}

TEST(ReplayVerb, SaysThatAMemberIsNotDoneYet) {
    const TemporaryFolder folder;
    const std::string file = folder / "a.h5";
    synthetic::publish(file);  // without member 7
    EXPECT_THAT(refusal([&] {
                    run({"replay", file, "7", "--worst", "-o", folder / "a.png"});
                }),
                HasSubstr("Member 7 is not in " + file + " yet"));
    testing::internal::CaptureStderr();
    testing::internal::CaptureStdout();
    const int status = run({"replay", file, "7", "--to", "0.1", "-o", folder / "a.png"});
    testing::internal::GetCapturedStdout();
    EXPECT_THAT(testing::internal::GetCapturedStderr(),
                AllOf(HasSubstr("member 7 is not in " + file + " yet"), Not(HasSubstr("another version"))));
    EXPECT_EQ(status, 0);
}

TEST(ReplayVerb, RefusesBeforeItComputes) {
    const TemporaryFolder folder;
    const std::string none = folder / "none.h5";
    EXPECT_THAT(refusal([&] { run({"replay", none, "0", "-o", "a.avi"}); }), HasSubstr("What is a.avi to be?"));
    EXPECT_THAT(refusal([&] { run({"replay", none, "0", "-o", "a.h5", "-o", "b.h5"}); }), HasSubstr("give one"));
    EXPECT_THAT(refusal([&] { run({"replay", none, "0", "-o", folder / "a.html"}); }), HasSubstr("there is no file"));
    EXPECT_THAT(refusal([&] { run({"replay", none, "0", "-o", "a.png", "--size", "12x"}); }), HasSubstr("is no size"));
    std::ofstream(folder / "kept.h5") << "of someone";
    EXPECT_THAT(refusal([&] {
                    run({"replay", none, "0", "-o", folder / "kept.h5"});
                }),
                HasSubstr("is there and is no recording"));
    EXPECT_THROW(run({"replay", none, "-1", "-o", "a.html"}), CommandLineEnd);
    EXPECT_THROW(run({"replay", none, "0"}), CommandLineEnd);
    EXPECT_THROW(run({"replay", none, "0", "-o", "a.png", "--view", "sideways"}), CommandLineEnd);
}

}  // namespace replay_test
}  // namespace floes
