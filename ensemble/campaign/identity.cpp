#include "campaign/identity.hpp"

#include <algorithm>
#include <set>

#include <fmt/format.h>

#include "campaign/campaign_keys.hpp"
#include "core/digest.hpp"
#include "core/error.hpp"
#include "core/text.hpp"
#include "core/units.hpp"
#include "scenario/keys.hpp"

namespace floes {

namespace {

/// What members depend on besides their scenarios.
CampaignHead head_of(const Campaign& campaign) {
    return {"", campaign.seed, campaign.arrangements, campaign.common_arrangements};
}

std::vector<std::string> case_names(const Campaign& campaign) {
    std::vector<std::string> names;
    for (const Case& one : campaign.cases) names.push_back(one.name);
    return names;
}

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
    CampaignHead head = head_of(campaign);
    Keys keys = describe(head);
    // Common arrangements are not part of the text, so that campaigns from before this key keep their fingerprints.
    if (head.common_arrangements) std::erase_if(keys, [](const Key& key) { return key.path == common_path; });
    std::string text = canonical_text(keys);
    for (const Case& one : campaign.cases) text += fmt::format("case {}\n{}", one.name, case_text(one));
    return digest_hex(text);
}

std::string case_fingerprint(const Campaign& campaign, int case_index) {
    const Case& one = campaign.cases[static_cast<std::size_t>(case_index)];
    return digest_hex(fmt::format("seed {}\n{}", arrangement_seed(campaign, case_index), case_text(one)));
}

bool is_part_of(const Campaign& part, const Campaign& whole) {
    std::set<std::string> keys;
    for (int k = 0; k < static_cast<int>(whole.cases.size()); ++k) keys.insert(case_fingerprint(whole, k));
    for (int k = 0; k < static_cast<int>(part.cases.size()); ++k)
        if (!keys.contains(case_fingerprint(part, k))) return false;
    return part.arrangements <= whole.arrangements;
}

std::vector<std::string> differences(const Campaign& there, const Campaign& here) {
    CampaignHead head_there = head_of(there);
    CampaignHead head_here = head_of(here);
    std::vector<std::string> lines = key_differences(describe(head_there), describe(head_here));
    const std::vector<std::string> names_there = case_names(there);
    const std::vector<std::string> names_here = case_names(here);
    if (names_there != names_here) {
        lines.push_back(fmt::format("cases: {} there, {} here", name_list(names_there), name_list(names_here)));
    }
    for (std::string& line : case_differences(there, here)) lines.push_back(std::move(line));
    return lines;
}

void KeyEffects::note(const Keys& keys, const Origins& origins) {
    for (const Key& key : keys) {
        if (!key.in_force) continue;
        const std::string path(key.path);
        const auto origin = origins.find(path);
        if (origin == origins.end() || is_superfluous(key)) continue;
        if (key.idle())
            idle_.try_emplace(path, fmt::format("{}: {} = {}", origin->second, path, literal(key)), key.only_with);
        else
            effective_.insert(path);
    }
}

void KeyEffects::refuse_without() const {
    for (const auto& [path, given] : idle_) {
        if (effective_.contains(path)) continue;
        throw InputError(
            fmt::format("{} has no effect: it needs {}. Add that, or leave {} out.", given.first, given.second, path));
    }
}

}  // namespace floes
