#pragma once
// Which edges of floes lie in the lee of other ice, and in that of which (EdgeShelter, water/water_model.hpp).
//
// The ice ahead of an edge is the first that a ray meets which leaves the middle of the edge along its outward normal,
// seen from above: form drag is that of the flow along this normal, whatever flows past the edge. Other floes count,
// other elements of the edge's own floe, as across an open crack, and the ice sheets; not the structure, round which
// the water flows in its own way. With h the depth at which both are in the water, over that of the edge, the shelter
// is
//
//     S_c² = 1 - h exp(-D / (n H))        n = water.shelter_draughts
//
// of the ice for which it is least; h = 1 for floes of one thickness side by side, 0 for floes that lie on each other.
// Beyond the distance where this is 0.99 no ice shelters.
//
// Who is ahead of whom is looked up in every tenth step of the run, when floes wake or a field without end moves on,
// and of a floe that breaks at once. How that ice moves is that of each step. So it follows from the states of the run
// alone.

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "ice/ice_field.hpp"
#include "scenario/floes.hpp"
#include "scenario/scenario.hpp"
#include "simulation/moving_window.hpp"
#include "simulation/sheets.hpp"
#include "water/water_model.hpp"
#include "world/state.hpp"

namespace floes {

class Lee {
  public:
    Lee(const Scenario& scenario, const Channel& channel, const FloeSet& floes, const IceField& ice);

    /// Anew for the floes that are at the places of the ice now.
    void measure(const FloeSet& floes, const IceField& ice);

    /// Who is ahead of whom is to be looked up in the coming step.
    void distrust() { due_ = true; }

    /// Before a step: how the ice sheets are, and who is ahead of whom, if that is due. states: of all elements.
    void follow(int step, const IceField& ice, std::span<const BodyState> states,
                const std::vector<SheetMotion>& sheets, const SleepingFloes& sleeping);

    /// Looks ahead of the edges of the floe at this place, which has new ones.
    void look_from(int place, const IceField& ice, std::span<const BodyState> states);

    /// By edge, of those exposed; valid until the next call. Empty: nothing shelters.
    std::span<const EdgeShelter> of(std::size_t element, const IceField& ice, std::span<const BodyState> states);

    void archive(StateArchive& state);  ///< core/state_archive.hpp

  private:
    /// An element or an ice sheet.
    struct Body {
        std::size_t first_edge = 0;
        std::size_t edges = 0;
        double radius = 0;          ///< m
        double half_thickness = 0;  ///< m
        double draught = 0;         ///< of its floe, m
    };
    struct PlanEdge {
        Corner middle, normal;  ///< in the body's own axes
    };
    struct Ahead {
        std::int32_t body = -1;  ///< -1: none
        double open = 1;         ///< S_c
    };
    /// Where a body was at the last look.
    struct Seen {
        double x = 0, z = 0;
        std::array<double, 4> into{};  ///< a level vector (x, z) in its own axes, row by row
        double radius = -1;            ///< m; negative: it stands too steep to have a lee
        double low = 0, high = 0;      ///< heights between which it is in the water, m
    };
    struct Circle {
        double x = 0, z = 0, radius = 0;  // m
    };
    struct Ray;

    bool shelters() const { return draughts_ > 0; }
    double reach(const Body& body) const;
    void add_body(const Outline& corners, double thickness, double draught);
    Seen seen(std::size_t body, const BodyState& state) const;
    void see(int place, const IceField& ice, std::span<const BodyState> states);
    void look(int place, const IceField& ice, std::span<const BodyState> states);
    void find_near(int place, bool itself, double reach);
    Ahead ahead_of(std::size_t element, std::size_t edge, const IceField& ice, const BodyState& state) const;
    void meet(Ray& ray, std::size_t body) const;

    double draughts_;
    double water_density_;  ///< kg/m³
    std::vector<IceSheet> sheets_;
    std::vector<BodyState> sheet_states_;
    std::vector<Body> bodies_;        ///< by element; then the ice sheets
    std::vector<PlanEdge> edges_;     ///< of all bodies
    std::vector<Ahead> ahead_;        ///< likewise
    std::vector<Seen> seen_;          ///< by body
    std::vector<Circle> circles_;     ///< round each place's floe, at the last look
    std::vector<std::uint8_t> bays_;  ///< by place: whether the floe's outline bends inwards
    std::vector<int> order_, near_;   ///< places: those with floes, rising by x; those near the one that is looked from
    double largest_ = 0;              ///< radius of a circle, m
    std::vector<EdgeShelter> found_;
    bool due_ = true;
};

}  // namespace floes
