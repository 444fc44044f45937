#include "simulation/laboratory.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <utility>

#include "core/contract.hpp"
#include "core/error.hpp"
#include "core/units.hpp"
#include "ice/failure.hpp"
#include "ice/ice_field.hpp"
#include "ice/joint_stress.hpp"
#include "theory/plate.hpp"
#include "water/water_model.hpp"

namespace floes {

namespace {

// Waiting for rest: a laboratory test takes a reading only when further steps no longer change it.

/// Steps between two observations, and the largest number of observations.
constexpr int steps_between_looks = 25;
constexpr int most_looks = 400;

/// Calls advance() until observe() (m) changes by no more than 1e-7 of its value between two observations, twice in a
/// row, because a turning point is not rest. At 0 itself rounding is left: 1e-15 m times `size`, size_of_ice(). Returns
/// the last observation, or nothing if it never settles.
template <class Advance, class Observe>
std::optional<double> settle(Advance&& advance, Observe&& observe, double size) {
    double reading = observe();
    int quiet = 0;
    for (int look = 0; look < most_looks; ++look) {
        for (int step = 0; step < steps_between_looks; ++step) advance();
        const double before = std::exchange(reading, observe());
        if (!std::isfinite(reading)) return std::nullopt;
        quiet = std::abs(reading - before) <= 1e-7 * std::abs(reading) + 1e-15 * size ? quiet + 1 : 0;
        if (quiet == 2) return reading;
    }
    return std::nullopt;
}

/// Drag that brings a dry square element of this mass (kg) and side (m) to rest: a tenth of its momentum goes in each
/// step (s). Only the state at rest matters, and that does not depend on it.
Wrench settling_drag(const BodyState& body, double mass, double side, double time_step) {
    constexpr double loss = 0.1;
    const double moment_of_inertia = mass * side * side / 12;  // the smallest of a flat box, so that no axis gains
    return {.force = -loss * mass / time_step * body.velocity,
            .moment = -loss * moment_of_inertia / time_step * body.angular_velocity};
}

/// A row of elements along x from the clamp at 0, all of one piece. join(last, element, number) joins each to the one
/// before.
template <class Join>
std::vector<BodyId> clamped_row(World& world, const FloeShape& floe, double mass, int elements, double height,
                                const Join& join) {
    const double side = floe.element;
    const Vec3 half_extents(side / 2, floe.thickness / 2, side / 2);
    // The clamp acts only through its joint: its body is placed aside, where nothing touches it.
    BodyId last = world.add_fixed_box({.half_extents = half_extents, .pose = {.position = {-10 * side, 0, 0}}});
    std::vector<BodyId> row;
    for (int i = 0; i < elements; ++i) {
        row.push_back(world.add_element({.corners = corners_of(half_extents.x(), half_extents.z()),
                                         .half_thickness = half_extents.y(),
                                         .mass = mass,
                                         .pose = {.position = {side * (i + 0.5), height, 0}},
                                         .piece = 0}));
        join(last, row.back(), i);
        last = row.back();
    }
    return row;
}

// Only the state at rest matters: damping shortens the settling and has no effect at rest. Where it is a share of
// critical, 0.7 settles fastest.
constexpr double settling_damping = 0.7;

int elements_across(const Scenario& scenario, double sheet) {
    const double exact = sheet / scenario.floe.element;
    const double whole = std::round(exact);
    if (whole < 2 || std::abs(exact - whole) > 1e-6 * whole) {
        const double less = std::max(2.0, std::floor(exact)) * scenario.floe.element;
        const double more = std::max(2.0, std::ceil(exact)) * scenario.floe.element;
        throw InputError(fmt::format(
            "A sheet of {} m is {:.6g} elements of {} m; it must be a whole number of them, at least 2. "
            "Try {:.6g} m{}.",
            sheet, exact, scenario.floe.element, less, less < more ? fmt::format(" or {:.6g} m", more) : ""));
    }
    return static_cast<int>(whole);
}

Scenario sheet_scenario(Scenario scenario, double sheet) {
    scenario.floe.length = sheet;
    scenario.floe.breadth = sheet;
    scenario.water.flow = WaterFlow::still;
    scenario.water.heave_damping = settling_damping;
    return scenario;
}

/// The elements that carry the load, as indices within the sheet, and the corner of each that meets the centre.
struct LoadedElement {
    std::size_t index;
    Vec3 centre_arm;  ///< from the element's centre to the centre of the sheet, element axes, m
};

/// Between beams the middle of four elements lies half as far along their tangents as it is away from their centres.
std::vector<LoadedElement> loaded_elements(int across, const Scenario& scenario) {
    const auto index = [&](int i, int k) { return static_cast<std::size_t>(i + k * across); };
    const int middle = across / 2;
    if (across % 2 == 1) return {{index(middle, middle), Vec3::Zero()}};
    const double half = scenario.floe.element / (scenario.joint.model == JointModel::beam ? 4 : 2);
    return {{index(middle - 1, middle - 1), {half, 0, half}},
            {index(middle, middle - 1), {-half, 0, half}},
            {index(middle - 1, middle), {half, 0, -half}},
            {index(middle, middle), {-half, 0, -half}}};
}

class Sheet {
  public:
    Sheet(const Scenario& scenario, int across)
        : scenario_(scenario),
          world_(scenario_world(scenario)),
          ice_(world_, scenario, floes_at(scenario, std::vector<PlanarPose>(1))),
          water_(scenario.water, scenario.general.gravity, {scenario.floe.element, scenario.floe.thickness},
                 scenario.floe.element_mass(scenario.ice), 0, 0),
          loaded_(loaded_elements(across, scenario)) {}

