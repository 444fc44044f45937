#include "campaign/write.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <optional>
#include <ranges>
#include <set>
#include <span>
#include <string_view>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "campaign/campaign_keys.hpp"
#include "campaign/design.hpp"
#include "core/text.hpp"
#include "core/units.hpp"
#include "keys/document.hpp"
#include "keys/key.hpp"
#include "keys/read.hpp"
#include "scenario/keys.hpp"
#include "scenario/validate.hpp"

namespace floes {

namespace {

constexpr std::string_view cfm_path = "joint.cfm";
constexpr std::string_view modulus_path = "ice.elastic_modulus_MPa";

/// Why the text of a case leaves out a key that is still to be found; empty for others.
std::string_view to_be_found(const Case& one, const Key& key) {
    if (one.pairing == Pairing::find_cfm && key.path == cfm_path)
        return "calibrated to show the elastic modulus when the campaign runs";
    if (one.pairing == Pairing::find_modulus && key.path == modulus_path)
        return "measured by a plate test when the campaign runs";
    return {};
}

/// Paths of the keys that differ between cases, or that some cases do not have. `keys` are bound to `scenario`, which
/// takes the scenario of each case in turn.
std::set<std::string_view> varying_paths(const std::vector<Case>& cases, const Keys& keys, Scenario& scenario) {
    std::set<std::string_view> paths;
    for (const Case& one : cases)
        for (const Key& key : keys)
            if (!to_be_found(one, key).empty()) paths.insert(key.path);
    if (cases.size() == 1) return paths;
    scenario = cases.front().scenario;
    std::vector<std::string> first;
    for (const Key& key : keys) first.push_back(exact_text(key));
    for (const Case& one : std::span(cases).subspan(1)) {
        scenario = one.scenario;
        for (std::size_t i = 0; i < keys.size(); ++i) {
            if (!paths.contains(keys[i].path) && exact_text(keys[i]) != first[i]) paths.insert(keys[i].path);
        }
    }
    return paths;
}

/// The axes as [[design.axis]] blocks. Uses the fields that `keys` are bound to.
std::string axes_text(const Design& design, const Keys& keys) {
    std::string text;
    for (const DesignAxis& axis : design.axes) {
        const Key& key = *find_key(keys, axis.key);
        const auto written = [&](const Value& value) {
            assign(key, {axis.key, value, "design"});
            return literal(key);
        };
        const auto end = [&](double value) {
            return axis.whole ? fmt::format("{}", static_cast<std::int64_t>(value)) : number_literal(value);
        };
        text += fmt::format("\n[[{}]]\nkey = {}\n", axis_block, text_literal(axis.key));
        if (axis.numeric) text += axis.scale == AxisScale::log ? "scale = \"log\"\n" : "scale = \"linear\"\n";
        if (design.has_ranges()) {
            text += fmt::format("from = {}\nto = {}\n", end(axis.from), end(axis.to));
        } else {
            std::vector<std::string> values;
            for (const Value& value : axis.values) values.push_back(written(value));
            text += fmt::format("values = [{}]\n", fmt::join(values, ", "));
        }
    }
    return text;
}

}  // namespace

std::string write_campaign(const Campaign& campaign, const std::string& where) {
    CampaignHead head = campaign;
    const std::vector<Case>& cases = campaign.cases;
    Scenario scenario = cases.front().scenario;
    const Keys keys = describe(scenario);  // only once, because it takes longer than the rest of a case
    const std::set<std::string_view> varying = varying_paths(cases, keys, scenario);
    StopRule stop = campaign.stop;
    RunRules rules = campaign.run;
    Design design = campaign.design;
    Keys tables =
        joined_keys(describe(head), design.active() ? describe(design) : Keys(), describe(stop), describe(rules));
    scenario = cases.front().scenario;
    for (const Key& key : keys) {
        if (!varying.contains(key.path) && !is_superfluous(key)) tables.push_back(key);
    }
    std::string text = write_tables(tables, titles(), Comments::none);
    text += axes_text(design, keys);
    for (const Case& one : cases) {
        if (text.size() > longest_text) break;  // lists repeated in each case can make it very long
        scenario = one.scenario;
        text += fmt::format("\n[[case]]\nname = {}\n", text_literal(one.name));
        if (design.active())
            text += fmt::format("design.base = {}\ndesign.point = {}\n", text_literal(one.base), one.point);
        for (const Key& key : keys) {
            if (const std::string_view why = to_be_found(one, key); !why.empty()) {
                text += fmt::format("# {}: {}\n", key.path, why);
            } else if (varying.contains(key.path) && !key.part && !is_superfluous(key)) {
                text += fmt::format("{} = {}\n", key.path, literal(key));
            }
        }
    }
    refuse_what_cannot_be_held(text, where);
    return text;
}

namespace {

/// Why the case's key has its value; empty of one that was stated.
std::string_view reason_of(const Case& one, std::string_view path) {
    for (const auto& [key, reason] : one.laid)
        if (laid_paths.at(static_cast<std::size_t>(key)) == path) return reason;
    return {};
}

/// The same of a key that stands in the tables, for all cases.
std::string_view reason_of(const Campaign& campaign, std::string_view path) {
    for (const Case& one : campaign.cases)
        if (const std::string_view reason = reason_of(one, path); !reason.empty()) return reason;
    return {};
}

}  // namespace

std::string resolved_text(const Campaign& campaign) {
    std::string text;
    std::string table;
    std::ptrdiff_t of_case = -1;
    for (const auto part : std::views::split(write_campaign(campaign), '\n')) {
        const std::string_view line(part.begin(), part.end());
        if (line.starts_with("[[")) {
            table.clear();
            if (line == "[[case]]") ++of_case;
        } else if (line.starts_with("[")) {
            table = std::string(line.substr(1, line.size() - 2)) + ".";
        }
        const std::string path = table + std::string(line.substr(0, line.find(" = ")));
        const std::string_view reason = of_case < 0
                                            ? reason_of(campaign, path)
                                            : reason_of(campaign.cases.at(static_cast<std::size_t>(of_case)), path);
        text += line;
        if (!reason.empty()) text += fmt::format("  # derived: {}", reason);
        text += '\n';
    }
    text.pop_back();  // behind the last line end there is no line
    return text;
}

namespace {

constexpr std::string_view base_name = "base";

bool in_range(const Key& key) {
    if (const auto* number = std::get_if<NumberField>(&key.field))
        return number->range.contains(number->get() / number->unit);
    if (const auto* whole = std::get_if<IntegerField>(&key.field))
        return whole->low <= whole->get() && whole->get() <= whole->high;
    return true;
}

/// A profile and the slope of a part of it.
struct TurnedWall {
    std::vector<std::vector<double>> rows;  ///< of heights and radii, m
    double slope = 0;                       ///< from the horizontal, degrees
};

/// The profile with the highest sloped part below the waterline turned by so many degrees about that part's upper end,
/// so that the waterline stays; what lies below moves along. None where no part slopes or a radius would fall below 0.
std::optional<TurnedWall> turned_wall(const Shape& shape, double degrees) {
    if (shape.kind() != HullKind::profile) return {};
    std::vector<std::vector<double>> rows = shape.rows();
    auto above = std::ranges::find_if(rows, [](const std::vector<double>& row) { return row[0] > 0; });
    if (const std::vector<double>& below = *(above - 1); below[0] < 0 && below[1] != (*above)[1]) {
        const double slope = ((*above)[1] - below[1]) / ((*above)[0] - below[0]);
        above = rows.insert(above, std::vector{0.0, to_digits(below[1] - slope * below[0], 7)});
        ++above;
    }
    for (auto upper = above - 1; upper != rows.begin(); --upper) {
        const double rise = (*upper)[0] - (*(upper - 1))[0];
        const double run = (*upper)[1] - (*(upper - 1))[1];
        constexpr double vertical = 1e-6;  // in proportion: what rounding leaves of a run
        if (rise == 0 || std::abs(run) < vertical * rise) continue;
        const double slope = std::atan2(rise, std::abs(run)) + degrees * unit::degree;
        if (slope <= 0) return {};
        const double shift = run - std::copysign(1, run) * rise / std::tan(slope);
        for (std::vector<double>& row : std::ranges::subrange(rows.begin(), upper))
            if (row[1] > 0) row[1] = to_digits(row[1] + shift, 4);  // what is on the axis stays there
        if (std::ranges::any_of(rows, [](const std::vector<double>& row) { return row[1] < 0; })) return {};
        return TurnedWall{std::move(rows), slope / unit::degree};
    }
    return {};
}

/// Collects variations of one scenario.
class Open {
  public:
    explicit Open(const Scenario& scenario) : scenario_(scenario), keys_(describe(scenario_)) {}

