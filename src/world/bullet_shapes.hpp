#pragma once
// Bullet as floes sees it: its vectors, elements of ice and the solids of the structure. Only for files inside this
// module.

#include <BulletCollision/CollisionShapes/btBoxShape.h>
#include <BulletCollision/CollisionShapes/btConvexHullShape.h>
#include <BulletCollision/CollisionShapes/btConvexInternalShape.h>
#include <BulletCollision/NarrowPhaseCollision/btPersistentManifold.h>
#include <LinearMath/btTransform.h>

#include <array>
#include <optional>

#include "collision/prism.hpp"
#include "collision/solid_gap.hpp"
#include "core/vector.hpp"
#include "shapes/convex_solid.hpp"

namespace floes {

inline btVector3 to_bullet(const Vec3& v) {
    return {v.x(), v.y(), v.z()};
}

inline btTransform to_bullet(const Pose& pose) {
    const Quat q = pose.orientation.normalized();
    return btTransform(btQuaternion(q.x(), q.y(), q.z(), q.w()), to_bullet(pose.position));
}

/// Of a position, and a rotation row by row.
inline btTransform transform_of(const double* position, const double* r) {
    return btTransform(btMatrix3x3(r[0], r[1], r[2], r[3], r[4], r[5], r[6], r[7], r[8]),
                       {position[0], position[1], position[2]});
}

inline btMatrix3x3 to_bullet(const Mat3& m) {
    return {m(0, 0), m(0, 1), m(0, 2), m(1, 0), m(1, 1), m(1, 2), m(2, 0), m(2, 1), m(2, 2)};
}

inline std::array<double, 3> array_of(const btVector3& v) {
    return {v.x(), v.y(), v.z()};
}

inline std::array<double, 9> rows_of(const btMatrix3x3& m) {
    return {m[0][0], m[0][1], m[0][2], m[1][0], m[1][1], m[1][2], m[2][0], m[2][1], m[2][2]};
}

inline Vec3 from_bullet(const btVector3& v) {
    return {v.x(), v.y(), v.z()};
}

inline Mat3 from_bullet(const btMatrix3x3& m) {
    Mat3 result;
    for (int row = 0; row < 3; ++row) {
        for (int column = 0; column < 3; ++column) result(row, column) = m[row][column];
    }
    return result;
}

/// A prism that is no box. As of btBoxShape the outermost layer, the margin, is a sphere swept over a core that is
/// smaller by as much: flat faces are exact, and corners and rims are rounded by the margin.
ATTRIBUTE_ALIGNED16(class) PrismHull final : public btConvexHullShape {
  public:
    BT_DECLARE_ALIGNED_ALLOCATOR();

    /// Corners in its own x and z about the centre of mass, along principal axes; m.
    PrismHull(const Outline& corners, double half_thickness);

    /// Principal, about the centre of mass, and exact.
    void calculateLocalInertia(btScalar mass, btVector3 & inertia) const override;

  private:
    Outline corners_;
    double half_thickness_;
};

class IceShape {
  public:
    IceShape(const Outline& corners, double half_thickness);
    IceShape(const IceShape&) = delete;  // Bullet holds its address
    IceShape& operator=(const IceShape&) = delete;

    btConvexShape& convex() {
        if (box_) return *box_;
        return *hull_;
    }
    const btConvexShape& convex() const { return const_cast<IceShape*>(this)->convex(); }

    /// The same for the narrow phase of ice on ice. A box is as long as Bullet's, which rounds.
    const PrismShape& prism() const { return prism_; }

    /// The same without its margin, for the narrow phase of ice on the structure.
    const PrismCore& core() const { return core_; }

    /// A point of contact lasts while its halves are nearer than this, m.
    double reach() const { return convex().getContactBreakingThreshold(gContactBreakingThreshold); }

    /// Principal, kg m².
    btVector3 inertia(double mass) const {
        btVector3 inertia;
        convex().calculateLocalInertia(mass, inertia);
        return inertia;
    }

  private:
    std::optional<btBoxShape> box_;
    std::optional<PrismHull> hull_;
    PrismShape prism_;
    PrismCore core_;
};

/// A body as structure and planes look for it: they do for elements that move freely, and not for one without a shape.
struct LooseElement {
    const IceShape* shape = nullptr;  ///< must stay where it is
    double radius = 0;                ///< of a sphere about the centre of mass that holds it, m

    LooseElement() = default;
    explicit LooseElement(const IceShape& of)
        : shape(&of), radius(std::sqrt(dot(of.prism().half_extent, of.prism().half_extent))) {}
};

// A convex solid of the structure as a smooth shape for collision.
//
// Known to Bullet by its support function, so a contact normal on a round wall is its true normal and does not step
// from facet to facet. As with all round shapes of Bullet the outermost layer, the margin, is a sphere swept over a
// core. The core is smaller such that the wall is exact; flat ends of a round solid stand out by the margin and rims
// are rounded with it. All faces of a polyhedron are exact, and its edges rounded; one that is thinner than twice the
// margin stands out by it.

ATTRIBUTE_ALIGNED16(class) SolidShape final : public btConvexInternalShape {
  public:
    BT_DECLARE_ALIGNED_ALLOCATOR();

    /// Below this depth (with the margin of the other shape) contact is found exactly, without Bullet's EPA. In units
    /// of the World, 1 mm beside ice as thick as the paper's.
    static constexpr double margin = 1e-3;

    explicit SolidShape(const ConvexSolid& solid);

    /// In the structure.
    btTransform place() const;

    /// No point of a box at this place in the solid's axes is nearer, m; 0 or less where it may touch. The width of the
    /// gap across one plane: a face of a polyhedron, the wall of a round solid where it faces the box, or the bounds of
    /// either.
    double gap_to(const btTransform& box, const Triple& half_extent) const;

    /// As btConvexInternalShape finds them along the solid's own axes, with the margin twice.
    const Vec3& low() const {
        return low_;
    }
    const Vec3& high() const {
        return high_;
    }

    /// Without its margin, for the narrow phase of ice on the structure.
    const SolidCore& core() const {
        return core_;
    }

    btVector3 localGetSupportingVertexWithoutMargin(const btVector3& direction) const override;
    void batchedUnitVectorGetSupportingVertexWithoutMargin(const btVector3* directions, btVector3* vertices, int count)
        const override;
    /// Zero: the structure is moved, not pushed.
    void calculateLocalInertia(btScalar mass, btVector3 & inertia) const override;
    const char* getName() const override {
        return "ConvexSolid";
    }

  private:
    SolidCore core_;
    Vec3 place_;
    Vec3 low_;
    Vec3 high_;
};

}  // namespace floes
