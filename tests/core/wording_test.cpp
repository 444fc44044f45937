#include "core/text.hpp"

#include <gtest/gtest.h>

namespace floes {
namespace wording_test {

TEST(Counted, OneHasNoPlural) {
    EXPECT_EQ(counted(1, "member"), "1 member");
    EXPECT_EQ(counted(0, "member"), "0 members");
    EXPECT_EQ(counted(1'000'002, "member"), "1000002 members");
}

TEST(DurationText, FitsTheSize) {
    EXPECT_EQ(duration_text(12.3), "12 s");
    EXPECT_EQ(duration_text(99.6), "2 min");
    EXPECT_EQ(duration_text(600), "10 min");
    EXPECT_EQ(duration_text(3 * 3600 + 5 * 60), "3 h 05 min");
    EXPECT_EQ(duration_text(52 * 3600), "2 d 4 h");
}

TEST(DurationInFigures, HasThreeOfOneUnit) {
    EXPECT_EQ(duration_in_figures(0.0025), "2.5 ms");
    EXPECT_EQ(duration_in_figures(31.26), "31.3 s");
    EXPECT_EQ(duration_in_figures(4074), "67.9 min");
    EXPECT_EQ(duration_in_figures(17.2 * 3600), "17.2 h");
    EXPECT_EQ(duration_in_figures(183 * 86400), "183 d");
}

TEST(ShellWord, IsOneWordWhateverIsInIt) {
    EXPECT_EQ(shell_word("runs/a-1.h5"), "runs/a-1.h5");
    EXPECT_EQ(shell_word("my file.h5"), "'my file.h5'");
    EXPECT_EQ(shell_word("it's $HOME"), "'it'\\''s $HOME'");
    EXPECT_EQ(shell_word(""), "''");
}

TEST(HasEnding, IsOfAnyCase) {
    EXPECT_TRUE(has_ending("states.csv", ".csv"));
    EXPECT_TRUE(has_ending("STATES.CSV", ".csv"));
    EXPECT_FALSE(has_ending("states.csv.toml", ".csv"));
    EXPECT_FALSE(has_ending("csv", ".csv"));
}

TEST(InAFileName, IsOnePartOfAPathAndNotTooLong) {
    EXPECT_EQ(in_a_file_name("a/b\nc"), "a_b_c");
    std::string name;
    for (int k = 0; k < 100; ++k) name += "氷";
    EXPECT_EQ(in_a_file_name(name), name.substr(0, 198));  // whole letters of three bytes
}

TEST(InOneLine, HasNoControlCharacters) {
    EXPECT_EQ(in_one_line("a\nb\r\tc 氷"), "a b  c 氷");
}

}  // namespace wording_test
}  // namespace floes
