#include "campaign/variations.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "campaign/campaign_keys.hpp"
#include "keys/key.hpp"
#include "scenario/keys.hpp"

namespace floes {
namespace {

constexpr std::string_view base_name = "base";

/// Collects variations of one scenario.
class Open {
  public:
    explicit Open(const Scenario& scenario) : scenario_(scenario), keys_(describe(scenario_)) {}

    /// The key's number times each factor.
    void times(const char* path, std::initializer_list<double> factors, const char* why) {
        const double here = number(path);
        for (const double factor : factors) to(path, rounded(factor * here), why);
    }

    /// The key's number set to each of these that differs from what it is.
    void at(const char* path, std::initializer_list<double> values, const char* why) {
        for (const double value : values)
            if (value != number(path)) to(path, value, why);
    }

    void word(const char* path, const char* word, const char* why) {
        const std::string text = text_literal(word);
        if (in_force(path) && literal(*find_key(keys_, path)) != text)
            found_.push_back({fmt::format("{}_{}", name(path), word), why, {{path, text}}});
    }

    void order(int sweeps, const char* why) {
        const char* path = "arrangement.ordering_sweeps";
        const std::string text = fmt::format("{}", sweeps);
        found_.push_back({fmt::format("{}_{}", name(path), text), why, {{path, text}}});
    }

    /// Channels of other widths with floes in proportion, so that the field keeps its length.
    void widths(std::initializer_list<double> factors, const char* why) {
        for (const double factor : factors) {
            const int floes = static_cast<int>(std::lround(factor * scenario_.field.floes));
            const std::string width = number_literal(rounded(factor * number("field.half_width_m")));
            found_.push_back({fmt::format("half_width_{}_m", width),
                              why,
                              {{"field.floes", fmt::format("{}", floes)}, {"field.half_width_m", width}}});
        }
    }

    std::vector<Variation> found() && { return std::move(found_); }

  private:
    static std::string_view name(std::string_view path) { return path.substr(path.find('.') + 1); }
    /// To four digits: what is varied by a factor is not known better.
    static double rounded(double value) { return std::stod(fmt::format("{:.4g}", value)); }
    bool in_force(const char* path) const { return !find_key(keys_, path)->idle(); }
    double number(const char* path) const {
        const auto& field = std::get<NumberField>(find_key(keys_, path)->field);
        return field.get() / field.unit;
    }

    void to(const char* path, double value, const char* why) {
        const auto& field = std::get<NumberField>(find_key(keys_, path)->field);
        if (!in_force(path) || !field.range.contains(value)) return;
        const std::string text = number_literal(value);
        found_.push_back({fmt::format("{}_{}", name(path), text), why, {{path, text}}});
    }

    Scenario scenario_;
    Keys keys_;
    std::vector<Variation> found_;
};

/// Fracture energy, J/m², at which the energy of a crack decides and no longer the strength (docs/fracture.md).
double tough(const Scenario& scenario) {
    const Ice& ice = scenario.ice;
    const double energy =
        1.4 * ice.bending_strength * ice.bending_strength * scenario.floe.thickness / ice.elastic_modulus;
    return std::stod(fmt::format("{:.2g}", energy));
}

/// The keys that are not as by default, without comments. `base`: the case whose variations all others are; may be
/// empty.
std::string tables_text(const Campaign& campaign, const Scenario& scenario, std::string_view base) {
    CampaignHead head{"", campaign.seed, campaign.arrangements, campaign.common_arrangements};  // named by its file
    RunRules rules = campaign.run;
    rules.base_case = base;
    Scenario own = scenario;
    Keys keys = describe(head);
    for (Key& key : describe(rules)) keys.push_back(std::move(key));
    for (Key& key : describe(own)) keys.push_back(std::move(key));

    CampaignHead usual_head;
    RunRules usual_rules;
    Scenario usual_scenario;
    Keys usual = describe(usual_head);
    for (Key& key : describe(usual_rules)) usual.push_back(std::move(key));
    for (Key& key : describe(usual_scenario)) usual.push_back(std::move(key));

    Keys written;
    for (std::size_t k = 0; k < keys.size(); ++k)
        if (!keys[k].derived() && !keys[k].idle() && exact_text(keys[k]) != exact_text(usual[k]))
            written.push_back(std::move(keys[k]));
    return write_tables(written, {}, Comments::none);
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
    open.times("ice.bending_strength_kPa", {0.8, 1.25}, "scatter of beam tests within one sheet");
    if (scenario.joint.model == JointModel::beam)
        open.times("ice.elastic_modulus_MPa", {0.5, 2}, "methods of measuring E differ by this");
    open.times("ice.compressive_strength_kPa", {0.5, 2}, "rarely measured, depends on the rate");
    open.at("ice.fracture_energy_J_m2", {tough(scenario)}, "ice so tough that cracks wait for their energy");
    open.times("contact.ice_ice_friction", {0.5, 2}, "0.02 to 0.7 in the sources of the paper");
    open.times("contact.ice_structure_friction", {0.75, 1.25}, "of a hull whose friction was measured");
    open.word("water.flow", "still", "the flow past the structure is that of a cylinder");
    open.at("water.form_drag", {0.5, 1.5}, "0.5 to 1.5 in the sources of docs/configuration.md");
    open.at("water.heave_drag", {1.2}, "1.0 to 1.2 of plates and discs");
    open.at("water.added_mass_in_plane", {0.0, 0.2}, "0.04 of fast and 0.18 of slow motion");
    const ArrangementRule& rule = scenario.arrangement;
    if (rule.method == ArrangementMethod::scattered && rule.ordering_sweeps == 0 && !scenario.field.endless())
        open.order(1000, "floes that have drifted lie in some order");
    if (!scenario.arrangement.given()) open.widths({1.5}, "ice at sea has no walls");
    return std::move(open).found();
}

std::string variations_text(const Campaign& campaign, const Case& of) {
    std::string text = fmt::format(
        "# {} of {}, its unknowns varied one at a time: how far do its loads depend on what is rarely measured?\n"
        "# Leave out cases that do not apply, add your own, then run it; floes summarize says what they do "
        "together.\n"
        "# Keys that are not here have their defaults.\n\n",
        of.name, campaign.name);
    text += tables_text(campaign, of.scenario, base_name);
    text += fmt::format("\n[[case]]\nname = {}\n", text_literal(std::string(base_name)));
    return text + cases_text(variations_of(of.scenario));
}

std::string study_text(const Campaign& campaign, const Case& of, const std::vector<Variation>& cases) {
    return tables_text(campaign, of.scenario, "") + cases_text(cases);
}

}  // namespace floes