    /// Depth of the centre of the sheet below its initial height, at rest under a total load, m.
    double settled_depth(double load) {
        const auto depth = settle([&] { advance(load); }, [&] { return checked_depth(load); }, size_of_ice(scenario_));
        if (!depth)
            throw InputError(fmt::format(
                "The sheet did not settle under {} N in {} steps; a larger Σ, a smaller load or fewer elements may.",
                load, most_looks * steps_between_looks));
        return *depth;
    }

  private:
    void advance(double load) {
        for (const IceElement& element : ice_.elements()) {
            const BodyState body = world_.state(element.body);
            world_.apply(element.body,
                         water_.wrench({body.position, body.rotation, body.velocity, body.angular_velocity, 0}, 0));
        }
        const Wrench share{.force = {0, -load / static_cast<double>(loaded_.size()), 0}};
        for (const LoadedElement& element : loaded_) world_.apply(ice_.elements()[element.index].body, share);
        world_.step();
        if (ice_.break_joints(world_, 0) > 0)
            throw InputError(fmt::format("The load of {} N breaks the sheet; try a smaller one.", load));
    }

    /// Below its freeboard the sheet is no longer a plate on a foundation.
    double checked_depth(double load) const {
        const double depth = start_height_ - centre_height();
        const double freeboard = scenario_.floe.thickness * (1 - scenario_.ice.density / scenario_.water.density);
        if (depth > freeboard)
            throw InputError(fmt::format(
                "The load of {} N sinks the middle of the sheet below its freeboard of {:.3g} m; try a smaller one.",
                load, freeboard));
        return depth;
    }

    double centre_height() const {
        double sum = 0;
        for (const LoadedElement& element : loaded_) {
            const BodyState body = world_.state(ice_.elements()[element.index].body);
            sum += (body.position + body.rotation * element.centre_arm).y();
        }
        return sum / static_cast<double>(loaded_.size());
    }

