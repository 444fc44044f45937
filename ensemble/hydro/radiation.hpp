#pragma once
// Added mass and radiation damping from the files of radiation programs: WAMIT's .1, and NEMOH's
// RadiationCoefficients.tec. Matrices are in the order and the axes of such programs: surge, sway, heave, roll, pitch,
// yaw with x ahead, y to port and z up, about the program's own reference point.

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace floes {

using Matrix6 = std::vector<std::vector<double>>;  ///< six rows of six

/// What a WAMIT file does not say; NEMOH's is in SI.
struct WamitUnits {
    double density = 1025;  ///< ρ, kg/m³
    double length = 1;      ///< L, ULEN of the GDF file, m
};

struct RadiationPoint {
    double frequency = 0;  ///< rad/s
    Matrix6 added{};       ///< kg, kg m, kg m²
    Matrix6 damping{};     ///< over s
};

struct RadiationFile {
    std::vector<RadiationPoint> points{};  ///< of rising frequencies, at least one
    std::vector<std::string> remarks{};    ///< sentences about what the file lacks or seems to have wrong
    std::optional<Matrix6> at_zero{};      ///< added mass, kg
    std::optional<Matrix6> at_infinity{};  ///< likewise
};

/// `file` names it in messages. Throws InputError, with the line, for what is no such file and for numbers that are
/// none.
RadiationFile read_radiation(std::string_view text, const std::string& file, const WamitUnits& units);

/// Between the two nearest frequencies. Throws InputError outside those of the file.
RadiationPoint radiation_at(const RadiationFile& radiation, double frequency);

/// The waterplane of a body that makes the damping in heave of the lowest frequency, m², and sees waves that are long
/// against it: B33 = ρ ω g k S²/(4 V_g ω), V_g the group velocity. `depth`: m; infinite: deep. It is a guard: a first
/// column that is no period, another L or ρ give another waterplane than the hull's. Nothing without such damping.
std::optional<double> waterplane_by_waves(const RadiationFile& radiation, double density, double gravity, double depth);

}  // namespace floes
