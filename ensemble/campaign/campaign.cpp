#include "campaign/campaign.hpp"

#include <algorithm>
#include <charconv>
#include <map>

#include <fmt/format.h>

#include "arrangement/arrangement.hpp"
#include "core/digest.hpp"
#include "core/error.hpp"
#include "scenario/floes.hpp"
#include "scenario/keys.hpp"

namespace floes {

int member_count(const Campaign& campaign) {
    return campaign.arrangements * static_cast<int>(campaign.cases.size());
}

MemberKey member_key(const Campaign& campaign, int number) {
    const int cases = static_cast<int>(campaign.cases.size());
    return {number % cases, number / cases};
}

std::uint64_t arrangement_seed(const Campaign& campaign, int case_index) {
    if (campaign.common_arrangements) return campaign.seed;
    const std::string& name = campaign.cases[static_cast<std::size_t>(case_index)].name;
    return digest64(fmt::format("seed {} case {}", campaign.seed, name));
}

std::optional<std::size_t> base_case(const Campaign& campaign) {
    const auto found = std::ranges::find(campaign.cases, campaign.run.base_case, &Case::name);
    if (found == campaign.cases.end()) return {};
    return static_cast<std::size_t>(found - campaign.cases.begin());
}

std::vector<int> sharing_groups(const Campaign& campaign) {
    std::vector<int> groups;
    std::map<std::uint64_t, int> of_geometry;
    for (const Case& one : campaign.cases) {
        const int next = static_cast<int>(campaign.common_arrangements ? of_geometry.size() : groups.size());
        groups.push_back(campaign.common_arrangements
                             ? of_geometry.try_emplace(geometry_key(one.scenario), next).first->second
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

double expected_cost(const Campaign& campaign, int number) {
    const MemberKey key = member_key(campaign, number);
    const Scenario& scenario = campaign.cases[static_cast<std::size_t>(key.case_index)].scenario;
    const double floes = computed_floes(scenario);
    if (scenario.sizes.law == SizeLaw::one && !scenario.shapes.from_file())
        return scenario.floe.elements() * floes * scenario.step_count();
    // A few floes tell what their law makes of all: this is asked for every member.
    constexpr int few = 16;
    Scenario sample = scenario;
    sample.field.floes = few;
    double elements = 0;
    for (const FloeShape& shape : floe_sizes(sample)) elements += shape.elements();
    return elements * floes / few * scenario.step_count();
}

namespace {

constexpr std::size_t most_numbers = 30'000'000;  // 240 MB

}  // namespace

void HeldNumbers::add(const Scenario& scenario) {
    for (const std::vector<double>& values : scenario.arrangement.values) numbers_ += values.size();
    for (const Outline& one : scenario.shapes.traced.outlines) numbers_ += 2 * one.size();
    numbers_ += 3 * scenario.arrangement.poses.size() + 2 * scenario.structure.shape.rows().size() +
                5 * scenario.structure.shape.piece_rows().size() + scenario.analysis.exceedance_levels.size() +
                scenario.analysis.averaging.size();
    if (numbers_ > most_numbers)
        throw InputError(fmt::format(
            "{}: poses, outlines, profiles, levels and times of all cases are more than {} numbers, which cannot be "
            "held; take fewer cases or shorter lists",
            file_, most_numbers));
}

}  // namespace floes
