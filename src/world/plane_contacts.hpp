#pragma once
// Contacts of ice with half spaces, the sea bed and walls: each corner of an element that is near a plane or behind it
// is a point at which they touch, so they are exact, and the same points from step to step. Only for files inside this
// module.

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "collision/touching_points.hpp"
#include "solver/body_motion.hpp"
#include "world/bullet_shapes.hpp"

namespace floes {

class StateArchive;

class PlaneContacts {
  public:
    /// Its number among the bodies, above those of planes before it, a point of the plane, m, and the unit normal
    /// towards the ice.
    void add_plane(std::uint32_t number, const Triple& origin, const Triple& normal);

    bool is_plane(std::uint32_t body) const;

    /// Bodies are numbered from 0; for one without a shape nothing is looked for. The shape must stay where it is.
    void add(const IceShape* shape);

    /// Another one under that number.
    void put_in(std::uint32_t element, const IceShape* shape, ContactStore& store);

    /// The element is somewhere else now; contacts that it had begin anew.
    void move(std::uint32_t element, ContactStore& store);

    /// Finds the points at which elements touch planes. motions: of all bodies, by number.
    void find(const BodyMotion* motions, ContactStore& store);

    /// Those with points, in order; a is the plane, and `solid` counts an element's corners four by four. Valid until
    /// the next find().
    std::span<const Touching> touching() const { return touching_; }

    /// Everything that the next steps depend on, saved or set (core/state_archive.hpp). `shapes`: of all bodies.
    void archive(StateArchive& state, std::span<IceShape* const> shapes);

  private:
    /// Places in the store of an element's corners, by fours; -1: they are away from the plane.
    using Places = std::array<std::int32_t, 2 * most_corners / 4>;

    struct Plane {
        std::uint32_t number;
        Triple origin;
        Triple normal;
        std::vector<Places> places;  ///< by element
    };

    static void drop(Places& places, ContactStore& store);
    void look(Plane& plane, std::uint32_t element, const BodyMotion& motion, ContactStore& store);

    std::vector<Plane> planes_;
    std::vector<const IceShape*> shapes_;
    std::vector<double> radius_;
    std::vector<Touching> touching_;
};

}  // namespace floes
