// floes --version.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "cli/commands.hpp"
#include "store/session.hpp"

namespace floes {
namespace version_test {

using testing::HasSubstr;
using testing::StartsWith;

TEST(Version, NamesProgramRevisionLibrariesAndLanes) {
    const std::string text = version_text();
    EXPECT_THAT(text, StartsWith("floes " + floes_version() + "\n"));
    EXPECT_THAT(text, HasSubstr("\ngit_revision: " + git_revision() + "\n"));
    for (const char* library : {"\nbullet: ", "\nhdf5: ", "\nmpi: ", "\nlane_widths: 1"})
        EXPECT_THAT(text, HasSubstr(library));
}

/// How a command line ends that is no order to do something.
CommandLineEnd end_of(const std::vector<std::string>& words) {
    CommandLine line;
    add_verbs(line, {});
    try {
        line.run(words);
    } catch (const CommandLineEnd& end) {
        return end;
    }
    ADD_FAILURE() << "went on";
    return {-1, "", ""};
}

TEST(Version, IsAskedForWithOrWithoutAVerbAndEndsWell) {
    for (const char* word : {"--version", "version"}) {
        const CommandLineEnd asked = end_of({word});
        EXPECT_EQ(asked.status(), 0);
        EXPECT_EQ(asked.output(), version_text() + "\n");
    }
}

TEST(UnknownOptions, AreAnsweredWithTheNearest) {
    EXPECT_STREQ(end_of({"run", "a.toml", "--thread", "2"}).what(),
                 "floes run: there is no option --thread; did you mean --threads?\n");
    EXPECT_STREQ(end_of({"run", "a.toml", "--thread=2"}).what(),
                 "floes run: there is no option --thread; did you mean --threads?\n");
    EXPECT_STREQ(end_of({"--hlep"}).what(), "floes: there is no option --hlep; did you mean --help?\n");
    EXPECT_EQ(end_of({"--hlep"}).status(), 2);
    EXPECT_THAT(end_of({"report", "a.h5", "--zzzzzzzzz"}).what(),
                HasSubstr("the options are --help, -h, --output, -o"));
}

// What an ending promises is written, or refused before anything is read.
TEST(OutputFiles, AreWhatTheirNamesSay) {
    for (const auto& words : {std::vector<std::string>{"report", "a.h5", "-o", "a.docx"},
                              std::vector<std::string>{"status", "a.h5", "--html", "a.txt"},
                              std::vector<std::string>{"summarize", "a.h5", "-o", "a.docx"}}) {
        const CommandLineEnd end = end_of(words);
        EXPECT_EQ(end.status(), 2);
        EXPECT_THAT(end.what(), HasSubstr("would not be what its name says; give it a name that ends with "));
    }
}

TEST(Help, IsThatOfTheVerb) {
    const CommandLineEnd asked = end_of({"help", "summarize"});
    EXPECT_EQ(asked.status(), 0);
    EXPECT_EQ(asked.output(), end_of({"summarize", "--help"}).output());
    EXPECT_EQ(end_of({"help"}).output(), end_of({"--help"}).output());
    EXPECT_THAT(end_of({"help", "laboratory", "plate"}).output(), HasSubstr(" laboratory plate [OPTIONS] [config]"));
}

TEST(Help, NamesTheVerbThatWasMeant) {
    for (const std::vector<std::string>& words :
         {std::vector<std::string>{"sumarize", "my.h5"}, {"help", "sumarize"}}) {
        const CommandLineEnd refused = end_of(words);
        EXPECT_EQ(refused.status(), 2);
        EXPECT_EQ(std::string(refused.what()), "floes: there is no verb sumarize; did you mean summarize?\n");
    }
    EXPECT_THAT(end_of({"xyzzy"}).what(), HasSubstr("there is no verb xyzzy; the verbs are new, run, "));
    EXPECT_THAT(end_of({"calibrate"}).what(), HasSubstr("floes laboratory plate")) << "a former verb";
}

}  // namespace version_test
}  // namespace floes
