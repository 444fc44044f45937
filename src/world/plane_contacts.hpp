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
    /// Before add() of it as a body: its number, a point of the plane, m, and the unit normal towards the ice.
    void add_plane(std::uint32_t number, const Triple& origin, const Triple& normal);

    bool is_plane(std::uint32_t body) const;

    /// One body more; they are numbered from 0.
    void add();

    /// The element is another one or somewhere else now; contacts that it had begin anew.
    void move(std::uint32_t element, ContactStore& store);

    /// Finds the points at which elements touch planes. All bodies and their motions, by number.
    void find(std::span<const LooseElement> bodies, const BodyMotion* motions, ContactStore& store);

    /// Those with points, in order; a is the plane, and `solid` counts an element's corners four by four. Valid until
    /// the next find().
    std::span<const Touching> touching() const { return touching_; }

    void archive(StateArchive& state);  ///< core/state_archive.hpp

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
    void look(Plane& plane, std::uint32_t element, const IceShape& shape, const BodyMotion& motion,
              ContactStore& store);

    std::vector<Plane> planes_;
    std::vector<Touching> touching_;
};

}  // namespace floes
