#include "keys/csv.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "support/refusal.hpp"

namespace floes {
namespace csv_test {

using testing::ElementsAre;

TEST(CsvLines, AreCellsWithoutQuotes) {
    const std::vector<CsvLine> lines = csv_lines("a, \"b \"\"c\"\", d\" ,c\n,\"\",\n,\"\",1\n", "x.csv");
    EXPECT_THAT(lines.at(0).cells, ElementsAre("a", "b \"c\", d", "c"));
    EXPECT_THAT(lines.at(1).cells, ElementsAre("", "", "1"));
    EXPECT_EQ(lines.at(1).number, 3);
}

// As editors, spreadsheets and pipes leave them: the same cells.
TEST(CsvLines, AreTheSameHoweverTheyAreWritten) {
    for (const char* text :
         {"a,b\n1,2.5\n", "a,b\r\n1,2.5\r\n", "a,b\r1,2.5", "\r\r\na,b\r\r1,2.5\r", "a\tb\n1\t2.5\n", "a;b\n1;2,5\n",
          "\"a\";\"b\"\n1;\"2,5\"\n", "sep=,\na,b\n1,2.5\n", "sep=;\r\na;b\r\n1;2,5\r\n", "sep=\t\na\tb\n1\t2.5\n",
          "sep=|\na|b\n1|2.5\n", "a,b,,\n1,2.5,,\n,,,\n", "a,b\n1,2.5,\n,\n",
          "\xEF\xBB\xBF\"a\", \"b\"\n 1 , 2.5\t\n \n"}) {
        const std::vector<CsvLine> lines = csv_lines(text, "x.csv");
        ASSERT_EQ(lines.size(), 2u) << text;
        EXPECT_THAT(lines[0].cells, ElementsAre("a", "b")) << text;
        EXPECT_THAT(lines[1].cells, ElementsAre("1", "2.5")) << text;
    }
    EXPECT_EQ(csv_lines("\r\n\ra\r\n1\r2", "x.csv").at(2).number, 5);
    EXPECT_THAT(csv_lines("a\tb\n\t2\n", "x.csv").at(1).cells, ElementsAre("", "2")) << "an empty first cell stays";
}

TEST(CsvLines, AreRefusedWhereNobodyKnowsWhatTheyMean) {
    const auto said = [](std::string_view text) { return refusal([&] { csv_lines(text, "x.csv"); }); };
    EXPECT_EQ(said("\n,h\n0,0.02\n1,0.03\n"),
              "x.csv:2: column 1 has no name; name it, or leave it out, as pandas does with index=False");
    EXPECT_EQ(said(std::string_view("\xFF\xFEh\0\n\0", 6)), "x.csv: this is text in UTF-16; save it in UTF-8");
    EXPECT_EQ(said(std::string_view("h\0\n\0", 4)), "x.csv: this is text in UTF-16; save it in UTF-8");
    EXPECT_EQ(said("d\xFCnn\n"), "x.csv: this is no text in UTF-8; save it as such");
    EXPECT_EQ(said("a\tb\n1\t1,234\n"), "x.csv:2: 1,234 has a comma; write 1.234, with a point");
}

// As spreadsheets write it where the comma is the decimal sign.
TEST(CsvLines, MayHaveSemicolonsAndDecimalCommas) {
    const std::vector<CsvLine> lines = csv_lines("\xEF\xBB\xBF\r\nfloe;x;y\r\n\"A, 1\";0,5;-1,25e-1\r\n", "x.csv");
    EXPECT_THAT(lines.at(0).cells, ElementsAre("floe", "x", "y"));
    EXPECT_THAT(lines.at(1).cells, ElementsAre("A, 1", "0.5", "-1.25e-1"));
    EXPECT_THAT(csv_lines("a,b;c\n1,2\n", "x.csv").at(0).cells, ElementsAre("a", "b;c"));
}

TEST(CsvLines, HaveEachColumnOnce) {
    EXPECT_EQ(refusal([] { csv_lines("\nspeed,hours, hours\n1,2,3\n", "x.csv"); }),
              "x.csv:2: the column hours is there twice; leave one of the two out");
    EXPECT_EQ(csv_lines("0,0,0\n,,1\n", "x.csv").size(), 2u) << "numbers are no header";
}

TEST(CsvCell, IsANumberFromEndToEndOrNone) {
    EXPECT_EQ(number_in("1.5e3"), 1500.0);
    for (const char* ten : {"10", "10.", "+10", "1e1", "+1.0E+01"}) EXPECT_EQ(number_in(ten), 10.0) << ten;
    for (const char* none : {"1.5 m", "+-1", "++1", "+", "nan", "inf", "1e999", "0x10", "1,5"})
        EXPECT_FALSE(number_in(none)) << none;
    EXPECT_FALSE(number_in(""));
}

}  // namespace csv_test
}  // namespace floes
