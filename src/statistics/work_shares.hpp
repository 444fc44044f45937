#pragma once
// Where the work of the tow goes, as forces: work over the distance towed. Together they are the load over the steps
// that were looked at.

#include <array>

namespace floes {

struct WorkShares {
    double ice_friction = 0;   ///< N, friction between floes, and on the ice sheets
    double ice_crushing = 0;   ///< N, normal forces between floes, which crush and stop them
    double hull_friction = 0;  ///< N
    double hull_crushing = 0;  ///< N
    double vertical_drag = 0;  ///< N, drag along the normals of the ice, quadratic
    double plane_drag = 0;     ///< N, form and skin drag
    double waves = 0;          ///< N, linear damping of heave
    double joints = 0;         ///< N, bending: damped, released where floes break, or still stored
    double lifting = 0;        ///< N, against weight and buoyancy: ice that is pushed down or up
    double driving = 0;  ///< N, on ice sheets that give way and against the wind; negative where these push the ice
    double motion = 0;   ///< N, kinetic energy of the ice and of the water that moves with it
    double giving_way =
        0;            ///< N, motion of a moored structure: damped by moorings, water and thrusters, or still stored
    double rest = 0;  ///< N, what steps of finite length lose: the load less all others
};

/// All of them, `rest` last.
inline constexpr std::array all_work_shares{
    &WorkShares::ice_friction,  &WorkShares::ice_crushing, &WorkShares::hull_friction, &WorkShares::hull_crushing,
    &WorkShares::vertical_drag, &WorkShares::plane_drag,   &WorkShares::waves,         &WorkShares::joints,
    &WorkShares::lifting,       &WorkShares::driving,      &WorkShares::motion,        &WorkShares::giving_way,
    &WorkShares::rest};

/// N
inline double together(const WorkShares& shares) {
    double sum = 0;
    for (const auto share : all_work_shares) sum += shares.*share;
    return sum;
}

}  // namespace floes
