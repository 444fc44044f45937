#include "laboratory/beam_stiffness.hpp"

#include <fmt/format.h>

#include <vector>

#include "core/error.hpp"
#include "ice/beam_joint.hpp"
#include "ice/scenario_world.hpp"
#include "laboratory/settling.hpp"
#include "theory/beam.hpp"

namespace floes {
namespace {

constexpr double steps_per_swing = 400;
constexpr int swings = 5;

class Strip {
  public:
    Strip(const Scenario& scenario, int elements, double time_step)
        : side_(scenario.floe.element),
          mass_(scenario.floe.element_mass(scenario.ice)),
          time_step_(time_step),
          world_(world(scenario, time_step)) {
        const double side = side_;
        const Vec3 half_extents(side / 2, scenario.floe.thickness / 2, side / 2);
        // The clamp acts only through its joint: its body is placed aside, where nothing touches it.
        BodyId last = world_.add_fixed_box({.half_extents = half_extents, .pose = {.position = {-10 * side, 0, 0}}});
        for (int i = 0; i < elements; ++i) {
            elements_.push_back(world_.add_element({.half_extents = half_extents,
                                                    .mass = mass_,
                                                    .pose = {.position = {side * (i + 0.5), 0, 0}},
                                                    .piece = 0}));
            const double span = i == 0 ? side / 2 : side;  // from the clamped face, then from centre to centre
            world_.add_joint({.a = last,
                              .b = elements_.back(),
                              .pivot = {side * (i + 0.5) - span / 2, 0, 0},
                              .spring = beam_joint(elastic_ice(scenario.floe, scenario.material()), side, span)});
            last = elements_.back();
        }
    }

    double depth() const { return -world_.state(elements_.back()).position.y(); }

    void settle_under(double load) {
        for (const BodyId element : elements_) {
            world_.apply(element, settling_drag(world_.state(element), mass_, side_, time_step_));
        }
        world_.apply(elements_.back(), {{0, -load, 0}, Vec3::Zero()});
        world_.step();
    }

    void swing() { world_.step(); }

  private:
    static World world(Scenario scenario, double time_step) {
        scenario.general.time_step = time_step;
        scenario.general.gravity = 0;
        scenario.water.added_mass = 0;
        return scenario_world(scenario);
    }

    double side_;
    double mass_;
    double time_step_;
    World world_;
    std::vector<BodyId> elements_;
};

/// From the first to the last time that the let-go strip passes its straight form upwards.
double swing_frequency(Strip& strip, double time_step) {
    int passed = 0;
    double first = 0;
    double last = 0;
    double before = strip.depth();
    for (int i = 1; i < static_cast<int>(steps_per_swing) * (swings + 2) && passed <= swings; ++i) {
        strip.swing();
        const double now = strip.depth();
        if (before > 0 && now <= 0) {
            last = (i - 1 + before / (before - now)) * time_step;
            if (passed++ == 0) first = last;
        }
        before = now;
    }
    if (passed < 2) throw InputError("The strip does not swing: its joints are damped too much.");
    return (passed - 1) / (last - first);
}

}  // namespace

BeamStiffness measure_beam_stiffness(const Scenario& scenario, int elements) {
    if (elements < 1)
        throw InputError(fmt::format("A beam of {} elements cannot be tested; it needs at least 1.", elements));
    if (scenario.joint.model != JointModel::beam) {
        throw InputError(
            "The stiffness of joints that follow Σ and Γ changes with the time step; take joint.model = \"beam\" and "
            "general.solver = \"direct\", or measure a sheet with floes laboratory plate.");
    }
    const double side = scenario.floe.element;
    const double stiffness = elastic_ice(scenario.floe, scenario.material()).flexural_rigidity() * side;
    const double arm = side * (elements - 0.5);
    BeamStiffness result;
    result.elastic_frequency =
        cantilever_frequency(side * elements, stiffness, scenario.floe.element_mass(scenario.ice) / side);
    const double time_step = 1 / (steps_per_swing * result.elastic_frequency);
    const double load = 1e-3 * 3 * stiffness / (arm * arm);  // bends it by a thousandth of its length
    Strip strip(scenario, elements, time_step);
    const auto rest =
        settle([&] { strip.settle_under(load); }, [&] { return strip.depth(); }, 0.0, size_of_ice(scenario));
    if (!rest) throw InputError(fmt::format("The beam of {} elements did not come to rest.", elements));
    result.deflection = *rest;
    result.elastic_deflection = cantilever_deflection(load, arm, stiffness);
    result.frequency = swing_frequency(strip, time_step);
    return result;
}

}  // namespace floes
