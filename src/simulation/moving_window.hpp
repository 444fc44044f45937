#pragma once
// Which floes of a field without end are computed: those round the structure. Floes farther ahead rest, fixed to
// whatever touches them, as ice that is held from ahead; floes farther behind are taken out of the world. The window
// moves with the structure in strides of a quarter of a floe, of level ice of two elements, and the field is laid part
// after part as it comes there. It never moves back with a structure that swings on its moorings: what has left is
// gone, and ice that rests anew would have to be ice that never moved. Nothing here depends on how long the run will
// be.

#include <cstddef>
#include <span>
#include <vector>

#include "ice/ice_field.hpp"
#include "scenario/floes.hpp"
#include "scenario/scenario.hpp"
#include "world/world.hpp"

namespace floes {

class MovingWindow {
  public:
    /// floes: those laid already; ahead: where others come from.
    MovingWindow(const Scenario& scenario, const FloeSet& floes, IceAhead ahead);

    /// Moves with the structure's axis, now at x = `structure_x` m. Whether it has come a stride farther than ever.
    bool moves_to(double structure_x);

    /// Whether a structure with its axis there may touch ice that is gone.
    bool has_left(double structure_x) const { return structure_x - least_ < first(); }

    double first() const { return at_ - behind_; }  ///< x of its edge behind, m
    double last() const { return at_ + ahead_; }    ///< x of its edge ahead, m

    /// The next part of the field, if what is laid does not reach far enough beyond the edge ahead; empty otherwise.
    FieldPart next_part();

    /// What lies at each place of the ice (IceField::enter).
    std::vector<SingleFloe>& places() { return places_; }
    const std::vector<SingleFloe>& places() const { return places_; }

    /// Everything that the next steps depend on, saved or set (core/state_archive.hpp), with the ice already so. The
    /// parts are laid again, as they were, and the ice is told what is at its places.
    void archive(StateArchive& state, IceField& ice);

  private:
    void lay_again(IceField& ice);

    double ahead_, behind_;  // m
    double stride_;          // m; shorter ones would lay the solver out anew more often
    double least_;           // m from the structure's axis to the edge behind, at least
    double reserve_;         // m of ice at rest ahead of the window, at least
    double at_;              // largest x of the structure's axis so far, in whole strides, m
    IceAhead ice_;
    std::vector<SingleFloe> places_;
};

// Floes that nothing has reached yet, and that are not computed (key field.wake_radius_m).
//
// A floe sleeps where it lies at rest, beyond the wake radius R from the structure's axis. It wakes, for good, when the
// axis comes within R of its middle or something that moves touches it. What is left out is the drag of the flow out
// there, V a²/r² at most V (a/R)²: while the structure comes nearer along a line through the floe it would have moved
// it by less than ∫ a²/r² dr = a²/R, abeam by less than π a²/R.

class SleepingFloes {
  public:
    /// All awake. wake_radius in m; 0: they stay so.
    SleepingFloes(double wake_radius, const std::vector<IceElement>& elements);

    /// To be called with all awake: lays the floes down that do not move at all (states of all elements) and lie beyond
    /// the radius.
    void lay_down(World& world, std::span<const BodyState> states, const StructurePose& structure);

    /// Wakes whom the structure's axis is near enough now, and whom something touched in the world's last step.
    void wake(World& world, const StructurePose& structure);

    void wake_all(World& world);

    /// In a field without end (moving_window.hpp), the floe at this place of the ice, at rest in these states of all
    /// elements, is laid down, and waits for rouse() whatever touches it; it may be new there.
    void rest(World& world, const IceField& ice, int place, std::span<const BodyState> states);
    void rouse(World& world, int place) { set_asleep(world, floes_[static_cast<std::size_t>(place)], false); }
    void leave(int place) { floes_[static_cast<std::size_t>(place)].there = false; }
    bool rests(int place) const { return floes_[static_cast<std::size_t>(place)].asleep; }
    double middle_x(int place) const { return floes_[static_cast<std::size_t>(place)].middle.x(); }  ///< when laid, m
    int resting() const { return static_cast<int>(sleepers_); }

    void list_awake();

    /// Indices of awake elements. The same place of all floes side by side: mostly the same edges are exposed there.
    const std::vector<std::size_t>& awake_elements() const { return awake_elements_; }

    void archive(StateArchive& state);  ///< core/state_archive.hpp

  private:
    struct FloeElements {
        std::vector<std::size_t> indices;
        Vec3 middle = Vec3::Zero();
        bool asleep = false;
        bool there = true;
    };

    static Vec3 middle_of(const FloeElements& floe, std::span<const BodyState> states);
    bool reached(const FloeElements& floe, const StructurePose& structure) const;
    void set_asleep(World& world, FloeElements& floe, bool asleep);
    void add(std::size_t element, const IceElement& of);

    double wake_radius_;
    std::vector<BodyId> body_;  ///< by element
    std::vector<FloeElements> floes_;
    std::vector<std::size_t> floe_of_body_;
    std::size_t sleepers_ = 0;
    std::vector<std::size_t> awake_elements_;
};

}  // namespace floes
