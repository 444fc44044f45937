// Files of MoorDyn and MoorPy: both orders of columns, axes, weights, and what is not read.

#include "hydro/mooring_file.hpp"

#include <gtest/gtest.h>

#include <numbers>
#include <string>

#include "core/error.hpp"

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

std::string message(const std::string& text) {
    try {
        read_moorings(text, "m.dat", 1025, 9.80665);
    } catch (const InputError& error) {
        return error.what();
    }
    return "read";
}

// The port line of the OC3 spar (MoorDyn, example/lines.txt): y to port is -z here.
TEST(MooringFile, OfMoorDynHasItsLinesInFloesAxes) {
    const std::string options = "-------- OPTIONS --------\n0.001 FrictionCoefficient\n1025.0 WtrDnsty water density\n";
    const MooringFile found = read_moorings("a title\n" + types + points + lines + options, "m.dat", 1000, 9.80665);
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
    const MooringFile found = read_moorings(types + nodes + first, "m.dat", 1025, 9.80665);
    ASSERT_EQ(found.lines.size(), 1);
    EXPECT_EQ(found.lines[0].cable.length, 902.2);
    EXPECT_EQ(found.lines[0].azimuth, 0);
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