    Scenario scenario_;
    World world_;
    IceField ice_;
    WaterModel water_;
    std::vector<LoadedElement> loaded_;
    double start_height_ = centre_height();
};

double slope_through_origin(const PlateDeflection& result) {
    double product = 0;
    double square = 0;
    for (std::size_t i = 0; i < result.load.size(); ++i) {
        product += result.load[i] * result.deflection[i];
        square += result.deflection[i] * result.deflection[i];
    }
    return product / square;
}

}  // namespace

PlateTest plate_test_for(const Scenario& scenario) {
    const double size = size_of_ice(scenario);
    PlateTest test;
    test.sheet *= size;
    test.load *= size * size * size;
    return test;
}

PlateTest whole_plate_test(const Scenario& scenario) {
    PlateTest test = plate_test_for(scenario);
    // Slightly enlarged, so that rounding does not lose an element if the elements divide the sheet.
    test.sheet = std::floor(test.sheet / scenario.floe.element * (1 + 1e-9)) * scenario.floe.element;
    return test;
}

PlateDeflection measure_plate_deflection(const Scenario& scenario, const PlateTest& test) {
    if (!(test.load > 0) || test.increments < 1)
        throw InputError(fmt::format("A plate test needs a load above 0 N in at least 1 increment, not {} N in {}.",
                                     test.load, test.increments));
    const int across = elements_across(scenario, test.sheet);
    Sheet sheet(sheet_scenario(scenario, test.sheet), across);
    const double unloaded = sheet.settled_depth(0);
    PlateDeflection result;
    for (int i = 1; i <= test.increments; ++i) {
        result.load.push_back(test.load * i / test.increments);
        result.deflection.push_back(sheet.settled_depth(result.load.back()) - unloaded);
    }
    FloatingPlate plate{.thickness = scenario.floe.thickness,
                        .water_density = scenario.water.density,
                        .gravity = scenario.general.gravity};  // and the ν of the paper's plates: Σ knows none
    if (scenario.joint.model == JointModel::beam) plate.poisson_ratio = scenario.ice.poisson_ratio;
    const double loaded_area = (across % 2 == 1 ? 1 : 4) * scenario.floe.element * scenario.floe.element;
    result.slope = slope_through_origin(result);
    result.elastic_modulus = modulus_from_patch_slope(plate, result.slope, std::sqrt(loaded_area / std::numbers::pi));
    result.elastic_modulus_point = modulus_from_point_slope(plate, result.slope);
    return result;
}

namespace {

constexpr double largest_cfm = 0.9;  // above it the sweeps hardly converge
constexpr double tolerance = 0.005;  // of E, relative
constexpr int most_tests = 24;

/// Runs the plate test for values of Σ and stores the points of the curve.
class Curve {
  public:
    Curve(const Scenario& scenario, const PlateTest& test) : scenario_(scenario), test_(test) {}

    /// ln E, Pa.
    double log_modulus(double cfm) {
        scenario_.joint.cfm = cfm;
        points_.push_back(measure_curve_point(scenario_, test_));
        return std::log(points_.back().elastic_modulus);
    }

    std::vector<CurvePoint> sorted() const {
        std::vector<CurvePoint> points = points_;
        std::ranges::sort(points, {}, &CurvePoint::cfm);
        return points;
    }

