#include "keys/csv.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace floes {
namespace csv_test {

using testing::ElementsAre;

TEST(CsvLines, AreCellsWithoutQuotes) {
    const std::vector<CsvLine> lines = csv_lines("a, \"b \"\"c\"\", d\" ,\n,\"\"\n", "x.csv");
    EXPECT_THAT(lines.at(0).cells, ElementsAre("a", "b \"c\", d", ""));
    EXPECT_THAT(lines.at(1).cells, ElementsAre("", ""));
    EXPECT_EQ(lines.at(1).number, 2);
}

TEST(CsvCell, IsANumberFromEndToEndOrNone) {
    EXPECT_EQ(number_in("1.5e3"), 1500.0);
    EXPECT_FALSE(number_in("1.5 m"));
    EXPECT_FALSE(number_in(""));
}

}  // namespace csv_test
}  // namespace floes
