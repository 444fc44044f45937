#include "arrangement/arrangement.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <memory>
#include <optional>
#include <span>

#include "arrangement/check.hpp"
#include "arrangement/endless_field.hpp"
#include "arrangement/order.hpp"
#include "arrangement/sampler.hpp"
#include "arrangement/scattered.hpp"
#include "core/contract.hpp"
#include "core/digest.hpp"
#include "core/error.hpp"
#include "scenario/floes.hpp"

namespace floes {

namespace {

using Rectangles = std::span<const Rectangle>;

std::vector<PlanarPose> lattice_for(const Scenario& scenario, Rectangles shapes) {
    return lattice_start(field_walls(scenario), covering(shapes), scenario.arrangement.clearance,
                         static_cast<int>(shapes.size()));
}

/// Key of random streams that do not depend on ordering_sweeps: more sweeps continue the same chain.
std::uint64_t unordered_key(const Scenario& scenario) {
    Scenario unordered = scenario;
    unordered.arrangement.ordering_sweeps = 0;
    return geometry_key(unordered);
}

/// Cells of a Voronoi diagram have their places, other floes are scattered.
std::vector<PlanarPose> laid(const Scenario& scenario, const FloeSet& floes, RandomStream& random) {
    if (scenario.shapes.kind == ShapeKind::voronoi) return floes.poses();
    return scattered(field_walls(scenario), outlines_of(floes), scenario.arrangement.clearance, random);
}

HardFloes<Walls> chain_from(const Scenario& scenario, const FloeSet& floes, std::span<const PlanarPose> poses) {
    const double clearance = scenario.arrangement.clearance;
    return {field_walls(scenario).shrunk(clearance), outlines_of(floes), clearance, poses};
}

/// Whether all floes are rectangles of one size. A chain of these is tuned on the lattice, for any start: tuned on
/// packed stripes its step would be too short to leave them. Other floes may fit on no lattice.
bool fit_on_lattice(const Scenario& scenario) {
    return scenario.sizes.law == SizeLaw::one && !scenario.shapes.any();
}

std::vector<PlanarPose> monte_carlo(const Scenario& scenario, const FloeSet& floes, RandomStream random) {
    const ArrangementRule& rule = scenario.arrangement;
    const bool alike = fit_on_lattice(scenario);
    HardFloes chain =
        chain_from(scenario, floes, alike ? lattice_for(scenario, rectangles(floes)) : laid(scenario, floes, random));
    const Step step = tune(chain, random);
    if (alike && rule.start == ArrangementStart::stripes)
        chain = chain_from(scenario, floes,
                           stripes_start(field_walls(scenario), covering(rectangles(floes)), rule.clearance,
                                         static_cast<int>(floes.size())));
    for (int i = 0; i < rule.sweeps; ++i) chain.sweep(step, random);
    return chain.poses();
}

std::vector<PlanarPose> scattered_and_ordered(const Scenario& scenario, const FloeSet& floes, std::uint64_t seed,
                                              std::uint32_t number) {
    const std::uint64_t geometry = unordered_key(scenario);
    RandomStream scattering(seed, number, StreamId::scattering, geometry);
    std::vector<PlanarPose> poses = laid(scenario, floes, scattering);
    if (scenario.arrangement.ordering_sweeps == 0) return poses;
    RandomStream ordering(seed, number, StreamId::ordering, geometry);
    HardFloes chain = chain_from(scenario, floes, poses);
    // Tuning takes a thousand sweeps, which are none of those that were asked for.
    HardFloes tuned =
        fit_on_lattice(scenario) ? chain_from(scenario, floes, lattice_for(scenario, rectangles(floes))) : chain;
    const Step step = tune(tuned, ordering);
    for (int i = 0; i < scenario.arrangement.ordering_sweeps; ++i) chain.sweep(step, ordering);
    return chain.poses();
}

std::vector<PlanarPose> find_poses(const Scenario& scenario, const FloeSet& floes, std::uint64_t seed,
                                   std::uint32_t number) {
    const std::uint64_t geometry = geometry_key(scenario);
    const ArrangementRule& rule = scenario.arrangement;
    RandomStream jitter(seed, number, StreamId::lattice_jitter, geometry);
    switch (rule.method) {
        case ArrangementMethod::file:
        case ArrangementMethod::traced:
        case ArrangementMethod::level:
            return floes.poses();
        case ArrangementMethod::lattice:
            return jittered_lattice(field_walls(scenario), rectangles(floes), rule.clearance,
                                    {rule.jitter, rule.jitter_angle}, jitter);
        case ArrangementMethod::scattered:
            return scattered_and_ordered(scenario, floes, seed, number);
        case ArrangementMethod::monte_carlo:
            break;
    }
    return monte_carlo(scenario, floes, RandomStream(seed, number, StreamId::monte_carlo, geometry));
}

/// Every floe's sides, in the order of the law.
std::string sizes_text(const Scenario& scenario) {
    std::string text;
    for (const FloeShape& shape : floe_sizes(scenario))
        text += fmt::format("size {} {}\n", shape.length, shape.breadth);
    return text;
}

std::string outlines_text(const TracedOutlines& traced) {
    std::string text = fmt::format("scale {}\n", traced.scale);
    for (const Outline& one : traced.outlines) {
        text += "outline";
        for (const Corner& corner : one) text += fmt::format(" {} {}", corner.x, corner.z);
        text += '\n';
    }
    return text;
}

/// Parts of a field without end, one after another.
std::function<FieldPart()> parts_of(const Scenario& scenario, std::uint64_t seed, std::uint32_t number) {
    const auto from = [](auto field) { return [field] { return field->next(); }; };
    if (scenario.shapes.kind == ShapeKind::voronoi) return from(std::make_shared<CellField>(scenario, seed, number));
    return from(std::make_shared<EndlessField>(scenario, seed, number, geometry_key(scenario)));
}

void measure(Arrangement& made, const Scenario& scenario) {
    const std::vector<PlanarPose> poses = made.poses();
    made.psi4 = fourfold_order(poses);
    made.local_order = local_order(poses);
    made.coverage_ahead = coverage_ahead(scenario, made);
}

}  // namespace

std::uint64_t geometry_key(const Scenario& scenario) {
    const Field& field = scenario.field;
    const ArrangementRule& rule = scenario.arrangement;
    // A number is written in the fewest digits that give it back, so equal text means equal numbers.
    std::string text = fmt::format("floe {} {}\nfield {} {} {} {}\nrule {} {} {} {} {} {}\n", scenario.floe.length,
                                   scenario.floe.breadth, field.floes, field.concentration, field.begin,
                                   field.half_width, static_cast<int>(rule.method), static_cast<int>(rule.start),
                                   rule.clearance, rule.sweeps, rule.jitter, rule.jitter_angle);
    // Added later, and only for its own method, so that older arrangements keep their key.
    if (rule.method == ArrangementMethod::scattered) text += fmt::format("ordering {}\n", rule.ordering_sweeps);
    if (!rule.columns.empty()) text += fmt::format("columns {}\n", rule.columns);
    for (const std::vector<double>& values : rule.values)
        if (!values.empty()) text += fmt::format("values {}\n", fmt::join(values, " "));
    if (scenario.sizes.law != SizeLaw::one) text += sizes_text(scenario);
    if (scenario.shapes.from_file()) text += outlines_text(scenario.shapes.traced);
    const auto& shapes = scenario.shapes;
    if (shapes.any())
        text += fmt::format("shapes {} {} {} {}\n", static_cast<int>(shapes.kind), shapes.corners, shapes.irregularity,
                            shapes.relaxations);
    for (const PlanarPose& pose : rule.poses) text += fmt::format("pose {} {} {}\n", pose.x, pose.z, pose.yaw);
    return digest64(text);
}

double coverage_ahead(const Scenario& scenario, const FloeSet& floes) {
    if (scenario.path.any()) return std::numeric_limits<double>::quiet_NaN();
    Walls path = field_walls(scenario);
    const double half_width = std::min(scenario.field.half_width, scenario.structure.shape.waterline_radius());
    path.low_z = -half_width;
    path.breadth = 2 * half_width;
    if (scenario.shapes.any()) return coverage(path, outlines_on_water(floes));
    return coverage(path, rectangles(floes), floes.poses());
}

Arrangement make_arrangement(const Scenario& scenario, std::uint64_t seed, std::uint32_t number) {
    if (scenario.field.endless()) return lay_field(scenario, seed, number).floes;
    Arrangement made{floes_of(scenario, {seed, number})};
    const std::vector<PlanarPose> poses = find_poses(scenario, made, seed, number);
    for (std::size_t i = 0; i < poses.size(); ++i) made.floes[i].pose = poses[i];
    if (const std::optional<Fault> fault = find_fault(scenario, made)) {
        if (scenario.arrangement.given()) {
            throw InputError("the given places are no arrangement of this field: {}", fault->sentence);
        }
        throw RunError("arrangement {} came out wrong, which is an error of the program: {}", number, fault->sentence);
    }
    measure(made, scenario);
    FLOES_ENSURES(std::ranges::all_of(made.floes, [](const Floe& floe) { return std::isfinite(floe.pose.x); }));
    return made;
}

namespace {

LaidField lay_sheet(const Scenario& scenario, std::uint64_t seed, std::uint32_t number) {
    const auto sheet = std::make_shared<EndlessSheet>(scenario, seed, number);
    FieldPart first = sheet->next();
    LaidField laid{{floes_of(scenario, {seed, number})},
                   {first.end, [sheet] { return sheet->next(); }, std::move(first.joints)},
                   gathered(first.floes)};
    measure(laid.floes, scenario);
    return laid;
}

}  // namespace

LaidField lay_field(const Scenario& scenario, std::uint64_t seed, std::uint32_t number) {
    if (!scenario.field.endless()) return {make_arrangement(scenario, seed, number), {}};
    if (scenario.arrangement.level()) return lay_sheet(scenario, seed, number);
    const std::function<FieldPart()> next = parts_of(scenario, seed, number);
    const FieldPart first = next();
    LaidField laid{{gathered(first.floes)}, {first.end, next}};
    measure(laid.floes, scenario);
    return laid;
}

}  // namespace floes
