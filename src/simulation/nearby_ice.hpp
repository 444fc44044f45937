#pragma once
// How much ice lies round the structure, how high and deep, and how much goes astern of it.
//
// Concentration: the area of ice, seen from above, in a box round the hull over that of the water there. In the
// structure's axes the box goes from the aft end of its waterline to a breadth of it ahead of the forward end, and a
// breadth to either side of it. Of the box counts what lies between the ice sheets or walls, less what the hull cuts
// out of the water there. Ice whose middle is more than its thickness below the water does not count: it lies below the
// hull, or below other ice that does. The highest and the deepest point are of all elements in the box, of [ice]'s
// thickness. Looked at every `steps_a_look` steps of the run.
//
// Astern of the structure is what lies behind the line across the tow through the aft end of its waterline, over the
// whole width of the field. Areas count by elements, so that pieces of a broken floe go by themselves; floes by the
// middle of all their elements.

#include <span>
#include <vector>

#include "core/vector.hpp"
#include "ice/ice_field.hpp"
#include "scenario/scenario.hpp"
#include "shapes/polygon.hpp"
#include "simulation/sheets.hpp"
#include "world/state.hpp"

namespace floes {

/// An amount of ice.
struct IceAmount {
    double area = 0;   ///< m²
    double floes = 0;  ///< a whole number

    friend IceAmount operator-(const IceAmount& a, const IceAmount& b) { return {a.area - b.area, a.floes - b.floes}; }
};

class NearbyIce {
  public:
    NearbyIce(const Scenario& scenario, const Channel& channel);

    /// After the step with this number, from 0. `states`: of all elements; `sheets`: of those that give way. Allocates
    /// nothing but at its first call.
    void look(int step, const IceField& ice, std::span<const BodyState> states, std::span<const SheetMotion> sheets,
              const StructurePose& at);

    /// At the last look, from 0; above 1 where ice lies on ice.
    double concentration() const { return concentration_; }

    /// At the last look: the highest point above the water and the deepest below it, m; 0 without ice.
    double height() const { return height_; }
    double draught() const { return draught_; }

    /// Ice astern of the structure that is there.
    IceAmount astern(const IceField& ice, std::span<const BodyState> states, const StructurePose& at) const;

    void archive(StateArchive& state);  ///< core/state_archive.hpp

  private:
    /// Refills box_ with the part of the box between the sheets, and its edges.
    void lay_box(std::span<const SheetMotion> sheets, const StructurePose& at);
    void cut_to(const HalfPlane& half);
    double waterplane_between_walls(const Shape& shape);
    double area_in_box(const CutElement& element, const BodyState& state);
    void reach_to(const CutElement& element, const BodyState& state);

    std::vector<IceSheet> sheets_;
    std::vector<HalfPlane> walls_;   ///< the field between them; none: no walls
    std::vector<Vec3> waterline_;    ///< corners of the hull's, in its axes
    Vec3 low_, high_;                ///< of the box, likewise
    double waterplane_;              ///< m²
    double thickness_;               ///< m
    std::vector<HalfPlane> within_;  ///< between sheets and walls, and in the box
    Outline box_, seen_, spare_;     ///< the box, and the element that is looked at
    double concentration_ = 0, height_ = 0, draught_ = 0;
};

}  // namespace floes
