#include "cli/starter.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <string_view>
#include <vector>

#include "campaign/campaign_keys.hpp"
#include "findings/key_words.hpp"

namespace floes {
namespace {

/// A line of a starter: a key with its value, or a heading without one.
struct Line {
    std::string_view key;    ///< full path; of a heading what stands there
    std::string_view value;  ///< empty: a heading
    std::string_view about = {};
};

using Lines = std::vector<Line>;

const Lines tank_ice{
    {"[ice]", ""},
    {"ice.thickness_m", "0.033", "of floes and elements"},
    {"ice.elastic_modulus_MPa", "60.0", "E of the ice"},
    {"ice.bending_strength_kPa", "36.4", "joints fail in bending above it"},
    {"ice.compressive_strength_kPa", "145.6", "usually four times the bending strength"},
    {"ice.shear_strength_kPa", "72.8", "usually twice the bending strength"},
    {"[floe]", ""},
    {"floe.length_m", "0.6", "of every floe"},
    {"floe.breadth_m", "0.6", "of every floe"},
    {"floe.element_m", "0.2", "floes break along this grid; it must divide both"},
};

const Lines tank_scene{
    {"[field]", ""},
    {"field.floes", "24", "more floes make a longer field"},
    {"field.concentration_percent", "75.0", "covered area"},
    {"field.begin_m", "2.0", "where the field begins, along x"},
    {"field.half_width_m", "1.25", "of the channel"},
    {"field.far_end", "\"ice_sheet\"", "closed by an ice sheet, or open water"},
    {"[structure]", ""},
    {"structure.profile_m", "[[-0.443, 0.43], [0.0, 0.614], [0.122, 0.736]]", "the hull, from the keel up"},
    {"structure.start_m", "1.38", "of its axis; it almost touches the ice"},
    {"structure.speed_m_s", "0.1", "of the tow along +x"},
    {"[contact]", ""},
    {"contact.ice_ice_friction", "0.3", "between floes"},
    {"contact.ice_structure_friction", "0.2", "between ice and hull"},
    {"[analysis]", ""},
    {"analysis.steady_start_s", "8.0", "from here loads are measured,"},
    {"analysis.window_s", "18.0", "for this long"},
};

const Lines tank_cases{
    {"[[case]]", ""},
    {"name", "\"thin\"", "a case is any set of changes to the keys above"},
    {"ice.thickness_m", "0.025"},
    {"[[case]]", ""},
    {"name", "\"thick\"", "meets the same arrangements as the other"},
};

const Lines tank_design{
    {"[design]", ""},
    {"design.method", "\"latin_hypercube\"", "how the points are spread"},
    {"design.points", "6", "some ten for each axis say more"},
    {"[[design.axis]]", ""},
    {"key", "\"ice.thickness_m\"", "any key with a number"},
    {"from", "0.02"},
    {"to", "0.04"},
    {"[[design.axis]]", ""},
    {"key", "\"structure.speed_m_s\"", "any key with a number"},
    {"from", "0.07"},
    {"to", "0.13"},
};

const Lines floater{
    {"[general]", ""},
    {"general.time_step_s", "0.1", "waves of stress need no shorter one"},
    {"general.runaway_speed_m_s", "50.0", "a member that exceeds it has failed"},
    {"[ice]", ""},
    {"ice.thickness_m", "1.0", "first-year sea ice in winter"},
    {"ice.density_kg_m3", "910.0"},
    {"ice.elastic_modulus_MPa", "5000.0", "E of the ice"},
    {"ice.bending_strength_kPa", "500.0", "joints fail in bending above it"},
    {"ice.compressive_strength_kPa", "2000.0"},
    {"ice.shear_strength_kPa", "1000.0"},
    {"[floe]", ""},
    {"floe.length_m", "20.0", "of every floe"},
    {"floe.breadth_m", "20.0", "of every floe"},
    {"floe.element_m", "4.0", "floes break along this grid; it must divide both"},
    {"[field]", ""},
    {"field.floes", "300", "more floes make a longer field"},
    {"field.concentration_percent", "75.0", "covered area"},
    {"field.begin_m", "160.0", "where the field begins, along x"},
    {"field.half_width_m", "120.0", "of the channel"},
    {"field.sheet_width_m", "30.0", "of the fixed ice along it"},
    {"field.far_end", "\"ice_sheet\"", "closed by an ice sheet, or open water"},
    {"[arrangement]", ""},
    {"arrangement.clearance_m", "0.05", "least gap between floes at the start"},
    {"[structure]", ""},
    {"structure.profile_m", "[[-10.0, 25.0], [0.0, 35.0], [4.0, 39.0]]", "the hull, from the keel up: 45 degrees"},
    {"structure.start_m", "80.0", "of its axis"},
    {"structure.speed_m_s", "0.5", "of the drift"},
    {"[contact]", ""},
    {"contact.ice_ice_friction", "0.3", "between floes"},
    {"contact.ice_structure_friction", "0.15", "between ice and hull"},
    {"[water]", ""},
    {"water.density_kg_m3", "1025.0", "of sea water"},
    {"[analysis]", ""},
    {"analysis.steady_start_s", "400.0", "from here loads are measured,"},
    {"analysis.window_s", "600.0", "for this long"},
    {"analysis.averaging_s", "[1.0, 5.0, 10.0]", "times that loads are averaged over"},
    {"analysis.peak_separation_s", "25.0", "peaks nearer than this count once"},
};

const Lines table3{
    {"[run]", ""},
    {"run.nominal_modulus", "true", "E is the paper's name of a pair"},
    {"[general]", ""},
    {"general.time_step_s", "0.02"},
    {"general.iterations", "50", "sweeps over joints and contacts in a step"},
    {"general.solver", "\"lanes\"", "the paper's method"},
    {"[ice]", ""},
    {"ice.thickness_m", "0.033", "Table 1, as all of [ice] and [floe]"},
    {"ice.density_kg_m3", "930.0"},
    {"ice.bending_strength_kPa", "36.4"},
    {"ice.compressive_strength_kPa", "145.6"},
    {"ice.shear_strength_kPa", "72.8"},
    {"[floe]", ""},
    {"floe.length_m", "0.6"},
    {"floe.breadth_m", "0.6"},
    {"floe.element_m", "0.2"},
    {"[joint]", ""},
    {"joint.model", "\"cfm\"", "the paper's joints"},
    {"joint.erp", "0.8", "its Γ"},
    {"[field]", ""},
    {"field.floes", "189"},
    {"field.concentration_percent", "75.0", "covered area"},
    {"field.begin_m", "6.0"},
    {"field.half_width_m", "2.4"},
    {"field.far_end", "\"ice_sheet\"", "closed by an ice sheet, or open water"},
    {"[arrangement]", ""},
    {"arrangement.method", "\"scattered\""},
    {"arrangement.clearance_m", "0.002", "least gap between floes at the start"},
    {"[structure]", ""},
    {"structure.profile_m", "[[-0.443, 0.445], [0.0, 0.614], [0.122, 0.736]]", "the hull, from the keel up"},
    {"structure.start_m", "2.0", "of its axis"},
    {"structure.speed_m_s", "0.07", "of the tow"},
    {"[contact]", ""},
    {"contact.preset", "\"paper\"", "physical: friction and crushing of ice instead"},
    {"contact.erp", "0.8", "its Γ"},
    {"contact.ice_ice_friction", "0.3"},
    {"contact.ice_structure_friction", "0.2"},
    {"[water]", ""},
    {"water.density_kg_m3", "1000.0"},
    {"water.heave_damping_from", "\"share\"", "damping as a share of critical, under water too"},
    {"water.added_mass_from", "\"share\"", "no added mass"},
    {"[analysis]", ""},
    {"analysis.steady_start_s", "120.0", "loads are steady from here on"},
    {"analysis.window_s", "150.0"},
    {"analysis.segments", "3", "mean_maximum is the mean of their maxima"},
    {"[paper]", ""},
    {"paper.threshold_form", "\"force\"", "as_printed: its Eqs. (1)-(2) literally"},
    {"paper.moment_about", "\"element_centre\"", "where Bullet reports a joint's torque"},
    {"[[case]]", ""},
    {"name", "\"E30\"", "pairs of E and Σ, its Table 3"},
    {"elastic_modulus_MPa", "30.0"},
    {"cfm", "0.03"},
    {"[[case]]", ""},
    {"name", "\"E60\""},
    {"elastic_modulus_MPa", "60.0"},
    {"cfm", "0.016"},
    {"[[case]]", ""},
    {"name", "\"E200\""},
    {"elastic_modulus_MPa", "200.0"},
    {"cfm", "1e-10"},
};

Lines campaign_head(std::string_view seed, std::string_view arrangements) {
    return {{"[campaign]", ""},
            {"campaign.seed", seed, "another gives other arrangements"},
            {"campaign.arrangements", arrangements, "random; 20 and more give useful intervals"}};
}

Lines lines_of(Starter starter) {
    const auto joined = [](Lines lines, std::initializer_list<const Lines*> more) {
        for (const Lines* some : more) lines.insert(lines.end(), some->begin(), some->end());
        return lines;
    };
    switch (starter) {
        case Starter::full_scale:
            return joined(campaign_head("1", "4"), {&floater});
        case Starter::design:
            return joined(campaign_head("1", "2"), {&tank_ice, &tank_scene, &tank_design});
        case Starter::paper:
            return joined(campaign_head("2020", "4"), {&table3});
        case Starter::tank:
            break;
    }
    return joined(campaign_head("1", "4"), {&tank_ice, &tank_scene, &tank_cases});
}

/// What a key may be, as the reference says it.
std::string range_of(std::string_view key, const std::vector<KeyDescription>& keys) {
    const std::string path = full_path(std::string(key));
    const auto found = std::ranges::find(keys, path, &KeyDescription::key);
    return found == keys.end() ? "" : found->allowed;
}

/// "m, above 0 and at most 10: of floes and elements".
std::string comment_of(const Line& line, const std::vector<KeyDescription>& keys) {
    std::string comment = key_words(line.key).unit;
    const std::string range = range_of(line.key, keys);
    comment += (comment.empty() || range.empty() ? "" : ", ") + range;
    return comment + (comment.empty() || line.about.empty() ? "" : ": ") + std::string(line.about);
}

/// The assignment with its comment behind it or, where that is long, above it.
std::string commented(const std::string& set, const std::string& comment) {
    constexpr std::size_t column = 34;
    constexpr std::size_t longest = 116;
    if (comment.empty()) return set + "\n";
    if (set.size() <= column && column + comment.size() <= longest)
        return fmt::format("{:<{}}  # {}\n", set, column, comment);
    std::string lines = "#";
    std::size_t at = 1;
    for (std::size_t begin = 0; begin < comment.size();) {
        const std::size_t end = std::min(comment.find(' ', begin), comment.size());
        if (at + 1 + end - begin > longest) {
            lines += "\n#";
            at = 1;
        }
        lines += ' ' + comment.substr(begin, end - begin);
        at += 1 + end - begin;
        begin = end + 1;
    }
    return lines + "\n" + set + "\n";
}

std::string_view about(Starter starter) {
    switch (starter) {
        case Starter::full_scale:
            return "A floater of 70 m at the waterline in drifting floes of 20 m";
        case Starter::design:
            return "A design over two keys: how the load depends on thickness and speed";
        case Starter::paper:
            return "The published tank run (Table 3), as its program most likely computed it";
        case Starter::tank:
            break;
    }
    return "A hull towed through floes of model ice, of two thicknesses";
}

}  // namespace

std::string starter_text(Starter starter, const std::string& name) {
    const std::vector<KeyDescription> keys = reference();
    std::string text = fmt::format(
        "# {}.\n# floes run {} computes it. Each value has its unit, what is allowed, and what it is.\n"
        "# Keys that are not here keep their defaults: floes config --reference lists them all.\n",
        about(starter), name);
    bool in_block = false;  // of a case or an axis, where the whole path stands
    for (const Line& line : lines_of(starter)) {
        if (line.value.empty()) {
            text += fmt::format("\n{}\n", line.key);
            in_block = line.key.starts_with("[[");
            continue;
        }
        const std::string_view shown = in_block ? line.key : line.key.substr(line.key.find('.') + 1);
        const std::string set = fmt::format("{} = {}", shown, line.value);
        text += commented(set, comment_of(line, keys));
    }
    return text;
}

}  // namespace floes
