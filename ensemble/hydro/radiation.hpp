#pragma once
// Added mass and radiation damping from the files of radiation programs: WAMIT's .1, NEMOH's RadiationCoefficients.tec
// and Capytaine's NetCDF. Matrices are in the order and the axes of such programs: surge, sway, heave, roll, pitch, yaw
// with x ahead, y to port and z up, about the program's own reference point.

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/vector.hpp"

namespace floes {

inline constexpr std::array<std::string_view, 6> hydrodynamic_motions{"surge", "sway", "heave", "roll", "pitch", "yaw"};

/// What a WAMIT file does not say; NEMOH's is in SI.
struct WamitUnits {
    double density = 1025;  ///< ρ, kg/m³
    double length = 1;      ///< L, ULEN of the GDF file, m
};

struct RadiationPoint {
    double frequency = 0;         ///< rad/s
    Mat6 added = Mat6::Zero();    ///< kg, kg m, kg m²
    Mat6 damping = Mat6::Zero();  ///< over s
};

/// The water that a program computed in, and the hull in it, where its file says so: Capytaine's does.
struct RadiationWater {
    double density = 0;     ///< kg/m³
    double gravity = 0;     ///< m/s²
    double depth = 0;       ///< m, infinite: deep
    double waterplane = 0;  ///< m², by its own stiffness in heave; 0: not said
};

struct RadiationFile {
    std::vector<RadiationPoint> points{};  ///< of rising frequencies, at least one
    std::vector<std::string> remarks{};    ///< sentences about what the file lacks or seems to have wrong
    std::optional<Mat6> at_zero{};         ///< added mass, kg
    std::optional<Mat6> at_infinity{};     ///< likewise
    std::optional<RadiationWater> water{};
    std::optional<Vec3> reference{};  ///< about which its matrices are, if it says so: x ahead, y to port, z up, m
};

/// Whether the beginning is that of a file whose kind cannot be mistaken, NetCDF or NEMOH's.
bool is_radiation(std::string_view bytes);

/// `bytes`: the whole file, of which kind its beginning says; `file` names it in messages. Throws InputError, with the
/// line, for what is no such file and for numbers that are none.
RadiationFile read_radiation(std::string_view bytes, const std::string& file, const WamitUnits& units);

/// Between the two nearest frequencies. Throws InputError outside those of the file.
RadiationPoint radiation_at(const RadiationFile& radiation, double frequency);

/// Each motion at a frequency of its own, rad/s: the element of two motions at the mean of theirs. Outside the file's
/// frequencies those at its end.
RadiationPoint radiation_at(const RadiationFile& radiation, const std::array<double, 6>& frequencies);

/// A matrix about `reference` (m, in the file's axes) as it is about the origin: forces and motions of a body are those
/// of the same body.
Mat6 about_origin(const Mat6& matrix, const Vec3& reference);

/// The waterplane of a body that makes the damping in heave of the lowest frequency, m², and sees waves that are long
/// against it: B33 = ρ ω g k S²/(4 V_g ω), V_g the group velocity. `depth`: m; infinite: deep. It is a guard: a first
/// column that is no period, another L or ρ give another waterplane than the hull's. Nothing without such damping.
std::optional<double> waterplane_by_waves(const RadiationFile& radiation, double density, double gravity, double depth);

/// Length of the file's longest waves, m.
double longest_wave(const RadiationFile& radiation, double gravity, double depth);

// The water's stiffness by a radiation program: WAMIT's .hst, or the six rows of NEMOH's KH.dat. floes has it from the
// hull's own shape; a file of it says whether both programs mean the same hull.

/// Whether the first row of numbers is one of such a file: three of them (i, j, C), or six.
bool is_hydrostatic(std::string_view text);

/// N/m, N, N m, in the axes of radiation programs. Without the units of WAMIT's files, ρ g L^k, NEMOH's are in SI.
/// Throws InputError, with the line, for numbers that are none, for a second body, and where all are zero.
Mat6 read_hydrostatics(std::string_view text, const std::string& file, const WamitUnits& units, double gravity);

}  // namespace floes
