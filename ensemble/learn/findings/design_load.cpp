#include "findings/design_load.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "core/error.hpp"
#include "findings/case_peaks.hpp"

namespace floes {

double DesignLoadRequest::model_exposure() const {
    return exposure / std::sqrt(scale);
}

double DesignLoadRequest::model_averaging() const {
    return averaging / std::sqrt(scale);
}

double DesignLoadRequest::force_factor() const {
    return scale * scale * scale;
}

double averaging_time(const CampaignTable& table, const DesignLoadRequest& request) {
    for (const double time : table.averaging_times)
        if (std::abs(time - request.model_averaging()) < 0.005 * time) return time;
    std::vector<std::string> there;
    for (const double time : table.averaging_times)
        there.push_back(fmt::format("{:.3g}", time * std::sqrt(request.scale)));
    throw InputError(
        fmt::format("The members did not average the load over {:g} s{}; take one of {} s, or run them with "
                    "another analysis.averaging_s.",
                    request.averaging, request.scale == 1 ? "" : " at full scale", fmt::join(there, ", ")));
}

double disagreement(const DesignLoad& load) {
    double least = load.estimates.front().quantiles.front().value;
    double most = least;
    for (const DesignLoadEstimate& made : load.estimates) {
        const double value = made.quantiles.front().value;
        if (!std::isfinite(value)) continue;
        least = std::min(least, value);
        most = std::max(most, value);
    }
    return (most - least) / load.estimates.front().quantiles.front().value;
}

namespace {

/// "17", "17 and 31", "3, 17 and 31".
std::string listed(const std::vector<int>& numbers) {
    if (numbers.size() == 1) return fmt::format("{}", numbers.front());
    return fmt::format("{} and {}", fmt::join(numbers.begin(), numbers.end() - 1, ", "), numbers.back());
}

}  // namespace

std::string standing_out_text(const CaseDesignLoad& one) {
    constexpr std::size_t enough = 5;  // of a kind, to say how much it varies
    const UnlikeMembers& unlike = one.load.unlike;
    const std::size_t count = unlike.out.size();
    if (count == 0) return "";
    std::vector<int> numbers;
    for (const std::size_t row : unlike.out) numbers.push_back(one.members[row]);
    const bool single = count == 1;
    const std::string does = unlike.carried == 0 ? fmt::format("{} far above the others", single ? "lies" : "lie")
                             : unlike.carried == 1
                                 ? fmt::format("{} the highest peak", single ? "carries" : "carry")
                                 : fmt::format("{} the {} highest peaks", single ? "carries" : "carry", unlike.carried);
    std::string text = fmt::format(
        "{} of {} members {}: replay {}. Both tails have {} as a kind of member whose share is uncertain; methods that "
        "take all members as alike are left out.",
        count, one.members.size(), does, listed(numbers), single ? "it" : "them");
    if (count < enough)
        text += fmt::format(" About {} arrangements would have {} of this kind.",
                            (enough * one.members.size() + count - 1) / count, enough);
    return text;
}

std::vector<CaseDesignLoad> find_design_loads(const CampaignTable& table, const DesignLoadRequest& request) {
    const double time = averaging_time(table, request);
    std::vector<CasePeaks> peaks;
    for (std::size_t index = 0; index < table.cases.size(); ++index) peaks.push_back(case_peaks(table, index, time));
    return find_design_loads(table, request, peaks);
}

std::vector<CaseDesignLoad> find_design_loads(const CampaignTable& table, const DesignLoadRequest& request,
                                              const std::vector<CasePeaks>& peaks) {
    const Exposure exposure{request.model_exposure(), request.quantiles, request.share,
                            table.cases.size() > most_averaged_cases};
    std::vector<CaseDesignLoad> designs;
    const std::vector<JointTrend> trends = joint_trends(table);
    for (std::size_t index = 0; index < table.cases.size(); ++index) {
        CaseDesignLoad one;
        one.case_index = index;
        one.trend = trends[index];
        const CasePeaks& found = peaks.at(index);
        one.separation = found.measured.separation;
        one.arrangements = found.arrangements;
        one.members = found.members;
        for (const PeakRow& row : found.rows) one.peaks.insert(one.peaks.end(), row.peaks.begin(), row.peaks.end());
        std::ranges::sort(one.peaks, std::ranges::greater{});
        if (one.trend.rises() && !request.rising) {
            one.refused = true;
            one.load.arrangements = found.rows.size();
            one.over_shares.assign(std::size(threshold_shares), std::nan(""));
            designs.push_back(std::move(one));
            continue;
        }
        one.load = design_load(found.rows, found.measured, exposure);
        for (const auto& quantiles : over_thresholds(found.rows, found.measured, exposure,
                                                     {std::begin(threshold_shares), std::end(threshold_shares)}))
            one.over_shares.push_back(quantiles.front());
        designs.push_back(std::move(one));
    }
    return designs;
}

}  // namespace floes
