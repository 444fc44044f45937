#pragma once
// Water that moves with a flat body: its added mass, by direction. The body's own axes, y normal to the ice.
//
// The water takes part in motion along the normal, u(x, z) = v_y + ω_z x - ω_x z, by its moments over the body; in
// motion within the plane as a mass, and in turning about the normal. Its momentum and its moment about the body's
// centre are
//
//   p = (m_p v_x, m v_y - m_z ω_x + m_x ω_z, m_p v_z)
//   l = (-m_z v_y + m_zz ω_x - m_xz ω_z, I_y ω_y, m_x v_y - m_xz ω_x + m_xx ω_z)
//
// and the body with its water obeys Kirchhoff's equations (Lamb, Hydrodynamics, art. 124): what the water exerts
// besides is -ω x p, and about the centre -(ω x l + v x p). So its energy (v·p + ω·l)/2 is inertia, not drag.

namespace floes {

struct CarriedWater {
    double in_plane = 0;  ///< m_p, kg
    double yaw = 0;       ///< I_y, kg m²
    double normal = 0;    ///< m, kg
    double x = 0;         ///< m_x, kg m; |x|, |z| at most `normal` times half the side
    double z = 0;         ///< m_z, kg m
    double xx = 0;        ///< m_xx, kg m²
    double xz = 0;        ///< m_xz, kg m²
    double zz = 0;        ///< m_zz, kg m²

    friend bool operator==(const CarriedWater&, const CarriedWater&) = default;
};

/// Where its numbers lie for the kernels: as above, then the inverse of the inertia of body and water together.
namespace carried_field {
inline constexpr int in_plane = 0;
inline constexpr int yaw = 1;
inline constexpr int normal = 2;
inline constexpr int x = 3;
inline constexpr int z = 4;
inline constexpr int xx = 5;
inline constexpr int xz = 6;
inline constexpr int zz = 7;
inline constexpr int inverse_in_plane = 8;  ///< of motion along x and z, 1/kg
inline constexpr int inverse_yaw = 9;
inline constexpr int inverse_out = 10;  ///< of {v_y, ω_x, ω_z}, symmetric, its rows from the diagonal on
inline constexpr int ice = 16;          ///< principal moments of inertia of the body alone, x y z
inline constexpr int count = 19;
}  // namespace carried_field

}  // namespace floes
