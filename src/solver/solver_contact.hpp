#pragma once
// What a solve is told about contacts, and what it tells back.

#include <array>
#include <cstdint>

namespace floes {

/// One point of a contact of which at least one body moves: what the narrow phase says, and after a solve what was
/// exerted. World axes, SI units.
struct SolverContact {
    std::uint32_t a = 0;
    std::uint32_t b = 0;
    std::array<double, 3> on_a{};
    std::array<double, 3> on_b{};
    std::array<double, 3> normal{};  ///< unit, from b to a
    double distance = 0;             ///< along the normal, negative when the bodies overlap
    double friction = 0;             ///< Coulomb coefficient
    double impulse = 0;              ///< N s, of the normal: in, the value to start from; out, what was exerted on a
    /// Unit vector of the friction impulse. In: of the one to start from, cone only. With the cone zero where there is
    /// none.
    std::array<double, 3> slide{};
    double friction_impulse = 0;  ///< N s, exerted on a along slide; in and out likewise
    /// m², of a crushing contact: the area that crushes, in place of that of two boxes; below 0: that of the boxes.
    double section = -1;
    double section_growth = 0;  ///< m, what it gains per depth
    int solid = -1;             ///< of a structure's solids, which one it is at; -1: at none
};

}  // namespace floes
