// Files of radiation programs: units, halves, limits, and what is wrong in them.

#include "hydro/radiation.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <sstream>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "core/error.hpp"
#include "support/file_bytes.hpp"
#include "support/refusal.hpp"

namespace floes {
namespace radiation_test {

constexpr double pi = std::numbers::pi;
constexpr double deep = std::numeric_limits<double>::infinity();

std::string message(const std::string& text) {
    return refusal_or("read", [&] { read_radiation(text, "hull.1", {}); });
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
        " -1.0E+00  1 1 2.0\n -1.0E+00  1 5 -3.1\n -1.0E+00  5 5 7.1\n"
        "  0.0E+00  1 1 1.0\n  0.0E+00  1 5 -2.1\n  0.0E+00  5 5 6.1\n"
        "  1.0D+01  1 1 1.5 0.25\n"
        "  1.0D+01  1 5 -3.0 0.5\n"
        "  1.0D+01  5 5 7.0 0.75\r\n"
        "  5.0E+00  1 1 1.2 0.5\n  5.0E+00  1 5 -3.0 0.5\n  5.0E+00  5 5 7.0 0.75\n";
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
    EXPECT_EQ(extent_of(found),
              "2 periods from 5 to 10 s; 4 of 36 elements, 1 of them by symmetry from the other half, the others 0 by "
              "symmetry; the limits of zero and infinite frequency");
    EXPECT_EQ(found.remarks.size(), 0);

    const RadiationPoint between = radiation_at(found, 1.5 * 2 * pi / 10);
    EXPECT_NEAR(between.added(0, 0), 1.35 * 8000, 1e-9);
    EXPECT_THROW(radiation_at(found, 2 * pi / 11), InputError);
    EXPECT_EQ(radiation_at(found, 2 * pi / 10).added(0, 0), 12000);
}

TEST(Radiation, SaysWhatAFileLacksOrHasWrong) {
    const std::string rows = "10 1 1 1.5 0.25\n10 3 3 1 -0.1\n5 1 1 1.2 0.5\n5 3 3 1 0.2\n";
    EXPECT_EQ(
        extent_of(read_radiation(rows, "hull.1", {})),
        "2 periods from 5 to 10 s; 2 of 36 elements, the others 0 by symmetry; neither the limit of zero nor that of "
        "infinite frequency");
    const std::string heave = "-1 3 3 1\n0 3 3 1\n";
    EXPECT_FALSE(remarks_on(heave + "-1 1 1 1.6\n0 1 1 1.0\n" + rows, "exchanged"));
    EXPECT_TRUE(remarks_on(heave + "-1 1 1 1.0\n0 1 1 1.6\n" + rows, "exchanged"));
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

TEST(Radiation, IsACompleteTableOrRefused) {
    const std::string rows = "10 1 1 1.5 0.25\n10 3 3 1 0.1\n5 1 1 1.2 0.5\n5 3 3 1 0.2\n";
    const std::string form = "; a row of WAMIT's .1 is period, i, j, added mass and, but for the limits, damping";
    const std::string lost = "; was a row lost? What is zero by symmetry is missing at all of them";
    EXPECT_EQ(message(rows + "10 1 3 0.1 0\n"),
              "hull.1: the period 5 s lacks the element 1 3, which 1 of 2 periods and limits have" + lost);
    EXPECT_EQ(message(rows + "10 1 3 0.1 0\n5 1 3 0.1 0\n"), "read") << "the other half stands nowhere";
    EXPECT_EQ(
        message("0 1 1 1.0\n" + rows),
        "hull.1: the limit of infinite frequency lacks the element 3 3, which 2 of 3 periods and limits have" + lost);
    EXPECT_EQ(message(rows + "10 1 5 0.1 0\n5 1 5 0.1 0\n"),
              "hull.1: has the element 1 5 and nowhere 5 5; were rows lost?");
    EXPECT_EQ(message(rows + "10 3 3 2 0.1\n"),
              "hull.1:5: gives the element 3 3 of the period 10 s other values than line 2" + form);
    EXPECT_EQ(message(rows + "-1 1 1 2\n-1 1 1 3\n"),
              "hull.1:6: gives the element 1 1 of the limit of zero frequency other values than line 5" + form);
    EXPECT_EQ(message(rows + "1.0D+01 3 3 +1. 1E-1\n"), "read") << "the same again";
    EXPECT_EQ(message("1O 1 1 1.5 0.2\n10 1 1 1.5 0.25\n"), "hull.1:1: has a word that is no number" + form)
        << "no title";
    EXPECT_EQ(message("10 1 1 1.50 0.25\n10 3 3 1.00 0.10\n5 1 1 1.20 0.50\n5 3 3 1.00 0.2"),
              "hull.1:4: ends within a number, 0.2; was the file cut off?");
    EXPECT_EQ(message(rows.substr(0, rows.size() - 1)), "read") << "numbers of any length";
}

TEST(Radiation, HalvesThatContradictEachOtherAreRefused) {
    const auto with = [](const char* half) {
        return fmt::format("10 1 1 1 0.2\n10 5 5 4 0.2\n10 1 5 -1 0\n10 5 1 {} 0\n", half);
    };
    EXPECT_EQ(message(with("-1.1")), "read");
    EXPECT_TRUE(remarks_on(with("-0.7"), "the two halves of its added mass differ by up to 15 %; their mean is taken"));
    EXPECT_EQ(message(with("1")),
              "hull.1: has added mass of 1025 for 5 1 and of -1025 for 1 5 at 10 s; such a matrix is symmetric, so one "
              "of the two is wrong");
}

std::string field(const char* name) {
    return file_text(std::string(FLOES_SOURCE_DIR) + "/tests/hydro/field/" + name);
}

std::array<double, 6> all_at(double period) {
    std::array<double, 6> found{};
    found.fill(period_of(period));
    return found;
}

// Of a body with damping in closed form; at 9 s it is 67.1 t/s in heave.
TEST(Radiation, ReadsDecimalCommasAndFrequenciesByTheirUnit) {
    const std::string text = field("buoy.1");
    const RadiationFile points = read_radiation(text, "buoy.1", {});
    EXPECT_NEAR(radiation_at(points, period_of(9)).damping(2, 2), 67.1e3, 50);
    std::string commas = text;
    std::ranges::replace(commas, '.', ',');
    EXPECT_EQ(read_radiation(commas, "buoy.1", {}), points);
    EXPECT_EQ(message("10,1,1,1.5,0.25\n10, 3, 3, 1, 0.1\n"), "read") << "commas between numbers";

    const std::string periods = field("buoy_periods.tec");
    const RadiationFile nemoh = read_radiation(periods, "buoy.tec", {});
    ASSERT_EQ(nemoh.points.size(), 11);
    EXPECT_NEAR(nemoh.points.front().frequency, 0.2, 1e-7) << "of the longest period";
    EXPECT_NEAR(nemoh.points.front().added(0, 0), 257692.31, 0.01);
    std::string hertz = periods;
    hertz.replace(hertz.find("T (s)"), 5, "f (Hz)");
    EXPECT_NEAR(read_radiation(hertz, "buoy.tec", {}).points.back().frequency, 2 * pi * 31.415927, 1e-6);
    std::string other = periods;
    other.replace(other.find("T (s)"), 5, "T (min)");
    EXPECT_EQ(message(other), "hull.1:1: has the unit (min); its frequencies are to be in (rad/s), (Hz) or (s)");
    other.replace(other.find("T (min)"), 7, "T");
    EXPECT_EQ(message(other), "hull.1:1: names no unit; its frequencies are to be in (rad/s), (Hz) or (s)");
}

TEST(Radiation, IsNotInterpolatedOverAGap) {
    const std::string text = field("buoy.1");
    const RadiationFile all = read_radiation(text, "buoy.1", {});
    EXPECT_EQ(doubts(all, "buoy.1", all_at(9)), "");
    std::string gap;
    std::string wide;
    for (const std::string& line : [&] {
             std::vector<std::string> lines;
             std::istringstream stream(text);
             for (std::string line; std::getline(stream, line);) lines.push_back(line + "\n");
             return lines;
         }()) {
        const double period = std::stod(line);
        if (period <= 0 || period == 5 || period == 40) gap += line;
        if (period == 5 || period == 8 || period == 12) wide += line;
    }
    const RadiationFile two = read_radiation(gap, "gap.1", {});
    EXPECT_EQ(refusal([&] { doubts(two, "gap.1", all_at(9)); }),
              "gap.1: has no period near enough to know the damping in surge at 9 s, between 5 and 40 s; take a file "
              "with more periods there, or a period that it has");
    EXPECT_EQ(doubts(two, "gap.1", all_at(40)), "") << "the period itself";
    // Said where it is off by more than a tenth, and by no more than said.
    const RadiationFile three = read_radiation(wide, "wide.1", {});
    const std::string said = doubts(three, "wide.1", all_at(6));
    EXPECT_NE(said.find("at 6 s, between 5 and 8 s: "), std::string::npos) << said;
    const std::size_t heave = said.find("heave ");
    ASSERT_NE(heave, std::string::npos) << said;
    const double largest = std::max(three.points[0].damping(2, 2), three.points[1].damping(2, 2));
    const double off =
        std::abs(radiation_at(three, period_of(6)).damping(2, 2) - radiation_at(all, period_of(6)).damping(2, 2));
    EXPECT_GT(off, 0.01 * largest);
    EXPECT_LT(off, 0.01 * std::stod(said.substr(heave + 6)) * largest);
}

TEST(Radiation, OfNemohHasAZoneForEachMotion) {
    std::string text = "VARIABLES=\"w (rad/s)\"\n\"A   1   1\" \"B   1   1\"\n";
    std::string five;
    for (int move = 0; move < 6; ++move) {
        text += fmt::format("Zone t=\"Motion of body    1 in DoF   {}\",I=  1,F=POINT\n  0.5", move + 1);
        for (int force = 0; force < 6; ++force)
            text += fmt::format(" {} {}", 1000 + 10 * force + move, force == move ? 1 : 0);
        text += "\n";
        if (move == 4) five = text;
    }
    const RadiationFile found = read_radiation(text, "r.tec", {});
    ASSERT_EQ(found.points.size(), 1);
    EXPECT_EQ(found.points[0].frequency, 0.5);
    EXPECT_EQ(found.points[0].added(4, 0), 1040) << "force in pitch by a motion in surge";
    EXPECT_EQ(found.points[0].damping(3, 3), 1);
    EXPECT_EQ(message(five), "hull.1: has 5 of the six zones, one for each motion; was the file cut off?");

    const auto with = [&](const std::string& old, const std::string& fresh) {
        std::string changed = text;
        changed.replace(changed.find(old), old.size(), fresh);
        return message(changed);
    };
    EXPECT_EQ(with("I=  1", "I=  2"), "hull.1: zone 1 has 1 rows, and its head says 2; were some lost?");
    EXPECT_EQ(with("0.5 1000 1", "0.6 1000 1"),
              "hull.1: has 0.5 rad/s, a period of 12.5664 s, in some of its six zones and not in all; was a row lost?");
    EXPECT_EQ(with("DoF   2", "DoF   3").substr(0, 65),
              "hull.1:5: is the zone of motion 3, and that of motion 2 is due; a");
    EXPECT_EQ(with("body    1", "body    2").substr(0, 31), "hull.1:3: is of a second body, ");
    const std::string row =
        text.substr(text.find("  0.5"), text.find("\nZone", text.find("  0.5")) - text.find("  0.5") + 1);
    EXPECT_EQ(with("F=POINT\n", "F=POINT\n" + row), "read") << "the same again";
    std::string another = row;
    another.replace(another.find(" 1 "), 3, " 2 ");
    EXPECT_EQ(with("F=POINT\n", "F=POINT\n" + another).substr(0, 69),
              "hull.1:5: gives 0.5 (rad/s) other values than line 4 of the same zone");
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