    /// The keys in which `change` makes the scenario differ. Left out where none has an effect, or what comes out could
    /// not be run.
    void vary(std::string name, const char* why, const std::function<void(Scenario&)>& change) {
        Scenario other = scenario_;
        change(other);
        const Keys keys = describe(other);
        Variation found{std::move(name), why, {}};
        for (const std::string& path : differing_keys(scenario_, other)) {
            const Key& key = *find_key(keys, path);
            if (!in_range(key)) return;
            found.sets.emplace_back(path, literal(key));
        }
        if (!found.sets.empty() && find_contradictions(other).empty()) found_.push_back(std::move(found));
    }

    /// The key's number set to each of these.
    void at(const char* path, std::initializer_list<double> values, const char* why) {
        for (const double value : values)
            vary(fmt::format("{}_{}", find_key(keys_, path)->name(), number_literal(value)), why, [&](Scenario& other) {
                const Keys keys = describe(other);
                const NumberField& field = number(keys, path);
                field.set(value * field.unit);
            });
    }

    /// The key's number times each factor, to four digits: what is varied by a factor is not known better.
    void times(const char* path, std::initializer_list<double> factors, const char* why) {
        const NumberField& field = number(keys_, path);
        for (const double factor : factors) at(path, {to_digits(factor * (field.get() / field.unit), 4)}, why);
    }

