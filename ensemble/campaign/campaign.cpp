#include "campaign/campaign.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <map>
#include <set>

#include <fmt/format.h>

#include "arrangement/arrangement.hpp"
#include "campaign/campaign_keys.hpp"
#include "core/contract.hpp"
#include "core/digest.hpp"
#include "core/error.hpp"
#include "core/text.hpp"
#include "member/design_of.hpp"
#include "scenario/floes.hpp"
#include "scenario/keys.hpp"

namespace floes {

const DesignOf* StopRule::design_of() const {
    return of.starts_with(design_prefix) ? find_design_of(std::string_view{of}.substr(design_prefix.size())) : nullptr;
}

int member_count(const Campaign& campaign) {
    return campaign.arrangements * static_cast<int>(campaign.cases.size());
}

MemberKey member_key(const Campaign& campaign, int number) {
    FLOES_EXPECTS(number >= 0 && number < member_count(campaign));
    const int cases = static_cast<int>(campaign.cases.size());
    return {number % cases, number / cases};
}

const Case& case_of(const Campaign& campaign, int number) {
    return campaign.cases[static_cast<std::size_t>(member_key(campaign, number).case_index)];
}

std::uint64_t arrangement_seed(const Campaign& campaign, int case_index) {
    FLOES_EXPECTS(case_index >= 0 && case_index < std::ssize(campaign.cases));
    if (campaign.common_arrangements) return campaign.seed;
    const std::string& name = campaign.cases[static_cast<std::size_t>(case_index)].name;
    return digest64(fmt::format("seed {} case {}", campaign.seed, name));
}

std::vector<std::string> case_names(const Campaign& campaign) {
    std::vector<std::string> names;
    for (const Case& one : campaign.cases) names.push_back(one.name);
    return names;
}

const Case& chosen_case(const Campaign& campaign, const std::string& name) {
    if (campaign.cases.size() == 1 && name.empty()) return campaign.cases.front();
    const auto found = std::ranges::find(campaign.cases, name, &Case::name);
    if (found != campaign.cases.end()) return *found;
    const std::vector<std::string> names = case_names(campaign);
    throw InputError(
        name.empty()
            ? fmt::format("one case is taken, and this campaign has several; name it with --case: {}", name_list(names))
            : fmt::format("there is no case {}; the cases are {}", name, name_list(names)));
}

std::optional<std::size_t> base_case(const Campaign& campaign) {
    const auto found = std::ranges::find(campaign.cases, campaign.run.base_case, &Case::name);
    if (found == campaign.cases.end()) return {};
    return static_cast<std::size_t>(found - campaign.cases.begin());
}

std::vector<int> sharing_groups(const Campaign& campaign) {
    std::vector<int> groups;
    std::map<std::pair<std::uint64_t, bool>, int> of_geometry;
    for (const Case& one : campaign.cases) {
        const int next = static_cast<int>(campaign.common_arrangements ? of_geometry.size() : groups.size());
        groups.push_back(campaign.common_arrangements
                             ? of_geometry.try_emplace({geometry_key(one.scenario), one.scenario.field.endless()}, next)
                                   .first->second
                             : next);
    }
    return groups;
}

double numeric_value(const Case& one, const std::string& path) {
    Scenario scenario = one.scenario;
    const Keys keys = describe(scenario);
    const std::string text = literal(*find_key(keys, path));  // 57 %, where 0.57 / 0.01 is a little less
    double value = 0;
    std::from_chars(text.data(), text.data() + text.size(), value);
    return value;
}

namespace {

/// Of a sheet a step costs less than of loose floes, until a joint fails: then what impulses do to all of it is found
/// anew. About as many steps bring that as elements lie in the channel, which is a characteristic length wider than the
/// hull. Members of configs/level_ice.toml, level_support.toml, level_support_fast.toml and floes new --level, 180 to
/// 1,340 elements, took 1.0 to 1.2 times as long as this says; those of
/// level_ship.toml and level_cone.toml, 2,400 and 2,500 elements, 0.8 and 0.9 times. In a slice between walls no ice
/// goes round the structure, and the pile has many contacts: two members of level_case1.toml, 1,067 elements, took 4.6
/// and 5.4 times as long.
double cost_of_sheet(const Scenario& scenario) {
    constexpr double of_step = 0.5;
    constexpr double of_break = 0.6;
    const FloeShape sheet = sheet_shape(scenario);
    const double elements = sheet.elements();
    const double channel =
        std::min(sheet.breadth, 2 * scenario.structure.shape.waterline_radius() + scenario.characteristic_length());
    const double breaks = scenario.towed() * channel / (sheet.element * sheet.element);
    const double of_pile = scenario.field.sides == FieldSides::wall ? 5 : 1;
    return of_pile * (of_step * elements * scenario.step_count() + of_break * breaks * std::pow(elements, 1.5));
}

}  // namespace

double expected_cost(const Campaign& campaign, int number) {
    const Scenario& scenario = case_of(campaign, number).scenario;
    return scenario.arrangement.level() ? cost_of_sheet(scenario) : computed_elements(scenario) * scenario.step_count();
}

constexpr std::size_t most_numbers = 30'000'000;  // 240 MB

void HeldNumbers::add(const Scenario& scenario) {
    for (const std::vector<double>& values : scenario.arrangement.values) numbers_ += values.size();
    for (const Outline& one : scenario.shapes.traced.outlines) numbers_ += 2 * one.size();
    numbers_ += 3 * scenario.arrangement.poses.size() + 2 * scenario.structure.shape.rows().size() +
                5 * scenario.structure.shape.piece_rows().size() + scenario.analysis.exceedance_levels.size() +
                scenario.analysis.averaging.size();
    if (numbers_ > most_numbers)
        throw InputError(
            "{}: poses, outlines, profiles, levels and times of all cases are more than {} numbers, which cannot be "
            "held; take fewer cases or shorter lists",
            file_, most_numbers);
}

namespace {

std::string cfm_text(const Case& one) {
    return one.pairing == Pairing::find_cfm ? "to be calibrated" : fmt::format("{}", one.scenario.joint.cfm);
}

std::string modulus_text(const Case& one) {
    return one.pairing == Pairing::find_modulus
               ? "as joint.cfm gives it"
               : fmt::format("{:g}", one.scenario.ice.elastic_modulus / unit::megapascal);
}

/// Leaves what is still to be found out of the differences and says that it is.
void replace(std::vector<std::string>& lines, std::string_view path, const std::string& there,
             const std::string& here) {
    std::erase_if(lines, [&](const std::string& line) { return line.starts_with(fmt::format("{}: ", path)); });
    if (there != here) lines.push_back(fmt::format("{}: {} there, {} here", path, there, here));
}

std::vector<std::string> differences_of(const Case& there, const Case& here) {
    std::vector<std::string> lines = differences(there.scenario, here.scenario);
    const auto either = [&](Pairing pairing) { return there.pairing == pairing || here.pairing == pairing; };
    if (either(Pairing::find_cfm)) replace(lines, "joint.cfm", cfm_text(there), cfm_text(here));
    if (either(Pairing::find_modulus))
        replace(lines, "ice.elastic_modulus_MPa", modulus_text(there), modulus_text(here));
    return lines;
}

/// Everything that a member of the case depends on, except the seed.
std::string case_text(const Case& one) {
    std::string open;
    if (one.pairing == Pairing::find_cfm) open = "joint.cfm is to be calibrated\n";
    if (one.pairing == Pairing::find_modulus) open = "ice.elastic_modulus is to be measured\n";
    return canonical_text(one.scenario) + open;
}

/// The differences of each case that both have; a line that is the same for all cases is given once, without a name.
std::vector<std::string> case_differences(const Campaign& there, const Campaign& here) {
    std::vector<std::vector<std::string>> of_case;
    std::vector<std::string> names;
    for (const Case& one : there.cases) {
        const auto same = std::ranges::find(here.cases, one.name, &Case::name);
        if (same == here.cases.end()) continue;
        of_case.push_back(differences_of(one, *same));
        names.push_back(one.name);
    }
    const auto shared = [&](const std::string& line) {
        for (const std::vector<std::string>& lines : of_case) {
            if (std::ranges::find(lines, line) == lines.end()) return false;
        }
        return true;
    };
    std::vector<std::string> all;
    for (std::size_t i = 0; i < of_case.size(); ++i) {
        for (const std::string& line : of_case[i]) {
            if (!shared(line)) {
                all.push_back(fmt::format("case {}: {}", names[i], line));
            } else if (i == 0) {
                all.push_back(line);
            }
        }
    }
    return all;
}

}  // namespace

std::string fingerprint(const Campaign& campaign) {
    CampaignHead head = campaign;
    head.name.clear();
    Keys keys = describe(head);
    // Common arrangements are not part of the text, so that campaigns from before this key keep their fingerprints.
    if (head.common_arrangements) std::erase_if(keys, [](const Key& key) { return key.path == common_path; });
    std::string text = canonical_text(keys);
    for (const Case& one : campaign.cases) text += fmt::format("case {}\n{}", one.name, case_text(one));
    return digest_hex(text);
}

std::string case_fingerprint(const Campaign& campaign, int case_index) {
    FLOES_EXPECTS(case_index >= 0 && case_index < std::ssize(campaign.cases));
    const Case& one = campaign.cases[static_cast<std::size_t>(case_index)];
    return digest_hex(fmt::format("seed {}\n{}", arrangement_seed(campaign, case_index), case_text(one)));
}

std::vector<std::string> case_fingerprints(const Campaign& campaign) {
    std::vector<std::string> keys;
    for (int k = 0; k < static_cast<int>(campaign.cases.size()); ++k) keys.push_back(case_fingerprint(campaign, k));
    return keys;
}

bool is_part_of(const Campaign& part, const Campaign& whole) {
    const std::vector<std::string> all = case_fingerprints(whole);
    const std::set<std::string> keys(all.begin(), all.end());
    for (int k = 0; k < static_cast<int>(part.cases.size()); ++k)
        if (!keys.contains(case_fingerprint(part, k))) return false;
    return part.arrangements <= whole.arrangements;
}

std::vector<std::string> differences(const Campaign& there, const Campaign& here) {
    CampaignHead head_there = there;
    CampaignHead head_here = here;
    head_there.name = head_here.name;
    std::vector<std::string> lines = key_differences(describe(head_there), describe(head_here));
    const std::vector<std::string> names_there = case_names(there);
    const std::vector<std::string> names_here = case_names(here);
    if (names_there != names_here) {
        lines.push_back(fmt::format("cases: {} there, {} here", name_list(names_there), name_list(names_here)));
    }
    for (std::string& line : case_differences(there, here)) lines.push_back(std::move(line));
    return lines;
}

}  // namespace floes
