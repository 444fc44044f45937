#pragma once
// Contacts of ice with the structure from step to step, for each of its solids and the elements near that. Ice that
// crushes bears on all of a face that lies on the structure: overlap stays, so that a face borne at one point at a time
// would sink in as it slides, corner by corner. Rigid contacts gather the points at which the two are nearest or
// overlap most, as Bullet's manifolds do. Only for files inside this module.

#include <BulletCollision/CollisionShapes/btCompoundShape.h>

#include <cstdint>
#include <deque>
#include <span>
#include <vector>

#include "collision/touching_points.hpp"
#include "solver/body_motion.hpp"
#include "solver/contact_law.hpp"
#include "world/bullet_shapes.hpp"

namespace floes {

class StateArchive;

class HullContacts {
  public:
    /// The structure's solids, which stay, and its number among the bodies.
    void set_structure(std::uint32_t number, std::span<const ConvexSolid> solids, NormalLaw law);

    /// One body more; they are numbered from 0.
    void add();

    /// The element is another one or somewhere else now; contacts that it had begin anew.
    void move(std::uint32_t element, ContactStore& store);

    /// The element is not quite where its last motion led.
    void distrust(std::uint32_t element);

    /// Finds the points at which the structure touches elements. All bodies and their motions, by number.
    void find(std::span<const LooseElement> bodies, const BodyMotion* motions, ContactStore& store);

    /// Those with points, in order; a is the structure. Valid until the next find().
    std::span<const Touching> touching() const { return touching_; }

    void archive(StateArchive& state);  ///< core/state_archive.hpp

  private:
    /// An element and a solid.
    struct Pair {
        std::int32_t points = -1;  ///< in the store; -1: they are away from each other
        double due = 0;            ///< of the element's way, before which they are apart, m
    };

    std::span<Pair> pairs_of(std::uint32_t element) {
        return {pairs_.data() + element * solids_.size(), solids_.size()};
    }
    static void drop(Pair& pair, ContactStore& store);
    double way_of_structure(const BodyMotion& motion);
    void look_round(std::uint32_t element, const IceShape& shape, const BodyMotion& motion, const BodyMotion& structure,
                    ContactStore& store);
    double touch(Pair& pair, const SolidShape& solid, const IceShape& shape, const btTransform& beside,
                 const BodyMotion& motion, const BodyMotion& structure, ContactStore& store) const;

    std::deque<SolidShape> solids_;  ///< Bullet holds their addresses
    btCompoundShape whole_;          ///< of these
    double reach_ = 0;               ///< of points on the structure, m
    std::uint32_t structure_ = 0;
    NormalLaw law_ = NormalLaw::rigid;
    std::vector<double> way_;  ///< of elements relative to the structure, turning included, at most, m
    std::vector<double> due_;  ///< the least of an element's pairs
    std::vector<Pair> pairs_;  ///< by element, then solid
    btTransform last_ = btTransform::getIdentity();  ///< of the structure in the last find()
    std::vector<Touching> touching_;
};

}  // namespace floes
