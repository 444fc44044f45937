// Sentences broken into lines.

#include "tables/table.hpp"

#include <gtest/gtest.h>

#include "tables/section.hpp"

namespace floes {
namespace prose_test {

TEST(Prose, IsBrokenAtSpaces) {
    EXPECT_EQ(wrapped("one two three four", 9), "one two\nthree\nfour");
    EXPECT_EQ(wrapped("one two\n\nthree\n", 20), "one two\n\nthree\n");
    EXPECT_EQ(wrapped("", 20), "");
}

TEST(Prose, CountsLettersNotBytes) {
    EXPECT_EQ(wrapped("Σ Σ Σ Σ", 7), "Σ Σ Σ Σ");
    EXPECT_EQ(wrapped("Σ Σ Σ Σ", 6), "Σ Σ Σ\nΣ");
}

TEST(Prose, LeavesCommandsAndLongWordsWhole) {
    EXPECT_EQ(wrapped("Next:\n  floes report smoke.h5\n", 8), "Next:\n  floes report smoke.h5\n");
    EXPECT_EQ(wrapped("  floes report a.h5  one page\n", 30), "  floes report a.h5  one page\n");
    EXPECT_EQ(wrapped("  floes report a.h5  one page\n", 20), "  floes report a.h5\n    one page\n");
    EXPECT_EQ(wrapped("a /very/long/path b", 5), "a\n/very/long/path\nb");
}

TEST(Prose, OfASectionFollowsTheWidth) {
    Results results{.columns = {{"", "a"}}};
    results.add({"b"});
    const Section told{.before = "A sentence of some length.\n", .results = {results}, .notes = {"Another such one."}};
    EXPECT_EQ(text(std::vector{told}, 12).substr(0, 27), "A sentence\nof some\nlength.\n");
    EXPECT_NE(text(std::vector{told}, 12).find("Another such\none.\n"), std::string::npos);
}

}  // namespace prose_test
}  // namespace floes
