#pragma once
// Floes that nothing has reached yet, and that are not computed (key field.wake_radius_m).
//
// A floe sleeps where it lies at rest, beyond the wake radius R from the structure's axis. It wakes, for good, when the
// axis comes within R of its middle or something that moves touches it. What is left out is the drag of the flow out
// there, V a²/r² at most V (a/R)²: while the structure comes nearer along a line through the floe it would have moved
// it by less than ∫ a²/r² dr = a²/R, abeam by less than π a²/R.

#include <cstddef>
#include <span>
#include <vector>

#include "ice/ice_field.hpp"
#include "world/world.hpp"

namespace floes {

class SleepingFloes {
  public:
    /// All awake. wake_radius in m; 0: they stay so.
    SleepingFloes(double wake_radius, const std::vector<IceElement>& elements);

    /// To be called with all awake: lays the floes down that do not move at all (states of all elements) and lie beyond
    /// the radius.
    void lay_down(World& world, std::span<const BodyState> states, const PlanarPose& structure);

    /// Wakes whom the structure's axis is near enough now, and whom something touched in the world's last step.
    void wake(World& world, const PlanarPose& structure);

    void wake_all(World& world);

    /// Of a field without end (moving_window.hpp). The floe at this place of the ice, at rest in these states of all
    /// elements, is laid down, and waits for rouse() whatever touches it; it may be new there.
    void rest(World& world, const IceField& ice, int place, std::span<const BodyState> states);
    void rouse(World& world, int place) { set_asleep(world, floes_[static_cast<std::size_t>(place)], false); }
    void leave(int place);
    bool rests(int place) const { return floes_[static_cast<std::size_t>(place)].asleep; }
    double middle_x(int place) const { return floes_[static_cast<std::size_t>(place)].middle.x(); }  ///< when laid, m
    int resting() const { return static_cast<int>(sleepers_); }

    void list_awake();

    /// Indices of awake elements. The same place of all floes side by side: mostly the same edges are exposed there.
    const std::vector<std::size_t>& awake_elements() const { return awake_elements_; }

  private:
    struct FloeElements {
        std::vector<std::size_t> indices;
        Vec3 middle = Vec3::Zero();
        bool asleep = false;
        bool there = true;
    };

    static Vec3 middle_of(const FloeElements& floe, std::span<const BodyState> states);
    bool reached(const FloeElements& floe, const PlanarPose& structure) const;
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
