// The water's stiffness by other programs: units, and what is wrong.

#include "hydro/hydrostatic_file.hpp"

#include <gtest/gtest.h>

#include <string>

#include "support/refusal.hpp"

namespace floes {
namespace hydrostatic_file_test {

std::string message(const std::string& text) {
    return refusal_or("read", [&] { read_hydrostatics(text, "hull.hst", {}, 9.81); });
}

// C = C' ρ g L^k with k 2, 3, 4. The cylinder of WAMIT's example (WEC-Sim), R 0.35 m: 0.38375 m² by its panels.
TEST(HydrostaticFile, OfWamitIsInTheUnitsOfDensityGravityAndLength) {
    const Mat6 found = read_hydrostatics(
        " WAMIT -- Force Output File -- cyl.hst\n 3 3 3.8375D-01\n 3 5 0.5\n\n 4 4 -6.449E-02\n 5 5 1\n", "cyl.hst",
        {.density = 1000, .length = 2}, 9.81);
    EXPECT_NEAR(found(2, 2), 0.38375 * 1000 * 9.81 * 4, 1e-9);
    EXPECT_NEAR(found(2, 4), 0.5 * 1000 * 9.81 * 8, 1e-9);
    EXPECT_NEAR(found(3, 3), -0.06449 * 1000 * 9.81 * 16, 1e-9);
    EXPECT_EQ(found(4, 2), 0) << "an unsymmetric one stays one";
}

TEST(HydrostaticFile, OfNemohIsInSI) {
    std::string rows;
    for (int i = 0; i < 6; ++i) rows += i == 2 ? "0 0 1333210. 0 0 0\n" : "0 0 0 0 0 0\n";
    EXPECT_EQ(read_hydrostatics(rows, "KH.dat", {.density = 1025, .length = 7}, 9.81)(2, 2), 1333210);
    EXPECT_TRUE(is_hydrostatic(rows));
    EXPECT_TRUE(is_hydrostatic(" a title\n 3 3 0.4\n"));
    EXPECT_FALSE(is_hydrostatic("10 1 1 1.5 0.25\n"));
    EXPECT_FALSE(is_hydrostatic(" -1 1 1 1.5\n"));
    EXPECT_FALSE(is_hydrostatic(""));
}

TEST(HydrostaticFile, SaysWhatIsWrong) {
    const std::string form = "; a row of WAMIT's .hst is i, j and the stiffness, one of NEMOH's KH.dat six of them";
    EXPECT_EQ(message("3 3 NaN\n"), "hull.hst:1: has a number that is not finite" + form);
    EXPECT_EQ(message("title\n3 3 x\n"), "hull.hst:2: has a word that is no number" + form);
    EXPECT_EQ(message("3 3 1\n9 9 1\n"), "hull.hst:2: is of a second body, and one body of six motions is read" + form);
    EXPECT_EQ(message("3 3.5 1\n"),
              "hull.hst:1: has something other than numbers of motions in its first two columns" + form);
    EXPECT_EQ(message("3 3 1\n3 3\n"), "hull.hst:2: has 2 numbers" + form);
    EXPECT_EQ(message("0 0 5 0 0 0\n"), "hull.hst: has 1 of six rows; was the file cut off?");
    EXPECT_EQ(message("3 3 0\n4 4 1\n5 5 1\n"),
              "hull.hst: has no stiffness in heave, which every hull in the waterline has; did the program write it?");
    EXPECT_EQ(message("0 0 5 0 0 0\n3 3 1\n"), "hull.hst:2: has 3 numbers" + form);
}

TEST(HydrostaticFile, IsCompleteOrRefused) {
    const std::string form = "; a row of WAMIT's .hst is i, j and the stiffness, one of NEMOH's KH.dat six of them";
    EXPECT_EQ(message(" 3 3 100.0\n 3 3 200.0\n 4 4 1\n5 5 1\n"),
              "hull.hst:2: gives the element 3 3 another value than line 1" + form);
    EXPECT_EQ(message("3 3 100.0\n3 3 1.0D+02\n4 4 1\n5 5 1\n"), "read");
    EXPECT_EQ(message("3 3 1\n5 5 1\n"),
              "hull.hst: has no row 4 4, and heave, roll and pitch have one each; was one lost?");
    std::string all;
    for (int i = 1; i <= 6; ++i)
        for (int j = 1; j <= 6; ++j)
            all += i == 6 && j == 1 ? "" : std::to_string(i) + " " + std::to_string(j) + " 1\n";
    EXPECT_EQ(message(all), "hull.hst: has 35 of the 36 elements of a matrix; was a row lost?");
    EXPECT_EQ(message(all + "6 1 1\n"), "read");
    std::string seven;
    for (int i = 0; i < 7; ++i) seven += "1 1 1 1 1 1\n";
    EXPECT_EQ(message(seven), "hull.hst:7: is a seventh row" + form);
}

}  // namespace hydrostatic_file_test
}  // namespace floes
