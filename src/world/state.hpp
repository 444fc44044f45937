#pragma once
// What the bodies and joints of a World are called, and what it tells: motion of a body, reaction of a joint, force at
// a contact.

#include <compare>
#include <cstddef>
#include <cstdint>

#include "core/state_archive.hpp"
#include "core/vector.hpp"

namespace floes {

/// An index, from 0, of the kind named by Tag: those of bodies and of joints cannot be mixed up.
template <class Tag>
class Id {
  public:
    constexpr explicit Id(std::size_t index) : value_(static_cast<std::uint32_t>(index)) {}

    constexpr std::size_t index() const { return value_; }
    void archive(StateArchive& state) { state(value_); }
    friend constexpr auto operator<=>(Id, Id) = default;

  private:
    std::uint32_t value_;
};

using BodyId = Id<struct BodyTag>;    ///< in order of creation in a World
using JointId = Id<struct JointTag>;  ///< in order of creation in a World; used again after removal by put_in alone

/// Motion of a body at the end of the last step, in world axes.
struct BodyState {
    Vec3 position = Vec3::Zero();          ///< of the centre of mass, m
    Mat3 rotation = Mat3::Identity();      ///< body -> world
    Vec3 velocity = Vec3::Zero();          ///< of the centre of mass, m/s
    Vec3 angular_velocity = Vec3::Zero();  ///< rad/s
};

/// What a joint exerted on body a during the last step, at the pivot and in the joint's frame of that step's solve
/// (x the face normal from a to b, y up, z = x × y). On b it exerted the opposite. N and N m.
struct JointReaction {
    double axial = 0;             ///< F_x: tension positive, compression negative
    double shear_vertical = 0;    ///< F_y: positive when b lifts a
    double shear_in_plane = 0;    ///< F_z
    double torsion = 0;           ///< M_x
    double in_plane_bending = 0;  ///< M_y
    double bending = 0;           ///< M_z, about the horizontal axis in the face: positive when sagging (tension below)

    Vec3 force() const { return {axial, shear_vertical, shear_in_plane}; }
    Vec3 moment() const { return {torsion, in_plane_bending, bending}; }
};

/// Where two bodies touch, and what acted there in the last step.
struct ContactForce {
    BodyId a;
    BodyId b;
    Vec3 point = Vec3::Zero();     ///< between the two surfaces, m
    Vec3 normal = Vec3::Zero();    ///< normal force on a, N; on b the opposite
    Vec3 friction = Vec3::Zero();  ///< likewise
    int solid = -1;                ///< of the structure's solids, which one it is at; -1: at none
};

}  // namespace floes
