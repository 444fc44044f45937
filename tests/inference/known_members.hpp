#pragma once
// Members whose averaged load has peaks of a known tail, for the stop rule on design loads.

#include <algorithm>
#include <cmath>
#include <functional>

#include "campaign/campaign.hpp"
#include "core/random.hpp"
#include "inference/known_processes.hpp"
#include "member/member_outputs.hpp"

namespace floes::known {

inline constexpr double peaks_a_member = 20;  // about so many in a window
inline constexpr double least_peak = 10;      // N
inline constexpr double peak_scale = 20;      // N

/// One case of 150 s, and a rule on its design load.
inline Campaign load_campaign(double half_width) {
    Campaign made;
    made.arrangements = 1000;
    Scenario scenario;
    scenario.analysis = {.window = window, .segments = 3, .averaging = {1}, .peak_separation = separation};
    made.cases.push_back({"one", scenario});
    made.stop.half_width = half_width;
    made.stop.of = "design_load";
    return made;
}

/// Peaks of 10 + 20 w, in N, times `factor`, w exponential; those nearer than 5 s to a higher one are left out, as a
/// member leaves them out. `rise`: of the load over the window, N.
inline MemberOutputs member(RandomStream& random, double factor = 1, double rise = 0) {
    struct Peak {
        double at;
        double height;
    };
    std::vector<Peak> all, kept;
    const double spacing = window / peaks_a_member;
    for (double at = spacing * exponential(random); at < window; at += spacing * exponential(random))
        all.push_back({at, factor * (least_peak + peak_scale * exponential(random))});
    std::ranges::sort(all, std::greater<>{}, &Peak::height);
    for (const Peak& peak : all)
        if (std::ranges::none_of(kept, [&](const Peak& one) { return std::abs(one.at - peak.at) < separation; }))
            kept.push_back(peak);
    MemberOutputs outputs;
    outputs.load.mean = 5 + 0.5 * normal(random);
    outputs.load.trend = (rise + normal(random)) / window;
    AveragedLoad& averaged = outputs.averaged.emplace_back();
    averaged.time = 1;
    averaged.segment_maximum.assign(3, 0);
    for (const Peak& peak : kept) {
        averaged.peaks.push_back(peak.height);
        double& largest = averaged.segment_maximum[static_cast<std::size_t>(peak.at / (window / 3))];
        largest = std::max(largest, peak.height);
    }
    return outputs;
}

/// Of members with factor 1: the load that the largest in `exposure`, s, stays below with probability p.
inline double largest_of_alike(double exposure, double p) {
    return least_peak + peak_scale * std::log(-exposure * peaks_a_member / window / std::log(p));
}

}  // namespace floes::known
