#include "findings/pairs.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <utility>

namespace floes {

namespace {

constexpr std::size_t fewest_shared = 2;

/// Done members of a case by arrangement.
std::map<int, const MemberRow*> by_arrangement(const CampaignTable& table, std::size_t of_case) {
    std::map<int, const MemberRow*> rows;
    for (const MemberRow& row : table.members) {
        if (row.case_index == static_cast<int>(of_case) && row.done()) rows[row.arrangement] = &row;
    }
    return rows;
}

struct SharedMembers {
    std::size_t first;
    std::size_t second;
    std::vector<std::pair<const MemberRow*, const MemberRow*>> members;
};

using ByArrangement = std::map<int, const MemberRow*>;

std::vector<ByArrangement> all_by_arrangement(const CampaignTable& table) {
    std::vector<ByArrangement> rows;
    for (std::size_t one = 0; one < table.cases.size(); ++one) rows.push_back(by_arrangement(table, one));
    return rows;
}

SharedMembers shared(const std::vector<ByArrangement>& rows, std::size_t first, std::size_t second) {
    SharedMembers pair{first, second, {}};
    for (const auto& [arrangement, member] : rows[first]) {
        const auto partner = rows[second].find(arrangement);
        if (partner != rows[second].end()) pair.members.emplace_back(member, partner->second);
    }
    return pair;
}

std::vector<SharedMembers> find_pairs(const CampaignTable& table, const PairOptions& options) {
    const std::optional<std::size_t> reference = options.reference;
    const std::vector<ByArrangement> rows = all_by_arrangement(table);
    std::vector<SharedMembers> pairs;
    for (std::size_t one = 0; one < rows.size(); ++one) {
        for (std::size_t other = one + 1; other < rows.size(); ++other) {
            if (!options.others && reference != one && reference != other) continue;
            SharedMembers pair = reference == other ? shared(rows, other, one) : shared(rows, one, other);
            if (pair.members.size() >= fewest_shared) pairs.push_back(std::move(pair));
        }
    }
    return pairs;
}

PairRow compare(const SharedMembers& pair, const Quantity& quantity, const PairOptions& options) {
    std::vector<double> first;
    std::vector<double> second;
    std::vector<int> arrangements;
    for (const auto& [one, other] : pair.members) {
        const double of_first = quantity.of(*one);
        const double of_second = quantity.of(*other);
        if (std::isnan(of_first) || std::isnan(of_second)) continue;  // an older version did not measure it
        first.push_back(of_first);
        second.push_back(of_second);
        arrangements.push_back(one->arrangement);
    }
    PairRow row;
    row.quantity = quantity;
    row.first = pair.first;
    row.second = pair.second;
    row.found = compare_paired(first, second);
    for (const std::vector<std::size_t>* side : {&row.found.apart.above, &row.found.apart.below})
        for (const std::size_t k : *side) row.apart.push_back(arrangements[k]);
    std::ranges::sort(row.apart);
    row.first_mean = std::accumulate(first.begin(), first.end(), 0.0) / static_cast<double>(first.size());
    const auto needed = [&](double difference) {
        return arrangements_to_resolve(difference, row.found.sd, 0.95, options.power);
    };
    row.to_resolve_observed = needed(row.found.difference);
    row.to_resolve_wished = needed(options.resolve * row.first_mean);
    return row;
}

}  // namespace

std::vector<PairRow> compare_pairs(const CampaignTable& table, const PairOptions& options) {
    const std::vector<SharedMembers> pairs = find_pairs(table, options);
    std::vector<PairRow> all;
    const std::vector<Quantity> known = table.quantities();
    for (const Quantity& quantity : shown_in(known, Shown::in_pairs)) {
        std::vector<PairRow> rows;
        std::vector<double> t_p;
        std::vector<double> wilcoxon_p;
        for (const SharedMembers& pair : pairs) {
            rows.push_back(compare(pair, quantity, options));
            t_p.push_back(rows.back().found.t_p);
            wilcoxon_p.push_back(rows.back().found.wilcoxon_p);
        }
        t_p = holm(t_p);
        wilcoxon_p = holm(wilcoxon_p);
        for (std::size_t i = 0; i < rows.size(); ++i) {
            rows[i].t_p_holm = t_p[i];
            rows[i].wilcoxon_p_holm = wilcoxon_p[i];
            all.push_back(std::move(rows[i]));
        }
    }
    return all;
}

std::vector<PairRow> compare_with(const CampaignTable& table, std::size_t reference, const Quantity& quantity,
                                  std::size_t most) {
    const std::vector<ByArrangement> rows = all_by_arrangement(table);
    std::vector<PairRow> all;
    for (std::size_t other = 0; other < std::min(rows.size(), most); ++other) {
        if (other == reference) continue;
        const SharedMembers pair = shared(rows, reference, other);
        if (pair.members.size() < fewest_shared) continue;
        all.push_back(compare(pair, quantity, {}));
        all.back().t_p_holm = all.back().found.t_p;
        all.back().wilcoxon_p_holm = all.back().found.wilcoxon_p;
    }
    return all;
}

}  // namespace floes