    /// A channel of another width with floes in proportion, so that the field keeps its length.
    void width(double factor, const char* why) {
        const double half_width = to_digits(factor * scenario_.field.half_width, 4);
        vary(fmt::format("half_width_{}_m", number_literal(half_width)), why, [&](Scenario& other) {
            other.field.half_width = half_width;
            other.field.floes = static_cast<int>(std::lround(factor * scenario_.field.floes));
        });
    }

    /// A tow of another speed over the same distances. A faster one has shorter steps, so that the structure goes no
    /// further in one; times stay whole steps.
    void speed(double factor, const char* why) {
        const double speed = factor * scenario_.structure.speed;
        vary(fmt::format("speed_m_s_{:.4g}", speed), why, [&](Scenario& other) {
            other.structure.speed = speed;
            other.analysis.steady_start /= factor;
            other.analysis.window /= factor;
            if (factor > 1) other.general.time_step /= factor;
        });
    }

    /// A wall below the waterline that is steeper by so many degrees.
    void wall(double degrees, const char* why) {
        const std::optional<TurnedWall> turned = turned_wall(scenario_.structure.shape, degrees);
        if (!turned) return;
        vary(fmt::format("wall_deg_{:.1f}", turned->slope), why,
             [&](Scenario& other) { other.structure.shape.set_profile(turned->rows); });
    }

    std::vector<Variation> found() && { return std::move(found_); }

  private:
    static const NumberField& number(const Keys& keys, const char* path) {
        return std::get<NumberField>(find_key(keys, path)->field);
    }

