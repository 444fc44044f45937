#pragma once
// Added mass and radiation damping from the files of radiation programs: WAMIT's .1, NEMOH's RadiationCoefficients.tec
// and Capytaine's NetCDF. Matrices are in the order and the axes of such programs: surge, sway, heave, roll, pitch, yaw
// with x ahead, y to port and z up, about the program's own reference point.

#include <array>
#include <numbers>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/vector.hpp"
#include "hydro/wamit.hpp"

namespace floes {

inline constexpr std::array<std::string_view, 6> hydrodynamic_motions{"surge", "sway", "heave", "roll", "pitch", "yaw"};

/// Of a frequency in rad/s, s.
constexpr double period_of(double frequency) {
    return 2 * std::numbers::pi / frequency;
}

struct RadiationPoint {
    double frequency = 0;         ///< rad/s
    Mat6 added = Mat6::Zero();    ///< kg, kg m, kg m²
    Mat6 damping = Mat6::Zero();  ///< over s

    friend bool operator==(const RadiationPoint&, const RadiationPoint&) = default;
};

/// The water that a program computed in, and the hull in it, where its file says so: Capytaine's does.
struct RadiationWater {
    double density = 0;     ///< kg/m³
    double gravity = 0;     ///< m/s²
    double depth = 0;       ///< m, infinite: deep
    double waterplane = 0;  ///< m², by its own stiffness in heave; 0: not said

    friend bool operator==(const RadiationWater&, const RadiationWater&) = default;
};

struct RadiationFile {
    std::vector<RadiationPoint> points{};  ///< of rising frequencies, at least one
    std::vector<std::string> remarks{};    ///< sentences about what the file lacks or seems to have wrong
    std::optional<Mat6> at_zero{};         ///< added mass, kg
    std::optional<Mat6> at_infinity{};     ///< likewise
    std::optional<RadiationWater> water{};
    std::optional<Vec3> reference{};  ///< about which its matrices are, if it says so: x ahead, y to port, z up, m
    int elements = 0;                 ///< of the 36 of each matrix, that it has
    int mirrored = 0;                 ///< of these, that stand in the other half

    friend bool operator==(const RadiationFile&, const RadiationFile&) = default;
};

/// Of what motions have themselves, each at least a share of the largest of its kind, along axes or about them.
Vec6 no_less_than(Vec6 own, double share);

/// What was read, in one line: periods, elements, limits.
std::string extent_of(const RadiationFile& radiation);

/// Whether the beginning is that of a file whose kind cannot be mistaken, NetCDF or NEMOH's.
bool is_radiation(std::string_view bytes);

/// `bytes`: the whole file, of which kind its beginning says; `file` names it in messages. Throws InputError, with the
/// line, for what is no such file, for numbers that are none, for a table that is not complete (an element stands at
/// all periods or, zero by symmetry, at none), for what stands twice with other values, and for halves of a matrix that
/// contradict each other.
RadiationFile read_radiation(std::string_view bytes, const std::string& file, const WamitUnits& units);

/// Between the two nearest frequencies. Throws InputError outside those of the file.
RadiationPoint radiation_at(const RadiationFile& radiation, double frequency);

/// Each motion at a frequency of its own, rad/s: the element of two motions at the mean of theirs. Outside the file's
/// frequencies those at its end.
RadiationPoint radiation_at(const RadiationFile& radiation, const std::array<double, 6>& frequencies);

/// What interpolation may be off by, where that is more than a tenth of the largest damping of a motion in the file and
/// of a tenth of its ω A: a sentence, or none. `frequencies`: of each motion. Throws InputError where it is more than a
/// half. Between neighbours a and b, a share t of the way, it is
///
///   4 t (1 - t) max(E_a, E_b, (r - 1)²/r max(B_a, B_b)),   r = ω_b/ω_a
///
/// E_a, E_b: what it would be off by at a and b if the file had no row there. The last term is for files that have too
/// few rows to show it: a hull's damping ω³ e^(-1.5 ω²) about its peak has (r - 1)² 3/4r. Files of WAMIT's hulls of one
/// piece (WEC-Sim: cylinder, ellipsoid, RM3), thinned to r from 1.1 to 2, are nowhere off by more than it and a
/// tenth; a resonance narrower than the gap is not seen.
std::string doubts(const RadiationFile& radiation, const std::string& file, const std::array<double, 6>& frequencies);

/// A matrix about `reference` (m, in the file's axes) as it is about the origin: forces and motions of a body are those
/// of the same body.
Mat6 about_origin(const Mat6& matrix, const Vec3& reference);

/// The waterplane of a body that makes the damping in heave of the lowest frequency, m², and sees waves that are long
/// against it: B33 = ρ ω g k S²/(4 V_g ω), V_g the group velocity. `depth`: m; infinite: deep. It is a guard: a first
/// column that is no period, another L or ρ give another waterplane than the hull's. Nothing without such damping.
std::optional<double> waterplane_by_waves(const RadiationFile& radiation, double density, double gravity, double depth);

/// Length of the file's longest waves, m.
double longest_wave(const RadiationFile& radiation, double gravity, double depth);

}  // namespace floes
