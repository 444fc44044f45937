// floes --version.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "cli/commands.hpp"
#include "store/session.hpp"

namespace floes {
namespace version_test {

using testing::HasSubstr;
using testing::Not;
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
    EXPECT_STREQ(end_of({"config", "--chek", "a.toml"}).what(),
                 "floes config: there is no option --chek; did you mean --check?\n")
        << "one of several that exclude each other";
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

TEST(OutputFiles, HaveAFolderBeforeAnythingIsComputed) {
    for (const auto& words : {std::vector<std::string>{"report", "a.h5", "-o", "no/such/a.html"},
                              std::vector<std::string>{"run", "a.toml", "-o", "no/such/a.h5"},
                              std::vector<std::string>{"design", "a.h5", "-o", "no/such/a.html"},
                              std::vector<std::string>{"replay", "a.h5", "-o", "a.html", "-o", "no/such/a.png"}})
        EXPECT_THAT(end_of(words).what(), HasSubstr("cannot be written: there is no folder no/such; make the folder"));
    EXPECT_THAT(end_of({"run", "a.toml", "-o", "x.txt"}).what(), HasSubstr("ends with .h5 or .hdf5 or .nc"));
}

TEST(Usage, IsSaidInOneStyle) {
    for (const auto& [words, sentence] : std::vector<std::pair<std::vector<std::string>, std::string>>{
             {{"run"},
              "floes run needs the configuration (CONFIG.toml), or the name of an installed one, as smoke; "
              "floes run --help says more\n"},
             {{"laboratory"},
              "floes laboratory needs one of plate, cantilever behind it; floes laboratory --help says more\n"},
             {{"laboratory", "plat"},
              "floes laboratory has no plat; did you mean plate? floes laboratory --help says more\n"},
             {{"match", "a.h5"},
              "floes match needs --targets: TOML file with a [[target]] for each measured figure; "
              "floes match --help says more\n"},
             {{"config"},
              "floes config takes exactly one of --defaults, --reference, --schema, --check, --resolved; none was "
              "given; "
              "floes config --help says more\n"},
             {{"config", "--defaults", "--reference"},
              "floes config takes exactly one of --defaults, --reference, --schema, --check, --resolved; --defaults "
              "and "
              "--reference were given; floes config --help says more\n"},
             {{"run", "a.toml", "b.toml"}, "floes run has no use for b.toml; floes run --help says more\n"},
             {{"run", "a.toml", "--retry-failed"},
              "floes run: --retry-failed needs --resume; floes run --help says more\n"},
             {{"run", "a.toml", "--resume", "--overwrite"},
              "floes run: --resume and --overwrite cannot be given together; floes run --help says more\n"},
             {{"run", "a.toml", "--threads"},
              "floes run: --threads needs a value: number of members at a time on each rank; default: one for each of "
              "its cores; floes run --help says more\n"},
             {{"hybrid", "--kpr", "1,2"}, "floes hybrid: --kpr takes 3 values; floes hybrid --help says more\n"},
             {{"summarize", "a.h5", "--parts", "desing"},
              "floes summarize: --parts: there is no desing; did you mean design? floes summarize --help says more\n"},
         }) {
        const CommandLineEnd end = end_of(words);
        EXPECT_EQ(end.status(), 2);
        EXPECT_EQ(std::string(end.what()), sentence);
    }
}

TEST(Usage, SaysHowNumbersAreWritten) {
    EXPECT_THAT(end_of({"report", "a.h5", "--exposure-h", "0,5"}).what(),
                HasSubstr("--exposure-h: 0,5 is no number; write 0.5, with a point"));
    EXPECT_THAT(end_of({"replay", "a.h5", "-o", "a.png", "--at", "12,5"}).what(),
                HasSubstr("write 12.5, with a point"));
    EXPECT_THAT(end_of({"report", "a.h5", "--exposure-h", "1e9"}).what(),
                HasSubstr("1e9 is not from 0.001 to 1000000"));
    EXPECT_THAT(end_of({"report", "a.h5", "--exposure-h", "nan"}).what(), HasSubstr("nan is no number"));
    EXPECT_THAT(end_of({"report", "a.h5", "--quantile", "0,9"}).what(), HasSubstr("decimals have a point"));
    EXPECT_THAT(end_of({"run", "a.toml", "--threads", "2.5"}).what(), HasSubstr("2.5 is no whole number"));
    EXPECT_THAT(end_of({"run", "a.toml", "--threads", "08", "--time-left", "x"}).what(), Not(HasSubstr("08")))
        << "no octal";
    EXPECT_THAT(end_of({"report", "--help"}).output(), HasSubstr("in [0.001 - 1000000]"));
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
    EXPECT_THAT(end_of({"xyzzy"}).what(), HasSubstr("there is no verb xyzzy; the verbs are new, show, run, "));
    EXPECT_THAT(end_of({"calibrate"}).what(), HasSubstr("floes laboratory plate")) << "a former verb";
}

}  // namespace version_test
}  // namespace floes
