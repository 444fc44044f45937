#include "simulation/cantilever.hpp"

#include <cmath>
#include <optional>
#include <vector>

#include <fmt/format.h>

#include "core/contract.hpp"
#include "core/error.hpp"
#include "ice/failure.hpp"
#include "ice/joint_stress.hpp"
#include "ice/scenario_world.hpp"
#include "simulation/plate_tests.hpp"
#include "theory/plate.hpp"
#include "water/water_model.hpp"

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
            elements_.push_back(world_.add_element({.corners = corners_of(half_extents.x(), half_extents.z()),
                                                    .half_thickness = half_extents.y(),
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

namespace {

constexpr double largest_load = 6.0;  // in units of the predicted one

Scenario beam_scenario(Scenario scenario, bool floating) {
    if (!floating) scenario.general.gravity = 0;
    scenario.water.flow = WaterFlow::still;
    return scenario;
}

class Beam {
  public:
    Beam(const Scenario& scenario, const BeamTest& test)
        : test_(test),
          side_(scenario.floe.element),
          size_(size_of_ice(scenario)),
          mass_(scenario.floe.element_mass(scenario.ice) * (1 + scenario.water.isotropic_mass())),
          time_step_(scenario.general.time_step),
          thresholds_(make_thresholds(scenario.floe, scenario.material())),
          world_(scenario_world(scenario)),
          water_(scenario.water, scenario.general.gravity, {side_, scenario.floe.thickness},
                 scenario.floe.element_mass(scenario.ice), 0, 0) {
        const double height = test.floating ? scenario.floe.floating_height(scenario.ice, scenario.water.density) : 0;
        const Vec3 half_extents(side_ / 2, scenario.floe.thickness / 2, side_ / 2);
        // The clamp acts only through its joint: its body is placed aside, where nothing touches it.
        BodyId last = world_.add_fixed_box({.half_extents = half_extents, .pose = {.position = {-10 * side_, 0, 0}}});
        for (int i = 0; i < test.elements; ++i) {
            elements_.push_back(world_.add_element({.corners = corners_of(half_extents.x(), half_extents.z()),
                                                    .half_thickness = half_extents.y(),
                                                    .mass = mass_,
                                                    .pose = {.position = {side_ * (i + 0.5), height, 0}},
                                                    .piece = 0}));
            // A joint to a body that cannot move has half the A = J M⁻¹ Jᵀ: twice Σ makes the clamp as stiff as the
            // rest.
            joints_.push_back(world_.add_joint({.a = last,
                                                .b = elements_.back(),
                                                .pivot = {side_ * i, height, 0},
                                                .cfm = scenario.joint.cfm * (i == 0 ? 2 : 1),
                                                .erp = scenario.joint.erp}));
            last = elements_.back();
        }
    }

    /// Brings the beam to rest under the load, N; false if it does not come to rest.
    bool settle_under(double load) {
        const double start = side_ * (test_.elements - 0.5);
        return settle([&] { advance(load); },
                      [&] { return (world_.state(elements_.back()).position - Vec3(start, 0, 0)).norm(); }, 0.0, size_)
            .has_value();
    }

    /// The joint nearest to the clamp of those that fail at rest: its index, from 0 at the clamp.
    std::optional<std::pair<int, FailureMode>> failing_joint() const {
        for (std::size_t j = 0; j < joints_.size(); ++j) {
            if (const auto mode = failure(world_.reaction(joints_[j]), thresholds_))
                return {{static_cast<int>(j), *mode}};
        }
        return std::nullopt;
    }

  private:
    void advance(double load) {
        for (const BodyId element : elements_) {
            const BodyState body = world_.state(element);
            if (test_.floating)
                world_.apply(element,
                             water_.wrench({body.position, body.rotation, body.velocity, body.angular_velocity, 0}, 0));
            world_.apply(element, settling_drag(body, mass_, side_, time_step_));
        }
        world_.apply(elements_.back(), load_wrench(load));
        world_.step();
    }

    Wrench load_wrench(double load) const {
        const double half = side_ / 2;
        switch (test_.load) {
            case BeamLoad::bending:  // at the tip; a floating beam is lifted, because pressed down it would soon
                                     // submerge
                return test_.floating ? Wrench{{0, load, 0}, {0, 0, load * half}}
                                      : Wrench{{0, -load, 0}, {0, 0, -load * half}};
            case BeamLoad::shear:  // through the clamp's face, so that no moment acts there
                return {{0, -load, 0}, {0, 0, load * (side_ * test_.elements - half)}};
            case BeamLoad::compression:
                break;
        }
        return {{-load, 0, 0}, Vec3::Zero()};
    }

    BeamTest test_;
    double side_;
    double size_;
    double mass_;
    double time_step_;
    Thresholds thresholds_;
    World world_;
    WaterModel water_;
    std::vector<BodyId> elements_;
    std::vector<JointId> joints_;
};

/// Strength shown by a load, Pa, and its inverse: load = strength * scale.
double load_per_strength(const Scenario& scenario, BeamLoad kind, double length) {
    FLOES_EXPECTS(length > 0);
    const double b = scenario.floe.element;
    const double h = scenario.floe.thickness;
    if (kind == BeamLoad::bending) return 1 / nominal_flexural_strength(1, length, b, h);
    return scenario.joint.threshold_form == ThresholdForm::force ? b * h : b * h * h;
}

double strength_set(const Ice& ice, BeamLoad kind) {
    switch (kind) {
        case BeamLoad::bending:
            return ice.bending_strength;
        case BeamLoad::shear:
            return ice.shear_strength;
        case BeamLoad::compression:
            break;
    }
    return ice.compressive_strength;
}

}  // namespace

BeamStrength measure_beam_strength(const Scenario& scenario, const BeamTest& test) {
    if (test.elements < 1)
        throw InputError(fmt::format("A beam of {} elements cannot be tested; it needs at least 1.", test.elements));
    if (!(test.increment > 0 && test.increment <= 0.1))
        throw InputError(
            fmt::format("The load increment is {} of the predicted load; allowed is above 0 to 0.1.", test.increment));
    const double side = scenario.floe.element;
    const double set = strength_set(scenario.ice, test.load);
    const double predicted = set * load_per_strength(scenario, test.load, side * test.elements);
    Beam beam(beam_scenario(scenario, test.floating), test);
    for (int i = 1; i * test.increment <= largest_load; ++i) {
        const double load = predicted * i * test.increment;
        if (!beam.settle_under(load))
            throw InputError(
                fmt::format("The beam of {} elements did not settle under {:.4g} N; a larger Σ or more iterations may.",
                            test.elements, load));
        if (const auto failed = beam.failing_joint()) {
            const auto [joint, mode] = *failed;
            const double length = side * (test.elements - joint);
            return {mode, joint, length, load, load / load_per_strength(scenario, test.load, length), set};
        }
    }
    throw InputError(fmt::format("No joint failed up to {:.4g} N, {} times the load that the strength predicts.",
                                 predicted * largest_load, largest_load));
}

}  // namespace floes
