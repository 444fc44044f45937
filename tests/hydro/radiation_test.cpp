// Files of radiation programs: units, halves, limits, and what is wrong in them.

#include "hydro/radiation.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>
#include <string>

#include <fmt/format.h>

#include "core/error.hpp"

namespace floes {
namespace radiation_test {

constexpr double pi = std::numbers::pi;
constexpr double deep = std::numeric_limits<double>::infinity();

std::string message(const std::string& text) {
    try {
        read_radiation(text, "hull.1", {});
    } catch (const InputError& error) {
        return error.what();
    }
    return "read";
}

bool remarks_on(const std::string& text, const std::string& words) {
    for (const std::string& remark : read_radiation(text, "hull.1", {}).remarks)
        if (remark.find(words) != std::string::npos) return true;
    return false;
}

// A = A' ρ L^k, B = B' ρ L^k ω; rows of four columns are limits: below 0 that of zero frequency.
TEST(Radiation, OfWamitIsInTheUnitsOfDensityAndLength) {
    const std::string text =
        " WAMIT Numeric Output -- Filename  hull.1\n"
        " -1.0E+00  1 1 2.0\n"
        "  0.0E+00  1 1 1.0\n"
        "  1.0D+01  1 1 1.5 0.25\n"
        "  1.0D+01  1 5 -3.0 0.5\n"
        "  1.0D+01  5 5 7.0 0.75\r\n"
        "  5.0E+00  1 1 1.2 0.5\n";
    const RadiationFile found = read_radiation(text, "hull.1", {.density = 1000, .length = 2});
    ASSERT_EQ(found.points.size(), 2);
    const RadiationPoint& slow = found.points[0];
    EXPECT_NEAR(slow.frequency, 2 * pi / 10, 1e-12);
    EXPECT_NEAR(slow.added(0, 0), 1.5 * 1000 * 8, 1e-9);
    EXPECT_NEAR(slow.added(4, 4), 7.0 * 1000 * 32, 1e-9);
    EXPECT_NEAR(slow.added(4, 0), -3.0 * 1000 * 16, 1e-9) << "mirrored";
    EXPECT_NEAR(slow.damping(0, 0), 0.25 * 1000 * 8 * 2 * pi / 10, 1e-9);
    EXPECT_EQ(slow.added(1, 1), 0);
    ASSERT_TRUE(found.at_zero && found.at_infinity);
    EXPECT_EQ((*found.at_zero)(0, 0), 16000);
    EXPECT_EQ(found.remarks.size(), 1) << "of the half that was mirrored";

    const RadiationPoint between = radiation_at(found, 1.5 * 2 * pi / 10);
    EXPECT_NEAR(between.added(0, 0), 1.35 * 8000, 1e-9);
    EXPECT_THROW(radiation_at(found, 2 * pi / 11), InputError);
    EXPECT_EQ(radiation_at(found, 2 * pi / 10).added(0, 0), 12000);
}

TEST(Radiation, SaysWhatAFileLacksOrHasWrong) {
    const std::string rows = "10 1 1 1.5 0.25\n10 3 3 1 -0.1\n5 1 1 1.2 0.5\n5 3 3 1 0.2\n";
    EXPECT_TRUE(remarks_on(rows, "neither the limit of zero nor"));
    EXPECT_TRUE(remarks_on("0 1 1 1.0\n" + rows, "no limit of zero frequency"));
    EXPECT_FALSE(remarks_on("-1 1 1 1.6\n0 1 1 1.0\n" + rows, "exchanged"));
    EXPECT_TRUE(remarks_on("-1 1 1 1.0\n0 1 1 1.6\n" + rows, "exchanged"));
    EXPECT_TRUE(remarks_on(rows, "damping in heave is negative at 1 of 2"));
    EXPECT_EQ(read_radiation(rows, "hull.1", {}).points[0].damping(2, 2), 0);

    const std::string form = "; a row of WAMIT's .1 is period, i, j, added mass and, but for the limits, damping";
    EXPECT_EQ(message("10 1 1 1.5 NaN\n"),
              "hull.1:1: has a number that is not finite, as at very low frequencies" + form);
    EXPECT_EQ(message("10 1 1 1.5\n"), "hull.1:1: has 4 numbers" + form);
    EXPECT_EQ(message("title\n10 1 1 1.5 x\n"), "hull.1:2: has a word that is no number" + form);
    EXPECT_EQ(message("10 7 1 1.5 1\n"), "hull.1:1: is of a second body, and one body of six motions is read" + form);
    EXPECT_EQ(
        message("title\n"),
        "hull.1: has no periods; it is to be WAMIT's .1, NEMOH's RadiationCoefficients.tec or Capytaine's NetCDF");
}

TEST(Radiation, OfNemohHasAZoneForEachMotion) {
    std::string text = "VARIABLES=\"w (rad/s)\"\n\"A   1   1\" \"B   1   1\"\n";
    std::string five;
    for (int move = 0; move < 6; ++move) {
        text += fmt::format("Zone t=\"Motion of body    1 in DoF   {}\",I=  1,F=POINT\n  0.5", move + 1);
        for (int force = 0; force < 6; ++force) text += fmt::format(" {} {}", 10 * force + move, force == move ? 1 : 0);
        text += "\n";
        if (move == 4) five = text;
    }
    const RadiationFile found = read_radiation(text, "r.tec", {});
    ASSERT_EQ(found.points.size(), 1);
    EXPECT_EQ(found.points[0].frequency, 0.5);
    EXPECT_EQ(found.points[0].added(4, 0), 40) << "force in pitch by a motion in surge";
    EXPECT_EQ(found.points[0].damping(3, 3), 1);
    EXPECT_EQ(message(five), "hull.1: has 5 of the six zones, one for each motion; was the file cut off?");
}

// A sphere has no added moment about its centre, whatever moves; about a point 2 m below it A15 = 2 A11 (Capytaine's
// sphere of 5 m, WEC-Sim: 147.911, 295.739, 591.309 t, t m, t m² about 2 m below its centre).
TEST(Radiation, AboutAnotherPointIsOfTheSameBody) {
    Mat6 below = Mat6::Zero();
    below(0, 0) = below(1, 1) = 147.911;
    below(2, 2) = 112.223;
    below(0, 4) = below(4, 0) = 295.739;
    below(1, 3) = below(3, 1) = -295.739;
    below(3, 3) = below(4, 4) = 591.309;
    const Mat6 about = about_origin(below, {0, 0, -2});
    EXPECT_NEAR(about(0, 4), 0, 0.1);
    EXPECT_NEAR(about(4, 4), 0, 0.01);
    EXPECT_NEAR(about(1, 3), 0, 0.1);
    EXPECT_EQ(about(2, 2), 112.223);
    EXPECT_NEAR((about_origin(about, {0, 0, 2}) - below).norm(), 0, 1e-9) << "and back";
    // A point of heave added mass 3 m ahead of the reference: bow up is a negative pitch in these axes.
    Mat6 heave = Mat6::Zero();
    heave(2, 2) = 10;
    const Mat6 ahead = about_origin(heave, {3, 0, 0});
    EXPECT_NEAR(ahead(2, 4), -30, 1e-12);
    EXPECT_NEAR(ahead(4, 4), 90, 1e-12);
}

TEST(Radiation, HasEachMotionAtAFrequencyOfItsOwn) {
    RadiationFile file;
    for (const double frequency : {1.0, 2.0, 4.0}) {
        RadiationPoint& point = file.points.emplace_back();
        point.frequency = frequency;
        point.added.setConstant(10 * frequency);
        point.damping.setConstant(frequency);
    }
    const RadiationPoint at = radiation_at(file, std::array<double, 6>{1, 0.1, 3, 4, 9, 2});
    EXPECT_EQ(at.added(0, 0), 10);
    EXPECT_EQ(at.added(2, 2), 30);
    EXPECT_EQ(at.damping(0, 2), 2) << "at the mean of 1 and 3";
    EXPECT_EQ(at.added(1, 1), 10) << "the file's longest period";
    EXPECT_EQ(at.added(4, 4), 40) << "its shortest";
}

// Of a cylinder of 0.35 m in 3 m of water (WAMIT's example, WEC-Sim): B33/ρω 0.0122734 at 157 s, waterplane 0.3848 m².
TEST(Radiation, LongWavesKnowTheWaterplane) {
    const double frequency = 0.04;
    RadiationFile found;
    RadiationPoint point{.frequency = frequency};
    point.damping(2, 2) = 0.0122734 * 1000 * frequency;
    found.points.push_back(point);
    EXPECT_NEAR(*waterplane_by_waves(found, 1000, 9.81, 3), pi * 0.35 * 0.35, 0.002);
    EXPECT_GT(*waterplane_by_waves(found, 1000, 9.81, deep), 10) << "of deep water it would be another";
    // Deep: kS²/2.
    point.damping(2, 2) = 1000 * frequency * frequency * frequency / 9.81 * 25 / 2;
    found.points[0] = point;
    EXPECT_NEAR(*waterplane_by_waves(found, 1000, 9.81, deep), 5, 1e-9);
    point.damping(2, 2) = 0;
    found.points[0] = point;
    EXPECT_FALSE(waterplane_by_waves(found, 1000, 9.81, deep));
}

}  // namespace radiation_test
}  // namespace floes