  private:
    Scenario scenario_;
    PlateTest test_;
    std::vector<CurvePoint> points_;
};

[[noreturn]] void refuse_above_ceiling(const Scenario& scenario, double wanted, double ceiling) {
    throw InputError(
        fmt::format("An elastic modulus of {:.6g} MPa is above {:.4g} MPa, the largest that elements of {} m reach "
                    "with {} iterations and a time step of {} s: sweeps that have not converged leave the ice soft "
                    "however small Σ is. Allowed is less; try more iterations or larger elements, or joints without "
                    "such a limit: joint.model = \"beam\" with general.solver = \"direct\".",
                    wanted / unit::megapascal, ceiling / unit::megapascal, scenario.floe.element,
                    scenario.general.iterations, scenario.general.time_step));
}

}  // namespace

Scenario plate_scenario(const Scenario& scenario) {
    Scenario plate;
    plate.general = scenario.general;
    plate.ice = scenario.ice;
    plate.floe.thickness = scenario.floe.thickness;
    plate.floe.element = scenario.floe.element;
    plate.joint = scenario.joint;
    plate.joint.cfm = Scenario{}.joint.cfm;
    plate.water.density = scenario.water.density;
    if (plate.general.solver == SolverKind::stock)  // nothing touches; it cannot hold the default's law
        plate.contact = with_preset(plate.contact, ContactPreset::paper);
    return plate;
}

std::vector<PointPlan> curve_plans(const Scenario& scenario) {
    constexpr double tested_cfm[]{vanishing_cfm, 0.003, 0.008, 0.016, 0.03, 0.06};
    constexpr int sheet_elements = 13;
    PlateTest test = plate_test_for(scenario);
    test.sheet = sheet_elements * scenario.floe.element;
    std::vector<PointPlan> plans;
    for (const double cfm : tested_cfm) {
        plans.push_back({scenario, test});
        plans.back().scenario.joint.cfm = cfm;
    }
    return plans;
}

Scenario with_beam_joints(Scenario scenario, double elastic_modulus) {
    scenario.general.solver = SolverKind::direct;
    scenario.joint.model = JointModel::beam;
    scenario.ice.elastic_modulus = elastic_modulus;
    scenario.contact = with_preset(scenario.contact, ContactPreset::physical);  // nothing touches; the solver has it
    return scenario;
}

CurvePoint measure_curve_point(const Scenario& scenario, const PlateTest& test) {
    const PlateDeflection result = measure_plate_deflection(scenario, test);
    return {.sheet = test.sheet,
            .element = scenario.floe.element,
            .thickness = scenario.floe.thickness,
            .time_step = scenario.general.time_step,
            .erp = scenario.joint.erp,
            .iterations = scenario.general.iterations,
            .cfm = scenario.joint.cfm,
            .slope = result.slope,
            .elastic_modulus = result.elastic_modulus,
            .elastic_modulus_point = result.elastic_modulus_point,
            .model = scenario.joint.model,
            .set_modulus = scenario.ice.elastic_modulus};
}

Calibration calibrate_cfm(const Scenario& scenario, const PlateTest& test, double elastic_modulus) {
    if (!(elastic_modulus > 0 && std::isfinite(elastic_modulus)))
        throw InputError(fmt::format("The requested elastic modulus is {} Pa; it must be above 0.", elastic_modulus));
    if (scenario.joint.model != JointModel::cfm)
        throw InputError(
            "Joints of the model beam have the elastic modulus that they are given; there is no Σ to find.");
    Curve curve(scenario, test);
    const double wanted = std::log(elastic_modulus);
    const double ceiling = curve.log_modulus(vanishing_cfm);
    if (wanted > ceiling) refuse_above_ceiling(scenario, elastic_modulus, std::exp(ceiling));

    // In ln Σ and ln E the curve is flat, then falls with slope -1. Walk down to a bracket, then regula falsi
    // (Illinois) inside it: E falls with Σ, so the bracket always holds the answer.
    double low = std::log(vanishing_cfm);
    double low_excess = ceiling - wanted;
    double high = std::log(1e-3);
    double high_excess = curve.log_modulus(std::exp(high)) - wanted;
    while (high_excess > 0) {
        if (high >= std::log(largest_cfm))
            throw InputError(
                fmt::format("An elastic modulus of {:.6g} MPa needs Σ above {}, where the sweeps do not converge; try "
                            "a larger modulus, smaller elements or a larger time step.",
                            elastic_modulus / unit::megapascal, largest_cfm));
        low = high;
        low_excess = high_excess;
        high = std::min(std::log(largest_cfm), high + std::max(0.7, high_excess));
        high_excess = curve.log_modulus(std::exp(high)) - wanted;
    }
    for (int tests = 0; tests < most_tests; ++tests) {
        const double middle = (low * high_excess - high * low_excess) / (high_excess - low_excess);
        const double excess = curve.log_modulus(std::exp(middle)) - wanted;
        if (std::abs(excess) <= tolerance) return {std::exp(middle), std::exp(ceiling), curve.sorted()};
        if (excess > 0) {
            low = middle;
            low_excess = excess;
            high_excess /= 2;
        } else {
            high = middle;
            high_excess = excess;
            low_excess /= 2;
        }
    }
    throw InputError(fmt::format("No Σ was found that gives {:.6g} MPa; the curve is not smooth with these iterations.",
                                 elastic_modulus / unit::megapascal));
}

namespace {

/// Joint i of a clamped_row() with beam joints: from the clamped face to the first element's centre, then from centre
/// to centre, in the middle of each span.
JointDefinition clamped_beam(const Scenario& scenario, BodyId last, BodyId element, int i, double height) {
    const double side = scenario.floe.element;
    const double span = i == 0 ? side / 2 : side;
    return {.a = last,
            .b = element,
            .pivot = {side * (i + 0.5) - span / 2, height, 0},
            .spring = beam_joint(elastic_ice(scenario.floe, scenario.material()), side, span)};
}

constexpr double steps_per_swing = 400;
constexpr int swings = 5;

class Strip {
  public:
    Strip(const Scenario& scenario, int elements, double time_step)
        : side_(scenario.floe.element),
          mass_(scenario.floe.element_mass(scenario.ice)),
          time_step_(time_step),
          world_(world(scenario, time_step)) {
        const auto join = [&](BodyId last, BodyId element, int i) {
            world_.add_joint(clamped_beam(scenario, last, element, i, 0));
        };
        elements_ = clamped_row(world_, scenario.floe, mass_, elements, 0, join);
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
    const auto rest = settle([&] { strip.settle_under(load); }, [&] { return strip.depth(); }, size_of_ice(scenario));
    if (!rest) throw InputError(fmt::format("The beam of {} elements did not come to rest.", elements));
    result.deflection = *rest;
    result.elastic_deflection = cantilever_deflection(load, arm, stiffness);
    result.frequency = swing_frequency(strip, time_step);
    return result;
}

namespace {

constexpr double largest_load = 10.0;  // in units of the predicted one: soft beams that float bear several times that

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
          joint_(scenario.joint),
          strength_(joint_strength(scenario.floe, scenario.material(), side_, side_)),
          world_(scenario_world(scenario)),
          water_(scenario.water, scenario.general.gravity, {side_, scenario.floe.thickness},
                 scenario.floe.element_mass(scenario.ice), 0, 0) {
        const double height = test.floating ? scenario.floe.floating_height(scenario.ice, scenario.water.density) : 0;
        // A joint to a body that cannot move has half the A = J M⁻¹ Jᵀ: twice Σ makes the clamp as stiff as the rest.
        const auto join = [&](BodyId last, BodyId element, int i) {
            joints_.push_back(world_.add_joint(joint_.model == JointModel::beam
                                                   ? clamped_beam(scenario, last, element, i, height)
                                                   : JointDefinition{.a = last,
                                                                     .b = element,
                                                                     .pivot = {side_ * i, height, 0},
                                                                     .cfm = joint_.cfm * (i == 0 ? 2 : 1),
                                                                     .erp = joint_.erp}));
        };
        elements_ = clamped_row(world_, scenario.floe, mass_, test.elements, height, join);
    }

