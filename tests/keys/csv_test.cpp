#include "keys/csv.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/error.hpp"

namespace floes {
namespace csv_test {

using testing::ElementsAre;

TEST(CsvLines, AreCellsWithoutQuotes) {
    const std::vector<CsvLine> lines = csv_lines("a, \"b \"\"c\"\", d\" ,\n,\"\"\n", "x.csv");
    EXPECT_THAT(lines.at(0).cells, ElementsAre("a", "b \"c\", d", ""));
    EXPECT_THAT(lines.at(1).cells, ElementsAre("", ""));
    EXPECT_EQ(lines.at(1).number, 2);
}

// As spreadsheets write it where the comma is the decimal sign.
TEST(CsvLines, MayHaveSemicolonsAndDecimalCommas) {
    const std::vector<CsvLine> lines = csv_lines("\xEF\xBB\xBF\r\nfloe;x;y\r\n\"A, 1\";0,5;-1,25e-1\r\n", "x.csv");
    EXPECT_THAT(lines.at(0).cells, ElementsAre("floe", "x", "y"));
    EXPECT_THAT(lines.at(1).cells, ElementsAre("A, 1", "0.5", "-1.25e-1"));
    EXPECT_THAT(csv_lines("a,b;c\n1,2\n", "x.csv").at(0).cells, ElementsAre("a", "b;c"));
}

TEST(CsvLines, HaveEachColumnOnce) {
    try {
        csv_lines("\nspeed,hours, hours\n1,2,3\n", "x.csv");
        FAIL() << "one of the two would be lost";
    } catch (const InputError& error) {
        EXPECT_STREQ(error.what(), "x.csv:2: the column hours is there twice; leave one of the two out");
    }
    EXPECT_EQ(csv_lines("0,0,0\n,,\n", "x.csv").size(), 2u) << "numbers are no header";
}

TEST(CsvCell, IsANumberFromEndToEndOrNone) {
    EXPECT_EQ(number_in("1.5e3"), 1500.0);
    EXPECT_FALSE(number_in("1.5 m"));
    EXPECT_FALSE(number_in(""));
}

}  // namespace csv_test
}  // namespace floes
