#pragma once
// What an FMU of floes takes and gives: the variables of both ways of coupling, with their references and units.
//
// Axes are the earth's: X along the channel as the tow goes, Y to port, Z up, from where the configuration's tow or
// path has the hull, so that its moorings stand and ice comes from ahead. Turns are roll (heels to starboard), pitch
// (bow down) and yaw (bow to port). Forces act on the hull at its reference point, its axis at the height of the calm
// water.

#include <array>
#include <cstddef>
#include <span>
#include <string_view>
#include <vector>

#include "core/vector.hpp"

namespace floes {

/// Who moves the hull.
enum class HullMover {
    inside,  ///< the FMU, on its moorings: in go forces of others, out come motion and ice load
    outside  ///< the other program: in goes its motion, out comes the ice load
};
inline constexpr std::array<std::string_view, 2> hull_mover_words{"inside", "outside"};

enum class FmuType { real, integer, string };
enum class FmuRole { parameter, input, output };
inline constexpr std::array<std::string_view, 3> fmu_role_words{"parameter", "input", "output"};  ///< causality

struct FmuVariable {
    unsigned reference = 0;
    std::string_view name;
    std::string_view unit;   ///< of a real one
    std::string_view words;  ///< what it is
    FmuType type = FmuType::real;
    FmuRole role = FmuRole::input;
};

/// The first references of what comes in sixes (force and moment, place and turns, velocities, along X, Y and Z), and
/// those of single variables.
namespace fmu_reference {
inline constexpr unsigned arrangement = 1, case_name = 2, settings = 3, added_mass = 4;
inline constexpr unsigned force_in = 10, motion = 20, velocity = 26, ice_load = 40, mooring_load = 50;
inline constexpr unsigned floes_met = 60, broken_floes = 61, failed_joints = 62;
inline constexpr unsigned count = 63;  ///< all are below
}  // namespace fmu_reference

/// In the order of their references.
std::vector<FmuVariable> fmu_variables(HullMover mover);

/// A unit with its exponents.
struct FmuUnit {
    std::string_view name;
    std::string_view base;  ///< the attributes of its BaseUnit
};
std::span<const FmuUnit> fmu_units();

/// Between the world's axes (y up, z to starboard) and those above, of a force or a moment; its own inverse but for the
/// sense.
Vec3 to_fmu_axes(const Vec3& of_world);
Vec3 from_fmu_axes(const Vec3& of_fmu);
/// The same of an offset or a velocity by Motion (shapes/moorings.hpp): X, Y, Z, roll, pitch, yaw.
Vec6 to_fmu_motion(const Vec6& by_motion);
Vec6 from_fmu_motion(const Vec6& of_fmu);

}  // namespace floes
