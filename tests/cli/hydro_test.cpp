// floes hydro: keys from the files of other programs, and the questions that these files leave open.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <numbers>
#include <string>

#include <fmt/format.h>

#include "cli/verb_output.hpp"
#include "core/error.hpp"
#include "support/file_bytes.hpp"
#include "support/temporary_folder.hpp"

namespace floes {
namespace hydro_test {

using testing::HasSubstr;

/// A file in the folder of these tests.
std::string file(const std::string& name, const std::string& text) {
    static const TemporaryFolder folder;
    std::string path = folder / name;
    std::ofstream(path) << text;
    return path;
}

/// A cylinder of 0.7 m that floats 0.63 m deep, as in WAMIT's example (WEC-Sim), on springs.
std::string cylinder() {
    return file("cylinder.toml",
                "[hull]\nshape = \"cylinder\"\ndiameter_m = 0.7\ndraught_m = 0.63\nfreeboard_m = 0.2\n"
                "[moorings]\nfree = [\"surge\", \"sway\", \"yaw\", \"heave\", \"roll\", \"pitch\"]\n"
                "mass_t = 0.248\ncentre_m = -0.4\ngyration_m = 0.3\ngyration_pitch_m = 0.3\ngyration_roll_m = 0.3\n"
                "surge_kN_m = 1.0\nsway_kN_m = 1.0\nyaw_kN_m_rad = 0.2\n");
}

/// Added mass in heave falls from 0.4 to 0.1 of ρ L³ with the frequency; the damping of 100 s is that of the cylinder's
/// waterplane. Periods are near enough to be interpolated.
std::string radiation() {
    std::string rows;
    constexpr int steps = 20;
    for (int k = 0; k <= steps; ++k) {
        const double period = std::pow(100.0, 1 - static_cast<double>(k) / steps);
        const double share = (1 / period - 0.01) / 0.99;
        rows += fmt::format("{0:.6E} 3 3 {1:.6E} {2:.6E}\n{0:.6E} 1 1 0.17 0\n{0:.6E} 1 3 {3:.6E} 0\n", period,
                            std::lerp(0.4, 0.1, share), std::lerp(2.98e-5 * 0.01, 0.02, share) * period,
                            std::lerp(1e-5, -1e-5, share));
    }
    return file("cylinder.1", rows);
}

std::string hydro(const std::string& arguments) {
    return verb_output(add_hydro, "hydro " + arguments);
}

std::string message(const std::string& arguments) {
    try {
        return hydro(arguments);
    } catch (const InputError& error) {
        return error.what();
    }
}

TEST(Hydro, TakesEachMotionAtItsNaturalPeriod) {
    const std::string keys = hydro(radiation() + " --hull " + cylinder());
    EXPECT_THAT(keys, HasSubstr("at the natural period of each motion of"));
    // T = 2π √((m + A(T)) / C33), m 0.248 t, C33 3.775 kN/m: at 2.335 s the file has 0.273 t.
    EXPECT_THAT(keys, HasSubstr("heave 2.335 s"));
    EXPECT_THAT(keys, HasSubstr("  [0.17, 0, 0, 0, 0, 0],")) << "what couples by rounding is gone";
    EXPECT_THAT(message(radiation()), HasSubstr("give the period at which its values are to hold, --period-s, or"));
    EXPECT_THAT(message(radiation() + " --period-s 200"),
                HasSubstr("cylinder.1: has periods from 1 to 100 s, and --period-s 200 is outside"));
}

// Added mass by the matrix is in addition to that by numbers: its natural periods are those without them.
TEST(Hydro, SaysWhichKeysOfTheHullItsMatricesReplace) {
    const std::string plain = hydro(radiation() + " --hull " + cylinder());
    EXPECT_THAT(plain, testing::Not(HasSubstr("leave out")));
    EXPECT_THAT(plain, testing::Not(HasSubstr("damping_percent")));
    const std::string stated = file("stated.toml", file_text(cylinder()) +
                                                       "added_surge_t = 0.17\nadded_heave_t = 0.2\n"
                                                       "damping_percent = 5.0\n");
    const std::string keys = hydro(radiation() + " --hull " + stated);
    EXPECT_THAT(keys, HasSubstr("heave 2.335 s"));
    EXPECT_THAT(keys, HasSubstr("# leave out moorings.added_surge_t, moorings.added_heave_t of "));
    EXPECT_THAT(keys, HasSubstr("stated.toml: added_mass is in their place, and would be in addition to them\n"));
    EXPECT_THAT(keys, HasSubstr("stated.toml is in addition to radiation_damping: let it be what lines and friction"));
}

/// Pitch of a hull with a low centre swings with surge: about a point near its centre, with less inertia than about the
/// waterline.
TEST(Hydro, TakesPitchAtThePeriodAtWhichItSwingsWithSurge) {
    const std::string keys = hydro(radiation() + " --hull " + cylinder());
    const double mass = 0.248;
    const double surge = mass + 0.17;
    const double couples = mass * -0.4;
    const double pitch = mass * (0.3 * 0.3 + 0.4 * 0.4);
    // ρ g (I + V z_b) - m g z_c about the axis at the calm water, kN m
    const double area = std::numbers::pi * 0.35 * 0.35;
    const double rights = 9.81 * (area * 0.35 * 0.35 / 4 - area * 0.63 * 0.315 + mass * 0.4);
    // The larger ω² of (k_x - ω² m)(k_θ - ω² I) = ω⁴ c²:
    const double a = surge * pitch - couples * couples;
    const double b = 1.0 * pitch + rights * surge;
    const double square = (b + std::sqrt(b * b - 4 * a * 1.0 * rights)) / (2 * a);
    const double period = 2 * std::numbers::pi / std::sqrt(square);
    EXPECT_THAT(keys, HasSubstr(fmt::format("pitch {:.4g} s", period)));
    EXPECT_GT(2 * std::numbers::pi / std::sqrt(rights / pitch), 1.1 * period) << "by itself";
}

TEST(Hydro, ChecksTheWaterplaneByLongWaves) {
    EXPECT_THAT(hydro(radiation() + " --period-s 1 --waterplane-m2 0.385"), HasSubstr("of a waterplane of 0."));
    EXPECT_THAT(message(radiation() + " --period-s 1 --waterplane-m2 3"),
                HasSubstr("is its first column a period in s, --length-m its length"));
    EXPECT_THAT(message(radiation() + " --length-m 3 --hull " + cylinder()), HasSubstr("not of the 0.3848 m² of"));
}

// A hull that is deep against the longest waves of its file makes less damping than its waterplane.
TEST(Hydro, DoesNotAskShortWavesForTheWaterplane) {
    const std::string of_short_waves = file("short.1", "2.0E+00 3 3 0.2 1E-05\n1.0E+00 3 3 0.1 1E-05\n");
    const std::string hinted = hydro(of_short_waves + " --period-s 2 --hull " + cylinder());
    EXPECT_THAT(hinted, HasSubstr("they are 6.245 m long, too short to know it, if its first column is a period in s"));
}

TEST(Hydro, ComparesHydrostatics) {
    const std::string stiffness = file("cylinder.hst", "3 3 0.38375\n4 4 -0.06449\n5 5 -0.06449\n");
    EXPECT_THAT(message(stiffness), HasSubstr("say with --weight inside or --weight outside"));
    EXPECT_THAT(hydro(stiffness + " --weight outside --hull " + cylinder()), HasSubstr("# they are the same hull"));
    EXPECT_THAT(hydro(stiffness + " --weight inside --hull " + cylinder()), HasSubstr("# THEY DIFFER"));
    EXPECT_THAT(hydro(stiffness + " --weight inside"), HasSubstr("# give --hull to compare it"));
}

TEST(Hydro, MovesMatricesFromTheirReference) {
    // A point of added mass 2 m below the axis: A15 = -2 A11 about the axis, 4 A11 in pitch.
    const std::string below = file("below.1", "10 1 1 0.001 0\n10 3 3 0.001 0.0001\n");
    const std::string keys = hydro(below + " --period-s 10 --reference-m 0,0,-2 --density 1000");
    EXPECT_THAT(keys, HasSubstr("about the axis at the calm water, from (0, 0, -2) m"));
    EXPECT_THAT(keys, HasSubstr("  [0.001, 0, 0, 0, -0.002, 0],"));
    EXPECT_THAT(keys, HasSubstr("  [-0.002, 0, 0, 0, 0.004, 0],"));
}

TEST(Hydro, SaysWhatItRead) {
    EXPECT_THAT(
        hydro(radiation() + " --period-s 9"),
        HasSubstr("# read: 21 periods from 1 to 100 s; 4 of 36 elements, 1 of them by symmetry from the other "
                  "half, the others 0 by symmetry; neither the limit of zero nor that of infinite frequency\n"));
    const std::string few = file("few.1", "5 3 3 1 0.3\n40 3 3 1 0.1\n");
    EXPECT_THAT(message(few + " --period-s 9"),
                HasSubstr("few.1: has no period near enough to know the damping in heave"));
    EXPECT_THAT(hydro(few + " --period-s 40"), HasSubstr("added_mass"));
}

// Halves that programs differ by pass; a motion of its own that would be driven on does not, as in a configuration.
TEST(Hydro, PrintsNothingThatAConfigurationRefuses) {
    const std::string driven =
        file("driven.1", "10 3 3 1 0\n10 5 5 1 0.001\n10 3 5 0 0.01\n10 1 1 1 0\n10 2 2 1 0\n10 4 4 1 0\n");
    EXPECT_THAT(message(driven + " --period-s 10 --reference-m 5,0,0"),
                HasSubstr("which would drive that motion on; give 0 or more"));
}

}  // namespace hydro_test
}  // namespace floes