    Scenario scenario_;
    Keys keys_;
    std::vector<Variation> found_;
};

/// Fracture energy, J/m², at which the energy of a crack decides and no longer the strength (docs/fracture.md).
double tough(const Scenario& scenario) {
    const Ice& ice = scenario.ice;
    return to_digits(1.4 * ice.bending_strength * ice.bending_strength * scenario.floe.thickness / ice.elastic_modulus,
                     2);
}

/// The campaign's stop rule where a study of the case with these variations can have it: it is of every case alone,
/// not of some of the campaign's, and each measures what it is of.
StopRule stop_rule_for(const Campaign& campaign, const Case& of, const std::vector<Variation>& variations) {
    if (campaign.stop.case_name != "all" || campaign.stop.contrast != "none") return {};
    Campaign study;
    study.stop = campaign.stop;
    study.cases.push_back(of);
    for (const Variation& one : variations) {
        Scenario& scenario = study.cases.emplace_back(of).scenario;
        const Keys keys = describe(scenario);
        for (const auto& [key, value] : one.sets)
            assign(*find_key(keys, key), parse_override(fmt::format("{}={}", key, value), one.name));
    }
    return stop_quantity_fault(study) ? StopRule{} : study.stop;
}

/// The keys that are not as by default, without comments but for a stop rule that is left out. `base`: the case whose
/// variations all others are; may be empty.
std::string tables_text(const Campaign& campaign, const Case& of, std::string_view base, const StopRule& stop) {
    CampaignTables own;
    own.head = campaign;
    own.head.name.clear();  // named by its file
    own.stop = stop;
    own.run = campaign.run;
    own.run.base_case = base;
    own.scenario = of.scenario;
    const CampaignTables usual;

    // Keys that a reader would lay anew are stated, as they are here; so are E and Σ, of which it would find one.
    const bool laid = lays_itself(own.scenario);
    const bool paired = own.scenario.joint.model == JointModel::cfm;
    Keys written;
    for (std::size_t k = 0; k < own.keys.size(); ++k) {
        const Key& key = own.keys[k];
        if (key.derived() || key.idle() || !to_be_found(of, key).empty()) continue;
        const bool stated = (laid && std::ranges::find(laid_paths, key.path) != laid_paths.end()) ||
                            (paired && (key.path == cfm_path || key.path == modulus_path));
        if (stated || exact_text(key) != exact_text(usual.keys[k])) written.push_back(key);
    }
    const bool left_out = campaign.stop.active() && !stop.active();
    return (left_out ? fmt::format("# The stop rule of {} does not fit these cases and is left out: all {} "
                                   "arrangements run.\n\n",
                                   in_a_file_name(campaign.name), campaign.arrangements)
                     : "") +
           write_tables(written, {}, Comments::none);
}

std::string cases_text(const std::vector<Variation>& cases) {
    std::string text;
    for (const Variation& one : cases) {
        text += fmt::format("\n[[case]]  # {}\nname = {}\n", one.why, text_literal(one.name));
        for (const auto& [key, value] : one.sets) text += fmt::format("{} = {}\n", key, value);
    }
    return text;
}

}  // namespace

std::vector<Variation> variations_of(const Scenario& scenario) {
    Open open(scenario);
    const bool by_brine = scenario.brine.salinity > 0;
    if (by_brine)
        open.times("brine.salinity_ppt", {0.8, 1.25}, "it decides strength and modulus");
    else
        open.times("ice.bending_strength_kPa", {0.8, 1.25}, "scatter of beam tests within one sheet");
    if (scenario.joint.model == JointModel::beam && !by_brine)
        open.times("ice.elastic_modulus_MPa", {0.5, 2}, "methods of measuring E differ by this");
    open.times("ice.compressive_strength_kPa", {0.5, 2}, "rarely measured, depends on the rate");
    open.at("ice.fracture_energy_J_m2", {tough(scenario)}, "ice so tough that cracks wait for their energy");
    open.times("contact.ice_ice_friction", {0.5, 2}, "0.02 to 0.7 in the sources of the paper");
    open.times("contact.ice_structure_friction", {0.75, 1.25}, "of a hull whose friction was measured");
    open.vary("ice_ice_friction_rate_and_state", "sources disagree on what speed does: docs/convergence.md",
              [](Scenario& other) { other.contact.slip.ice_ice = SlipEffect::rate_and_state; });
    open.vary("ice_structure_friction_power", "friction on steel and concrete falls with speed: docs/convergence.md",
              [](Scenario& other) { other.contact.slip.ice_structure = SlipEffect::power; });
    open.vary("flow_still", "the flow past the structure is that of a cylinder",
              [](Scenario& other) { other.water.flow = WaterFlow::still; });
    open.at("water.form_drag", {0.5, 1.5}, "0.5 to 1.5 in the sources of docs/configuration.md");
    open.at("water.shelter_draughts", {2.0}, "as Lüpkes et al. 2012 have it");
    open.at("water.heave_drag", {1.2}, "1.0 to 1.2 of plates and discs");
    open.at("water.added_mass_in_plane", {0.0, 0.2}, "0.04 of fast and 0.18 of slow motion");
    const ArrangementRule& rule = scenario.arrangement;
    if (rule.method == ArrangementMethod::scattered && rule.ordering_sweeps == 0 && !scenario.field.endless())
        open.vary("ordering_sweeps_1000", "floes that have drifted lie in some order",
                  [](Scenario& other) { other.arrangement.ordering_sweeps = 1000; });
    if (!scenario.arrangement.given()) open.width(1.5, "ice at sea has no walls");
    for (const double degrees : {-2.0, 2.0}) open.wall(degrees, "the load depends on it strongly: docs/validation.md");
    if (scenario.towed_straight())
        for (const double factor : {0.5, 2.0}) open.speed(factor, "the load depends on it strongly: docs/sea_ice.md");
    if (scenario.joint.fails_by_stress())
        open.times("general.time_step_s", {0.5}, "how a floe answers a blow takes short steps: docs/fracture.md");
    return std::move(open).found();
}

std::string variations_text(const Campaign& campaign, const Case& of) {
    std::string text = fmt::format(
        "# {} of {}, its unknowns varied one at a time: how far do its loads depend on what is rarely measured?\n"
        "# Leave out cases that do not apply, add your own, then run it; floes summarize says what they do "
        "together.\n"
        "# Keys that are not here have their defaults.\n\n",
        of.name, in_a_file_name(campaign.name));
    const std::vector<Variation> variations = variations_of(of.scenario);
    text += tables_text(campaign, of, base_name, stop_rule_for(campaign, of, variations));
    text += fmt::format("\n[[case]]\nname = {}\n", text_literal(std::string(base_name)));
    return text + cases_text(variations);
}

std::string study_text(const Campaign& campaign, const Case& of, const std::vector<Variation>& cases) {
    return tables_text(campaign, of, "", stop_rule_for(campaign, of, {})) + cases_text(cases);
}

}  // namespace floes
