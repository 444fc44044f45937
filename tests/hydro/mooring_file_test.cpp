// Files of MoorDyn and MoorPy: both orders of columns, axes, weights, and what is not read.

#include "hydro/mooring_file.hpp"

#include <gtest/gtest.h>

#include <numbers>
#include <string>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "hydro/mooring_keys.hpp"
#include "support/file_bytes.hpp"
#include "support/refusal.hpp"

namespace floes {
namespace mooring_file_test {

constexpr double pi = std::numbers::pi;

const std::string types =
    "--------------- LINE TYPES ---------------\n"
    "Name Diam MassDen EA BA EI Cd Ca CdAx CaAx\n"
    "(-) (m) (kg/m) (N) (N-s/-) (-) (-) (-) (-) (-)\n"
    "main 0.09 77.7066 384.243E6 -0.8 0 1.6 1.0 0.1 0.0\n";
const std::string points =
    "--------------- POINT PROPERTIES ----------------\n"
    "ID Type X Y Z Mass Volume CdA Ca\n"
    "(#) (-) (m) (m) (m) (kg) (m3) (m^2) (-)\n"
    "1 Fixed -426.94 739.47 -320.0 0 0 0 0\n"
    "2 Coupled -2.6 4.5 -70.0 0 0 0 0\n";
const std::string lines =
    "--------------- LINES ----------------\n"
    "ID LineType AttachA AttachB UnstrLen NumSegs LineOutputs\n"
    "(#) (name) (#) (#) (m) (-) (-)\n"
    "1 main 1 2 902.2 20 p\n";

const std::string end = "--- need this line ---\n";

std::string message(const std::string& text) {
    return refusal_or("read", [&] { read_moorings(text + end, "m.dat", 1025, 9.80665); });
}

// The port line of the OC3 spar (MoorDyn, example/lines.txt): y to port is -z here.
TEST(MooringFile, OfMoorDynHasItsLinesInFloesAxes) {
    const std::string options = "-------- OPTIONS --------\n0.001 FrictionCoefficient\n1025.0 WtrDnsty water density\n";
    const MooringFile found =
        read_moorings("a title\n" + types + points + lines + options + end, "m.dat", 1000, 9.80665);
    ASSERT_EQ(found.lines.size(), 1);
    const HangingLine& line = found.lines[0];
    EXPECT_EQ(line.fairlead, Vec3(-2.6, -70, -4.5));
    EXPECT_NEAR(line.azimuth, -2 * pi / 3, 1e-4);
    EXPECT_NEAR(line.distance, 853.87 - 5.2, 0.01);
    EXPECT_EQ(line.depth, 320);
    EXPECT_NEAR(line.cable.weight, 698.09, 0.01) << "by the file's density, not the one given";
    EXPECT_EQ(line.cable.length, 902.2);
    EXPECT_EQ(line.cable.friction, 0.001);
    EXPECT_NEAR(pull(line, Vec6::Zero()).tension, 911089.5, 300);
}

TEST(MooringFile, TakesTheFirstVersionsOrderByItsNames) {
    const std::string first =
        "---- LINE PROPERTIES ----\n"
        "Line LineType UnstrLen NumSegs NodeAnch NodeFair Flags\n"
        "(-) (-) (m) (-) (-) (-) (-)\n"
        "1 main 902.2 20 1 2 p\n";
    const std::string nodes =
        "---- NODE PROPERTIES ----\n"
        "Node Type X Y Z M V FX FY FZ CdA CA\n"
        "(-) (-) (m) (m) (m) (kg) (m^3) (kN) (kN) (kN) (m2) ()\n"
        "1 Fix 853.87 0 -320 0 0 0 0 0 0 0\n"
        "2 Vessel 5.2 0 -70 0 0 0 0 0 0 0\n";
    const MooringFile found = read_moorings(types + nodes + first + end, "m.dat", 1025, 9.80665);
    ASSERT_EQ(found.lines.size(), 1);
    EXPECT_EQ(found.lines[0].cable.length, 902.2);
    EXPECT_EQ(found.lines[0].azimuth, 0);
}

std::string field(const std::string& name) {
    return file_text(std::string(FLOES_SOURCE_DIR) + "/tests/hydro/field/" + name);
}

std::string changed(std::string text, const std::string& old, const std::string& fresh) {
    return text.replace(text.find(old), old.size(), fresh);
}

/// A place of the file's reference moves matrices alone.
TEST(MooringFile, IsNotReadAboutAnotherPoint) {
    MooringKeysRequest request;
    request.file = "m.dat";
    EXPECT_EQ(refusal_or("read", [&] { mooring_keys(request, types + points + lines + end); }), "read");
    request.reference = {10, 0, -5};
    EXPECT_EQ(
        refusal_or("read", [&] { mooring_keys(request, types + points + lines + end); }),
        "--reference-m moves matrices of added mass and damping, and m.dat has none; give points and stiffness from "
        "the axis at the calm water");
}

TEST(MooringFile, TakesAFailureByTensionForABreakLoad) {
    const std::string text = field("moordyn_failure.dat");
    const MooringFile found = read_moorings(text, "m.dat", 1025, 9.80665);
    ASSERT_EQ(found.lines.size(), 1);
    EXPECT_EQ(found.lines[0].break_load, 5e6);
    ASSERT_EQ(found.remarks.size(), 1);
    EXPECT_EQ(found.remarks[0],
              "m.dat:13: point 2 has MASS 5000, VOLUME 2, which is not modelled: give the hull what it bears");
    const std::string row = "1            2          1         0       5000000";
    const auto with = [&](const std::string& other) { return message(changed(text, row, other)); };
    EXPECT_EQ(with("1 2 1 12 0"), "m.dat:21: has a failure at 12 s; lines fail by their tension here");
    EXPECT_EQ(with("1 1 1 0 5e6"),
              "m.dat:21: has the failure of 1 at point 1; one line that breaks at its own fairlead is read");
    EXPECT_EQ(with("1 2 1,2 0 5e6").substr(0, 44), "m.dat:21: has the failure of 1,2 at point 2;");
    EXPECT_EQ(with("1 2 1 0 5e6\n2 2 1 0 6e6"),
              "m.dat:22: has line 1 fail at another tension than line 21 of the file");
    EXPECT_EQ(with("1 2 1 0 3e5").substr(0, 33), "m.dat:17: line 1 pulls with 615.5");
    EXPECT_EQ(message(changed(text, "(N or 0)", "(kN)")),
              "m.dat:20: has its column FAILTEN in (kN), and MoorDyn reads it in (N)");
}

// Water of 500 kg/m³: 9.80665 (180 - 500 π/4 0.1²) = 1726.69 N/m; of 1025 it would be 1686.25.
TEST(MooringFile, TakesOptionsInEitherOrder) {
    for (const char* name : {"moordyn_equals_option.dat", "moordyn_option_swapped.dat"}) {
        const MooringFile found = read_moorings(field(name), name, 1025, 9.80665);
        ASSERT_EQ(found.lines.size(), 2);
        EXPECT_NEAR(found.lines[0].cable.weight, 1726.69, 0.01) << name;
        EXPECT_EQ(found.remarks.size(), 0);
    }
    const std::string all = types + points + lines;
    const auto weight = [&](const std::string& option) {
        return read_moorings(all + "--- OPTIONS ---\n" + option + "\n" + end, "m.dat", 1025, 9.80665)
            .lines[0]
            .cable.weight;
    };
    EXPECT_EQ(weight("rho=1000"), weight("1000 WtrDnsty"));
    EXPECT_LT(weight("1025 rho"), weight("1000 rho"));
}

TEST(MooringFile, NamesWhatIsNotModelled) {
    const auto remarks = [&](const std::string& text) {
        const MooringFile found = read_moorings(text, "m.dat", 1025, 9.80665);
        return fmt::format("{}", fmt::join(found.remarks, "\n"));
    };
    const auto options = [&](const std::string& rows) {
        return remarks(types + points + lines + "--- OPTIONS ---\n" + rows + end);
    };
    EXPECT_EQ(options("0.001 dtM\n3e6 kBot\n3e5 cBot\n0 WaveKin\n1 StatDynFricScale\nRK4 tScheme\n320 WtrDpth\n"), "");
    EXPECT_EQ(options("2 WaveKin waves\n"), "m.dat:15: WaveKin 2 is not modelled: lines hang in still water");
    EXPECT_EQ(options("1e3 kBot\n"), "m.dat:15: kBot 1e3 is not modelled: the bottom is taken as hard");
    EXPECT_EQ(options("bottom.txt WtrDpth\n"),
              "m.dat:15: WtrDpth bottom.txt is not modelled: the bottom is taken as flat at each anchor");
    EXPECT_EQ(options("3 Sagging\n"), "m.dat:15: Sagging is no option that floes knows, and is left out");
    EXPECT_EQ(
        options("500 WtrDpth\n"),
        "m.dat:13: has its anchor 320 m deep, in water of 500 m by the options: the bottom is taken at the anchor");
    EXPECT_EQ(remarks(changed(types, "0.8 0 1.6", "0.8 7.5 1.6") + points + lines + end),
              "m.dat:4: line type main has EI 7.5, which is not modelled: lines bend freely and have their static EA");
    EXPECT_EQ(remarks(types + points + lines + "--- CONTROL ---\nID Line(s)\n() (,)\n1 1\n" + end),
              "m.dat:14: the section CONTROL is not modelled");
    EXPECT_EQ(remarks(types + points + lines + "--- OUTPUTS ---\nFairTen1\n" + end), "");
}

TEST(MooringFile, RefusesWhatStandsTwiceOtherwise) {
    const std::string again = "main 0.09 77.7066 384.243E6 -0.8 0 1.6 1.0 0.1 0.0\n";
    EXPECT_EQ(message(types + again + points + lines), "read");
    EXPECT_EQ(message(types + changed(again, "0.09", "9.0E-02") + points + lines), "read") << "written otherwise";
    EXPECT_EQ(message(types + changed(again, "77", "78") + points + lines),
              "m.dat:5: gives line type main again, otherwise than line 4");
    EXPECT_EQ(message(types + points + "2 Coupled -2.6 4.5 -71.0 0 0 0 0\n" + lines),
              "m.dat:10: gives point 2 again, otherwise than line 9");
    EXPECT_EQ(message(types + points + lines + "1 main 1 2 905.0 20 p\n"),
              "m.dat:14: gives line 1 again, otherwise than line 13");
    EXPECT_EQ(read_moorings(types + points + lines + "1 main 1 2 902.2 20 p\n" + end, "m.dat", 1025, 9.8).lines.size(),
              1);
    EXPECT_EQ(message(types + points + lines + "--- OPTIONS ---\n1025 rho\n1000 WtrDnsty\n"),
              "m.dat:16: gives WtrDnsty another value than line 15");
}

TEST(MooringFile, RefusesWhatCannotBeWhole) {
    const std::string no_end =
        "m.dat: does not end with the line that MoorDyn needs there, --- need this line ---; was the file cut off?";
    const auto refusal_of = [](const std::string& text) {
        return refusal([&] { read_moorings(text, "m.dat", 1025, 9.8); });
    };
    EXPECT_EQ(refusal_of(types + points + lines), no_end);
    EXPECT_EQ(refusal_of(types + points + lines + "---------------------- OPT"), no_end);
    EXPECT_EQ(refusal_of(types + points + lines + "----------"), no_end);
    EXPECT_EQ(message(types + points + lines + "----------\n"), "read");
    EXPECT_EQ(message(types + points + lines + "2 main 1 2 902.2 20 p 7\n"),
              "m.dat:14: has 8 words for the 7 columns of its table; a comment begins with #");
    EXPECT_EQ(message(types + points + "3 Fixed 0 0 -320\n" + lines),
              "m.dat: no line ends at point 3; was a line lost? Leave out a point that holds none");
    EXPECT_EQ(message(changed(types, "(-) (m) (kg/m) (N)", "(-) (m) (kg/m) (kN)") + points + lines),
              "m.dat:3: has its column EA in (kN), and MoorDyn reads it in (N)");
    EXPECT_EQ(message(types + changed(points, "(#) (-) (m) (m) (m) (kg) (m3) (m^2) (-)\n", "") + lines),
              "m.dat:7: is to be the units of the columns above, as (m) or (-); MoorDyn skips this line");
    EXPECT_EQ(message(types + points + lines + "--- OPTIONS ---\n300 WtrDpth\n"),
              "m.dat:13: has its anchor 320 m deep, in water of 300 m by the options; which of the two is right?");
    EXPECT_EQ(message(types + points + lines + "--- OPTIONS ---\n1025\n"),
              "m.dat:15: is no option: a value and its name");
}

// As a configuration with these lines does.
TEST(MooringFile, RefusesALineThatAConfigurationRefuses) {
    EXPECT_EQ(
        refusal([] { read_moorings(field("moordyn_short_line.dat"), "m.dat", 1025, 9.80665); }),
        "m.dat:28: line 1 is 300 m long and would be stretched to 494.2 m; take a longer line or a nearer anchor");
}

TEST(MooringFile, RefusesByNameWhatIsNoSuchLine) {
    EXPECT_EQ(message("--- RODS ---\nID Type\n(-) (-)\n1 rod\n" + types + points + lines),
              "m.dat:4: has rods, and lines alone are read");
    std::string free = points;
    free.replace(free.find("Coupled"), 7, "Free");
    EXPECT_EQ(message(types + free + lines),
              "m.dat:9: has a point that is Free; lines go from a fairlead on the vessel to a fixed anchor here");
    std::string fixed = points;
    fixed.replace(fixed.find("Coupled"), 7, "Fixed");
    EXPECT_EQ(message(types + fixed + lines), "m.dat:13: goes from anchor to anchor");
    std::string other = lines;
    other.replace(other.find("main"), 4, "none");
    EXPECT_EQ(message(types + points + other), "m.dat:13: has no line type none above it");
    std::string light = types;
    light.replace(light.find("77.7066"), 7, "1.5");
    EXPECT_EQ(message(light + points + lines), "m.dat:13: floats: it weighs -49.24 N/m in water");
    EXPECT_EQ(message(types + points), "m.dat: has no section of lines; it is to be a file of MoorDyn or MoorPy");
    std::string table = types;
    table.replace(table.find("384.243E6"), 9, "ea.txt");
    EXPECT_EQ(message(table + points + lines), "m.dat:4: has ea.txt for EA, which is no number");
}

}  // namespace mooring_file_test
}  // namespace floes