    /// Brings the beam to rest under the load, N; false if it does not come to rest.
    bool settle_under(double load) {
        const double start = side_ * (test_.elements - 0.5);
        return settle([&] { advance(load); },
                      [&] { return (world_.state(elements_.back()).position - Vec3(start, 0, 0)).norm(); }, size_)
            .has_value();
    }

    /// The joint nearest to the clamp of those that fail at rest: its index, from 0 at the clamp.
    std::optional<std::pair<int, FailureMode>> failing_joint() const {
        for (std::size_t j = 0; j < joints_.size(); ++j) {
            JointReaction reaction = world_.reaction(joints_[j]);
            // The beam joint of the clamp is in the middle of its span; the ice fails at the clamped face.
            if (j == 0 && joint_.model == JointModel::beam) reaction.bending += side_ / 4 * reaction.shear_vertical;
            if (const auto mode = failure_of(reaction)) return {{static_cast<int>(j), *mode}};
        }
        return std::nullopt;
    }

  private:
    std::optional<FailureMode> failure_of(const JointReaction& reaction) const {
        if (!joint_.fails_by_stress()) return failure(reaction, strength_.thresholds);
        const Utilisation used = utilisation({.reaction = reaction}, strength_.section, strength_.thresholds);
        return used.share > 1 ? std::optional(used.mode) : std::nullopt;
    }

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
    Joint joint_;
    JointStrength strength_;
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
    if (scenario.joint.model == JointModel::cfm && !(scenario.joint.cfm >= 0 && scenario.joint.cfm < 0.5))
        throw InputError(
            fmt::format("A beam of Σ = {:g} cannot be tested; allowed is 0 to below 0.5, because the clamp takes twice "
                        "as much, which must be below 1.",
                        scenario.joint.cfm));
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
