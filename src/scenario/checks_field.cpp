// Contradictions of the field: without end, of polygons, of outlines that were traced.

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>

#include <fmt/format.h>

#include "core/error.hpp"
#include "scenario/floes.hpp"
#include "scenario/keys.hpp"
#include "scenario/validate.hpp"
#include "shapes/elements.hpp"

namespace floes {

namespace {

constexpr double longest_tow = 1e5;  // m: as far as the sides of the field reach

const std::string far_end = "field.far_end";

/// What moves or holds ice that is to rest until the structure comes.
void check_rest(const Scenario& scenario, Contradictions& found) {
    struct Mover {
        std::string key;
        double value;
        const char* why;
    };
    for (const Mover& one :
         {Mover{"water.current_m_s", scenario.water.current, "ice ahead of the computed part rests and cannot drift"},
          Mover{"wind.speed_m_s", scenario.wind.speed, "ice ahead of the computed part rests and cannot drift"},
          Mover{"field.confining_N_m", scenario.field.confining, "no rigid sheet is as long as the field"},
          Mover{"field.wake_radius_m", scenario.field.wake_radius, "field.ahead_m already says which floes rest"}}) {
        if (one.value == 0) continue;
        refuse(scenario, found, {one.key, far_end},
               "<{}> does not go together with <{}>: {}; take 0, or a field with an end", one.key, far_end, one.why);
    }
    if (scenario.general.solver == SolverKind::stock) {
        refuse(scenario, found, {"general.solver", far_end},
               "<general.solver> cannot let floes rest, as <{}> asks; take \"direct\" or \"lanes\"", far_end);
    }
}

/// The window of floes that are computed goes on with the structure and never back, and what it has left is gone.
void check_way_back(const Scenario& scenario, Contradictions& found) {
    const double room = scenario.window_behind() - window_least(scenario);
    double farthest = 0;
    double time = 0;
    for (const PathPlace& place : scenario.places()) {
        const double x = place.pose.x;
        farthest = std::max(farthest, x);
        if (farthest - x > room - length_rounding) {
            refuse(scenario, found,
                   {scenario.path.legs.empty() ? "path.places" : "path.legs", far_end, "field.behind_m"},
                   "the path takes the structure back by {:.4g} m to x = {:.4g} m after {:.6g} s, and with <{}> floes "
                   "more than {:.4g} m behind the farthest place that it has been to are gone, so {:.4g} m is the "
                   "most; go on along +x, take a larger field.behind_m or a field with an end",
                   farthest - x, scenario.structure.start + x, time, far_end, scenario.window_behind(), room);
            return;
        }
        time += scenario.general.time_step;
    }
}

void check_tiles(const Scenario& scenario, Contradictions& found) {
    const ArrangementRule& rule = scenario.arrangement;
    if (rule.method != ArrangementMethod::scattered) {
        refuse(scenario, found, {"arrangement.method", far_end},
               "<arrangement.method> does not go together with <{}>, whose parts are laid beside one another without a "
               "seam; take \"scattered\", or a field with an end",
               far_end);
    } else if (rule.ordering_sweeps > 0) {
        refuse(scenario, found, {"arrangement.ordering_sweeps", far_end},
               "<arrangement.ordering_sweeps> would move floes that lie already, which <{}> does not allow; take 0, or "
               "a field with an end",
               far_end);
    }
}

void check_window(const Scenario& scenario, Contradictions& found) {
    const double least = window_least(scenario);
    const auto check = [&](const std::string& key, double length, const char* what) {
        if (length > least) return;
        refuse(scenario, found, {key, "structure.profile_m", "field.half_width_m"},
               "<{}> is {:.4g} m, and {} nearer than the structure's radius and {}, {:.4g} m; take more", key, length,
               what, scenario.arrangement.level() ? "two elements" : "a floe's diagonal", least);
    };
    check("field.ahead_m", scenario.window_ahead(), "the structure would strike floes at rest when they are");
    check("field.behind_m", scenario.window_behind(), "floes would be taken out while they touch it when they are");
    const double towed = scenario.reach();
    if (towed + scenario.window_ahead() > longest_tow) {
        refuse(found, {"analysis.window_s", "structure.speed_m_s", "field.ahead_m"},
               "the tow comes {:.4g} m far and looks {:.4g} m ahead, and the sides of a field without end reach {:.4g} "
               "m; tow for a shorter time",
               towed, scenario.window_ahead(), longest_tow);
    }
}

}  // namespace

double window_least(const Scenario& scenario) {
    if (scenario.arrangement.level()) return scenario.structure.shape.largest_radius() + 2 * scenario.floe.element;
    double diagonal = 0;
    for (const FloeShape& shape : floe_sizes(scenario))
        diagonal = std::max(diagonal, std::hypot(shape.length, shape.breadth));
    return scenario.structure.shape.largest_radius() + diagonal;
}

void check_bed(const Scenario& scenario, Contradictions& found) {
    const Water& water = scenario.water;
    if (!water.has_bed()) return;
    if (scenario.field.endless() && water.bed_slope != 0)
        return refuse(scenario, found, {"water.bed_slope_deg", far_end},
                      "<water.bed_slope_deg> comes out of the water somewhere ahead of <field.far_end>; take 0");
    if (!found.empty()) return;  // what lies where is known of a field without fault
    double draught = 0;
    const FloeSet floes = floes_of(scenario);
    for (std::size_t i = 0; i < floes.size(); ++i)
        draught = std::max(draught, floes.shape(i).thickness * floes.material(i).ice.density / water.density);
    for (const double x : {scenario.field.begin, scenario.field_end()}) {
        const double depth = water.depth - std::tan(water.bed_slope) * (x - scenario.structure.start);
        if (depth > draught) continue;
        return refuse(scenario, found, {"water.depth_m", "water.bed_slope_deg"},
                      "<water.depth_m> with <water.bed_slope_deg> leaves {:.4g} m of water at x = {:.4g} m, where ice "
                      "of {:.4g} m draught is to float at the start; take deeper water or a gentler slope",
                      depth, x, draught);
    }
}

void check_endless(const Scenario& scenario, Contradictions& found) {
    if (!scenario.field.endless()) return;
    check_rest(scenario, found);
    if (!scenario.arrangement.level()) {
        check_tiles(scenario, found);
        if (scenario.arrangement.method != ArrangementMethod::scattered) return;
    }
    const std::size_t before = found.size();
    check_window(scenario, found);
    if (found.size() == before) check_way_back(scenario, found);
}

namespace {

/// What one sheet in place of floes cannot have.
void check_sheet_alone(const Scenario& scenario, Contradictions& found) {
    const std::string method = "arrangement.method";
    const auto needs = [&](bool met, const std::string& key, const char* reason, const char* instead) {
        if (!met)
            refuse(scenario, found, {key, method}, "<{}> does not go together with <{}>: {}; take {}", key, method,
                   reason, instead);
    };
    needs(scenario.field.floes == 1, "field.floes", "level ice is one sheet", "field.floes = 1");
    needs(scenario.field.concentration == 1, "field.concentration_percent", "level ice has no leads",
          "100, and floe.length_m and floe.breadth_m for its size");
    needs(!scenario.shapes.any(), "shapes.kind", "the sheet is a rectangle", "\"rectangle\"");
    needs(scenario.sizes.law == SizeLaw::one, "sizes.law", "level ice is one sheet", "\"one\"");
    needs(scenario.arrangement.columns.empty(), "arrangement.columns", "no file gives the sheet", "none");
    if (!scenario.field.endless()) return;
    if (scenario.field.level_held == LevelHeld::nowhere)
        refuse(scenario, found, {"field.level_held", far_end},
               "<field.level_held> does not go together with <{}>: the sheet goes on ahead; take \"far_end\"", far_end);
    if (!scenario.has_cells())
        refuse(scenario, found, {"floe.elements", far_end},
               "<floe.elements> does not go together with <{}>, whose cells go on without a seam; take \"cells\" with "
               "joint.model = \"beam\"",
               far_end);
}

/// Where it is frozen to the ice sheets round the field.
void check_held(const Scenario& scenario, Contradictions& found) {
    const Field& field = scenario.field;
    const std::string held = "field.level_held";
    const bool at_sides = field.level_held == LevelHeld::far_end_and_sides;
    const auto needs = [&](bool met, const std::string& key, const char* reason, const char* instead) {
        if (!met)
            refuse(scenario, found, {key, held},
                   "<{}> does not go together with <{}>: {}; take {}, or "
                   "field.level_held = \"nowhere\"",
                   key, held, reason, instead);
    };
    needs(field.far_end != FarEnd::open, "field.far_end", "there is nothing to freeze to",
          "\"ice_sheet\" or \"never\"");
    if (at_sides && field.endless())
        refuse(scenario, found, {held, far_end},
               "<{}> does not go together with <{}>: ice that stays at the sides would never leave; take \"far_end\"",
               held, far_end);
    needs(!at_sides || field.sides == FieldSides::ice_sheet, "field.sides", "there is nothing to freeze to",
          "\"ice_sheet\"");
    needs(scenario.general.solver == SolverKind::direct && scenario.joint.model == JointModel::beam, "general.solver",
          "only beams that are solved exactly hold an edge", "general.solver = \"direct\" with joint.model = \"beam\"");
    needs(!scenario.contact.internal_edges, "paper.internal_edges",
          "an edge that is frozen to another would push it away", "false");
    needs(field.confining == 0, "field.confining_N_m", "ice sheets that give way hold nothing", "0");
    needs(field.wake_radius == 0, "field.wake_radius_m", "a sheet that is held does not rest", "0");
    if (field.level_pushed && (scenario.path.any() || scenario.moorings.give_way()))
        refuse(scenario, found, {"field.level_pushed", "path.legs", "moorings.free"},
               "<field.level_pushed> has the structure at rest, so it has neither a path nor moorings that give way; "
               "take false, the tow through ice at rest");
    needs(scenario.water.current == 0, "water.current_m_s", "ice starts with the current, and this is held", "0");
}

}  // namespace

void check_level(const Scenario& scenario, Contradictions& found) {
    if (scenario.spread.length > 0 && !scenario.arrangement.level())
        refuse(scenario, found, {"spread.length_m", "arrangement.method"},
               "<spread.length_m> is of level ice, and <arrangement.method> lays floes; take 0, or \"level\"");
    const IceSpread& spread = scenario.spread;
    if (spread.length > 0 && !spread.thickness.any() && !spread.strength.any() && !spread.elastic_modulus.any())
        refuse(scenario, found, {"spread.length_m", "spread.thickness", "spread.strength", "spread.elastic_modulus"},
               "<spread.length_m> is the length over which thickness, strength or modulus vary, and none does; take 0, "
               "or a law such as spread.strength = \"lognormal\"");
    const bool held = scenario.arrangement.level() && scenario.field.level_held != LevelHeld::nowhere;
    if (scenario.field.level_pushed && !held)
        refuse(scenario, found, {"field.level_pushed", "field.level_held", "arrangement.method"},
               "<field.level_pushed> needs level ice that is held; take arrangement.method = \"level\" with "
               "field.level_held = \"far_end\", or false");
    if (!scenario.arrangement.level()) return;
    check_sheet_alone(scenario, found);
    const Field& field = scenario.field;
    if (held) check_held(scenario, found);
    const bool at_sides = field.level_held == LevelHeld::far_end_and_sides;
    const double width = 2 * field.half_width;
    const double breadth = scenario.floe.breadth;
    if (at_sides && std::abs(breadth - width) > length_rounding)
        refuse(scenario, found, {"floe.breadth_m", "field.half_width_m", "field.level_held"},
               "<floe.breadth_m> is not the width of the field, {:.6g} m, at whose sides <field.level_held> holds the "
               "sheet; make them equal",
               width);
    const double gap = field.sides == FieldSides::ice_sheet ? scenario.arrangement.clearance : 0;
    if (!at_sides && breadth > width - 2 * gap + length_rounding)
        refuse(scenario, found, {"floe.breadth_m", "field.half_width_m", "arrangement.clearance_m"},
               "<floe.breadth_m> leaves the sheet less than <arrangement.clearance_m> at either side of the field, "
               "which is {:.6g} m wide; take a wider field, or {:.6g}",
               width, width - 2 * gap);
}

void check_shapes(const Scenario& scenario, Contradictions& found) {
    if (!scenario.shapes.any()) return;
    const std::size_t before = found.size();
    const auto cannot = [&](const std::string& with, const std::string& reason, const std::string& instead) {
        refuse(scenario, found, {with, "shapes.kind"}, "<shapes.kind> is not possible with <{}>: {}; take {}", with,
               reason, instead);
    };
    const bool voronoi = scenario.shapes.kind == ShapeKind::voronoi;
    if (scenario.joint.model != JointModel::beam)
        cannot("joint.model", "Σ and Γ are fitted to square elements", "joint.model = \"beam\"");
    const ArrangementMethod method = scenario.arrangement.method;  // check_traced() has looked at traced
    if (method == ArrangementMethod::lattice || method == ArrangementMethod::file)
        cannot("arrangement.method",
               voronoi ? "cells of a Voronoi diagram lie where they grew" : "polygons fit on no lattice of rectangles",
               "arrangement.method = \"scattered\" or \"monte_carlo\"");
    if (voronoi && scenario.sizes.law != SizeLaw::one)
        cannot("sizes.law", "the diagram decides the areas",
               "sizes.law = \"one\", shapes.kind = \"polygon\", or another number of shapes.relaxations");
    if (found.size() > before) return;
    try {
        static_cast<void>(floes_of(scenario));
    } catch (const InputError& error) {
        found.push_back({{"shapes.kind", "shapes.relaxations", "field.concentration_percent"}, error.what()});
    }
}

namespace {

const std::vector<std::string> outline_keys{"shapes.file", "shapes.outlines", "shapes.kind"};

/// ", and 3 more" for others of which the same is true.
std::string and_more(std::ptrdiff_t others) {
    return others > 0 ? fmt::format(" (and {} more)", others) : "";
}

std::optional<std::string> fault_of(const TracedOutlines& traced) {
    for (std::size_t i = 0; i < traced.outlines.size(); ++i) {
        const Outline& one = traced.outlines[i];
        if (const auto fault = ring_fault_of(one))
            return fmt::format("{} is no floe: {}", outline_name(traced, i), *fault);
        const bool turned = area_of(one) < 0;
        const std::size_t most =
            is_convex(turned ? Outline(one.rbegin(), one.rend()) : one) ? most_outline_corners : most_bayed_corners;
        if (one.size() > most)
            return fmt::format(
                "{} has {} corners, more than the {} of a floe; give it by shapes.file, which takes "
                "fewer",
                outline_name(traced, i), one.size(), most);
    }
    if (!traced.areas.empty() && traced.areas.size() != traced.outlines.size())
        return fmt::format("shapes.traced_areas_m2 has {} areas for {} outlines; leave it out, or give one for each",
                           traced.areas.size(), traced.outlines.size());
    return std::nullopt;
}

/// What covers too much more than what was traced.
void check_added(const TracedOutlines& traced, Contradictions& found) {
    if (traced.areas.empty()) return;
    const std::vector<double> added = traced_added(traced);
    const auto worst = std::ranges::max_element(added);
    const auto above = std::ranges::count_if(added, [&](double one) { return one > traced.most_added; });
    if (above == 0) return;
    refuse(found, {"shapes.most_added_percent", "shapes.file"},
           "{} has holes: filled it would cover {:.3g} % more, above shapes.most_added_percent = {:g}{}; trace it as "
           "several floes, allow more, or leave it out",
           outline_name(traced, static_cast<std::size_t>(worst - added.begin())), 100 * *worst, 100 * traced.most_added,
           and_more(above - 1));
}

/// Each has to be a sheet, wider than it is thick; one smaller than an element is one element.
void check_sheets(const Scenario& scenario, Contradictions& found) {
    const TracedOutlines& traced = scenario.shapes.traced;
    double elements = 0;
    for (const Outline& one : traced.outlines)
        elements += std::abs(area_of(one)) * std::pow(traced.scale / scenario.floe.element, 2);
    const double each = static_cast<double>(scenario.field.floes) / static_cast<double>(traced.outlines.size());
    check_element_count(scenario, elements * std::max(1.0, each), found);
    if (!found.empty()) return;
    const std::vector<SingleFloe> floes = floes_as_traced(scenario);
    const auto width_of = [](const SingleFloe& one) { return 2 * inner_radius_of_parts(one.shape.outline); };
    const auto narrowest = std::ranges::min_element(floes, {}, width_of);
    const auto below =
        std::ranges::count_if(floes, [&](const auto& one) { return width_of(one) < scenario.floe.thickness; });
    if (below == 0) return;
    refuse(scenario, found, {"ice.thickness_m", "shapes.scale", "shapes.file", "shapes.outlines"},
           "{}{} is thinner than the ice: the widest circle in a convex part of it has a diameter of {:.4g} m, less "
           "than <ice.thickness_m>; leave such floes out of the file, or change shapes.scale or shapes.unit",
           outline_name(traced, static_cast<std::size_t>(narrowest - floes.begin())), and_more(below - 1),
           width_of(*narrowest));
}

}  // namespace

void check_traced(const Scenario& scenario, Contradictions& found) {
    const Shapes& shapes = scenario.shapes;
    const bool as_they_lie = scenario.arrangement.method == ArrangementMethod::traced;
    if (as_they_lie && !shapes.from_file())
        refuse(scenario, found, {"arrangement.method", "shapes.kind"},
               "<arrangement.method> needs shapes.kind = \"file\", whose outlines have places");
    if (!shapes.from_file()) return;
    const TracedOutlines& traced = shapes.traced;
    if (traced.outlines.empty()) {
        refuse(scenario, found, outline_keys, "<shapes.kind> needs outlines; give shapes.file or shapes.outlines");
        return;
    }
    if (scenario.sizes.law != SizeLaw::one)
        refuse(scenario, found, {"sizes.law", "shapes.kind"},
               "<shapes.kind> is not possible with <sizes.law>: the outlines have their own sizes; take sizes.law = "
               "\"one\", and shapes.scale for larger or smaller ones");
    if (as_they_lie && traced.outlines.size() != static_cast<std::size_t>(scenario.field.floes))
        refuse(scenario, found, {"field.floes", "shapes.file", "shapes.outlines"},
               "<field.floes> is not the number of outlines, {}, which all lie where they were traced; make them "
               "agree, or take arrangement.method = \"scattered\"",
               traced.outlines.size());
    if (const auto fault = fault_of(traced)) found.push_back({outline_keys, *fault});
    if (!found.empty()) return;
    check_added(traced, found);
    if (found.empty()) check_sheets(scenario, found);
}

}  // namespace floes
