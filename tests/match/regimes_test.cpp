// Regimes of a year as text: TOML and scatter diagrams, and what is refused.

#include "match/regimes.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "support/refusal.hpp"

namespace floes {
namespace regimes_test {

using testing::ElementsAre;
using testing::HasSubstr;

std::vector<Regime> toml(const std::string& text) {
    return read_regimes(text, "year.toml");
}

std::vector<Regime> table(const std::string& text) {
    return read_regime_table(text, "year.csv");
}

TEST(Regimes, AreCasesOrPlacesInADesign) {
    const std::vector<Regime> read = toml(
        "[[regime]]\nname = \"thin\"\nhours_per_year = 300\ncase = \"E60\"\n"
        "[[regime]]\nhours_per_year = 10.5\nice.thickness_m = 0.5\nstructure.speed_m_s = 1\n");
    ASSERT_EQ(read.size(), 2u);
    EXPECT_EQ(read[0].name, "thin");
    EXPECT_EQ(read[0].time, 300 * 3600);
    EXPECT_EQ(read[0].case_name, "E60");
    EXPECT_TRUE(read[0].values.empty());
    EXPECT_EQ(read[1].name, "thickness 0.5 m, speed 1 m/s");
    EXPECT_EQ(read[1].values.at(0).path, "ice.thickness_m");
    EXPECT_EQ(read[1].values.at(1).value, Value{std::int64_t{1}});
}

TEST(Regimes, OfAScatterDiagramAreThoseOfToml) {
    const std::vector<Regime> read = table(
        "\xEF\xBB\xBFregime,hours_per_year,ice.thickness_m,case\r\n"
        "\"thin, slow\", 300 ,0.5,\r\n\n,0,0.7,\r\n,20,,E60\r\n");
    ASSERT_EQ(read.size(), 2u);  // the one without hours is none
    EXPECT_EQ(read[0].name, "thin, slow");
    EXPECT_EQ(read[0].time, 300 * 3600);
    EXPECT_EQ(read[0].values.at(0).value, Value{0.5});
    EXPECT_EQ(read[1].name, "E60");
    EXPECT_EQ(read[1].where, "year.csv:5");
}

TEST(Regimes, RefuseWhatMakesNoYear) {
    const std::string one = "[[regime]]\nname = \"a\"\nhours_per_year = 5000\ncase = \"E60\"\n";
    EXPECT_THAT(refusal([&] { toml(one + "[[regime]]\nhours_per_year = 4000\ncase = \"E30\"\n"); }),
                HasSubstr("year.toml: the regimes have 9000 h together, and a year has 8766"));
    EXPECT_THAT(refusal([&] { toml(one + "[[regime]]\nname = \"a\"\nhours_per_year = 1\ncase = \"E30\"\n"); }),
                HasSubstr("year.toml:5: a is a regime already, at year.toml:1"));
    EXPECT_THAT(refusal([&] { toml(one + "[[regime]]\nname = \"b\"\nhours_per_year = 1\ncase = \"E60\"\n"); }),
                HasSubstr("year.toml:5: the regime b is the ice of another one, at year.toml:1"));
    EXPECT_THAT(refusal([&] {
                    toml(
                        "[[regime]]\nhours_per_year = 1\nice.thickness_m = 1\nstructure.speed_m_s = 0.5\n"
                        "[[regime]]\nhours_per_year = 2\nstructure.speed_m_s = 0.5\nice.thickness_m = 1.0\n");
                }),
                HasSubstr("is the ice of another one, at year.toml:1"));
    EXPECT_EQ(refusal([&] { toml("[[regime]]\nhours_per_year = 1\n\"ice.thickness_m\" = 1\nice.thickness_m = 2\n"); }),
              "year.toml:4: ice.thickness_m is given twice, first at year.toml:3; keep one");
    EXPECT_THAT(refusal([&] { toml("[[regime]]\ncase = \"E60\"\n"); }), HasSubstr("has no hours_per_year"));
    EXPECT_THAT(refusal([&] { toml("[[regime]]\nhours_per_year = 3\n"); }), HasSubstr("says nothing of its ice"));
    EXPECT_THAT(refusal([&] { toml("[[regime]]\nhours_per_yaer = 3\n"); }), HasSubstr("hours_per_year"));
    EXPECT_THAT(refusal([&] { toml("[[regime]]\nhours_per_year = 9000\ncase = \"E60\"\n"); }), HasSubstr("8784"));
    EXPECT_THAT(refusal([&] { toml("[[regime]]\nhours_per_year = 3\nice.thickness_m = \"thin\"\n"); }),
                HasSubstr("ice.thickness_m = \"thin\" is no number"));
    EXPECT_THAT(refusal([&] { toml("[[regimes]]\nhours_per_year = 3\n"); }), HasSubstr("did you mean [[regime]]?"));
    EXPECT_THAT(refusal([&] { toml("[regime]\nhours_per_year = 3\n"); }), HasSubstr("in double brackets"));
    EXPECT_THAT(refusal([&] { toml(""); }), HasSubstr("no regime has any hours"));
}

TEST(Regimes, MayFillAYearUpToALeapYear) {
    const auto classes = [](int count, const char* hours) {
        std::string text = "ice.thickness_m,hours_per_year\n";
        for (int k = 0; k < count; ++k) text += "0." + std::to_string(10 + k) + "," + hours + "\n";
        return text;
    };
    double sum = 0;
    for (int k = 0; k < 15; ++k) sum += 585.6;
    EXPECT_GT(sum, 8784);  // by rounding
    EXPECT_EQ(table(classes(15, "585.6")).size(), 15u);
    EXPECT_EQ(toml("[[regime]]\nhours_per_year = 8784\ncase = \"E60\"\n").front().time, 8784 * 3600.0);
    EXPECT_THAT(refusal([&] { table(classes(6, "1464.01")); }),
                HasSubstr("the regimes have 8784.06 h together, and a year has 8766, a leap year 8784"));
    EXPECT_THAT(refusal([&] { toml("[[regime]]\nhours_per_year = 8785\ncase = \"E60\"\n"); }), HasSubstr("8784"));
}

TEST(Regimes, RefuseTablesThatAreNone) {
    EXPECT_THAT(refusal([&] { table(""); }), HasSubstr("year.csv: the table is empty"));
    EXPECT_EQ(refusal([&] { table("regime,hours_per_year,case,name\nthin,3,E60,thick\n"); }),
              "year.csv:1: the columns regime and name are both the regime's name; keep one");
    EXPECT_THAT(refusal([&] { table("case,hours_per_year\nE60,3,4\n"); }),
                HasSubstr("year.csv:2: the line has 3 cells, and the header has 2 columns"));
    EXPECT_THAT(refusal([&] { table("case,hours\nE60,3\n"); }), HasSubstr("did you mean hours_per_year"));
    EXPECT_THAT(refusal([&] { table("case,hours_per_year\n\"E60,3\n"); }), HasSubstr("close it with \""));
    for (const char* hours : {"3 h", "+-3", "3,5", "1e"})
        EXPECT_THAT(refusal([&] { table(std::string("case;hours_per_year\nE60;") + hours + "d\n"); }),
                    HasSubstr("year.csv:2: hours_per_year = \""))
            << hours;
}

}  // namespace regimes_test
}  // namespace floes
