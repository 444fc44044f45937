#pragma once
// The list of scalar quantities of a member: of the journal, the campaign file and its page, the stop rule, summaries,
// pairs and designs. CONTRIBUTING.md says how to add one. Those of the averaged load are made of it: quantities_with().

#include <algorithm>
#include <array>
#include <optional>
#include <ranges>
#include <span>
#include <string_view>
#include <vector>

#include "quantities/motion_quantities.hpp"
#include "quantities/quantity_kind.hpp"
#include "quantities/work_quantities.hpp"

namespace floes {

/// Of the load and the ice, in the order in which they are shown; those of the structure's motion follow.
inline constexpr std::array load_quantities{
    Quantity{.key = "mean_load",
             .unit = "N",
             .long_name = "mean surge load over the window",
             .place = at<&MemberOutputs::load, &LoadStatistics::mean>(),
             .shown = Shown::in_headlines,
             .name = "mean_N",
             .label = "mean, N",
             .least = no_least,
             .stops = true,
             .in_designs = true},
    Quantity{.key = "sd_load",
             .unit = "N",
             .long_name = "population standard deviation of the surge load over the window",
             .place = at<&MemberOutputs::load, &LoadStatistics::sd>(),
             .shown = Shown::in_table3,
             .name = "sd_N",
             .label = "SD, N",
             .stops = true,
             .in_designs = true,
             .averaged = &AveragedLoad::sd},
    Quantity{.key = "maximum_load",
             .unit = "N",
             .long_name = "largest surge load in the window",
             .place = at<&MemberOutputs::load, &LoadStatistics::maximum>(),
             .shown = Shown::in_table3,
             .name = "maximum_N",
             .label = "maximum, N",
             .least = no_least,
             .positive = true,
             .stops = true},
    Quantity{.key = "skewness",
             .unit = "1",
             .long_name = "skewness of the surge load over the window",
             .place = at<&MemberOutputs::load, &LoadStatistics::skewness>(),
             .least = no_least},
    Quantity{.key = "excess_kurtosis",
             .unit = "1",
             .long_name = "excess kurtosis of the surge load over the window",
             .place = at<&MemberOutputs::load, &LoadStatistics::excess_kurtosis>(),
             .least = no_least},
    Quantity{.key = "mean_maximum",
             .unit = "N",
             .long_name = "mean of the segment maxima of the surge load",
             .place = at<&MemberOutputs::load, &LoadStatistics::mean_maximum>(),
             .shown = Shown::in_headlines,
             .name = "mean_maximum_N",
             .label = "mean maximum, N",
             .least = no_least,
             .positive = true,
             .stops = true,
             .in_designs = true,
             .averaged = &AveragedLoad::mean_maximum},
    Quantity{.key = "sd_maximum",
             .unit = "N",
             .long_name = "population standard deviation of the segment maxima of the surge load",
             .place = at<&MemberOutputs::load, &LoadStatistics::sd_maximum>(),
             .shown = Shown::in_table3,
             .name = "sd_maximum_N",
             .label = "SD maximum, N",
             .averaged = &AveragedLoad::sd_maximum},
    Quantity{.key = "failure_ratio",
             .unit = "1",
             .long_name = "broken floes over all floes that were computed, at the end of the run",
             .place = at<&MemberOutputs::failure_ratio>(),
             .shown = Shown::in_headlines,
             .name = "failure_ratio",
             .label = "failure ratio, %",
             .most = 1,
             .percent = true,
             .stops = true,
             .in_designs = true},
    floe_count("floes_entered", "floes that were computed at any time of the run: all of a field with an end",
               at<&MemberOutputs::floes_entered>()),
    floe_count("floes_met", "floes that touched the structure at any time of the run", at<&MemberOutputs::floes_met>()),
    Quantity{.key = "met_failure_ratio",
             .unit = "1",
             .long_name = "broken floes among those that touched the structure, over these",
             .place = at<&MemberOutputs::met_failure_ratio>(),
             .most = 1,
             .percent = true,
             .since = 13},
    crack_quantity("split_ratio", "split_ratio", "floes cracked through, %",
                   "floes that a crack went through, over all floes, at the end of the run",
                   at<&MemberOutputs::split_ratio>(), true),
    crack_quantity("cracked_ratio", "cracked_ratio", "floes with any crack, %",
                   "floes of which a joint began to crack, over all floes, at the end of the run",
                   at<&MemberOutputs::cracked_ratio>(), true),
    crack_quantity("pieces", "pieces_per_run", "pieces of ice at the end", "pieces of ice at the end of the run",
                   at<&MemberOutputs::pieces>(), false),
    Quantity{.key = "fracture_work",
             .unit = "J",
             .long_name = "energy that cracks took over the run, of joints that fail by stress",
             .place = at<&MemberOutputs::fracture_work>(),
             .since = 12},
    Quantity{.key = "mean_sway",
             .unit = "N",
             .long_name = "mean sway load over the window",
             .place = at<&MemberOutputs::mean_sway>(),
             .least = no_least},
    Quantity{.key = "mean_heave",
             .unit = "N",
             .long_name = "mean heave load over the window",
             .place = at<&MemberOutputs::mean_heave>(),
             .least = no_least},
    moment_quantity<&MemberOutputs::yaw, &Swing::mean>("mean_yaw_moment", "mean yaw moment"),
    moment_quantity<&MemberOutputs::yaw, &Swing::sd>("sd_yaw_moment", "SD of the yaw moment"),
    moment_quantity<&MemberOutputs::yaw, &Swing::largest>("largest_yaw_moment", "largest yaw moment"),
    moment_quantity<&MemberOutputs::roll, &Swing::mean>("mean_roll_moment", "mean moment about the tow"),
    moment_quantity<&MemberOutputs::roll, &Swing::sd>("sd_roll_moment", "SD of the moment about the tow"),
    moment_quantity<&MemberOutputs::roll, &Swing::largest>("largest_roll_moment", "largest moment about the tow"),
    moment_quantity<&MemberOutputs::pitch, &Swing::mean>("mean_pitch_moment", "mean overturning moment"),
    moment_quantity<&MemberOutputs::pitch, &Swing::sd>("sd_pitch_moment", "SD of the overturning moment"),
    moment_quantity<&MemberOutputs::pitch, &Swing::largest>("largest_pitch_moment", "largest overturning moment"),
    Quantity{.key = "trend",
             .unit = "N s-1",
             .long_name = "slope of the surge load over the window",
             .place = at<&MemberOutputs::load, &LoadStatistics::trend>(),
             .least = no_least},
    Quantity{.key = "trend_p",
             .unit = "1",
             .long_name = "probability of a slope at least so far from zero if there were none",
             .place = at<&MemberOutputs::load, &LoadStatistics::trend_p>(),
             .most = 1},
    Quantity{.key = "peak_compression",
             .unit = "N",
             .long_name = "largest axial compression in any joint over the run",
             .place = at<&MemberOutputs::peaks, &PeakReactions::compression>()},
    Quantity{.key = "peak_tension",
             .unit = "N",
             .long_name = "largest axial tension in any joint over the run",
             .place = at<&MemberOutputs::peaks, &PeakReactions::tension>()},
    Quantity{.key = "peak_shear",
             .unit = "N",
             .long_name = "largest resultant shear in any joint over the run",
             .place = at<&MemberOutputs::peaks, &PeakReactions::shear>()},
    Quantity{.key = "peak_bending",
             .unit = "N m",
             .long_name = "largest bending moment in any joint over the run",
             .place = at<&MemberOutputs::peaks, &PeakReactions::bending>()},
    Quantity{.key = "peak_torsion",
             .unit = "N m",
             .long_name = "largest torsion in any joint over the run",
             .place = at<&MemberOutputs::peaks, &PeakReactions::torsion>()},
    Quantity{.key = "peak_in_plane_bending",
             .unit = "N m",
             .long_name = "largest in-plane bending moment in any joint over the run",
             .place = at<&MemberOutputs::peaks, &PeakReactions::in_plane_bending>()},
    Quantity{.key = "failures_bending",
             .unit = "1",
             .long_name = "joints that failed in bending",
             .place = failures_in<FailureMode::bending>(),
             .shown = Shown::in_summary,
             .name = "failures_bending_per_run",
             .label = "joints failed in bending",
             .count = true},
    Quantity{.key = "failures_shear",
             .unit = "1",
             .long_name = "joints that failed in shear",
             .place = failures_in<FailureMode::shear>(),
             .shown = Shown::in_summary,
             .name = "failures_shear_per_run",
             .label = "  in shear",
             .count = true},
    Quantity{.key = "failures_compression",
             .unit = "1",
             .long_name = "joints that failed in compression",
             .place = failures_in<FailureMode::compression>(),
             .shown = Shown::in_summary,
             .name = "failures_compression_per_run",
             .label = "  in compression",
             .count = true},
    Quantity{.key = "failures_tension",
             .unit = "1",
             .long_name = "joints that failed in tension",
             .place = failures_in<FailureMode::tension>(),
             .shown = Shown::in_summary,
             .name = "failures_tension_per_run",
             .label = "  in tension",
             .count = true,
             .since = 9},
    Quantity{.key = "failures_torsion",
             .unit = "1",
             .long_name = "joints that failed in torsion",
             .place = failures_in<FailureMode::torsion>(),
             .shown = Shown::in_summary,
             .name = "failures_torsion_per_run",
             .label = "  in torsion",
             .count = true,
             .since = 9},
    Quantity{.key = "failures_in_plane_bending",
             .unit = "1",
             .long_name = "joints that failed in bending in the plane",
             .place = failures_in<FailureMode::in_plane_bending>(),
             .shown = Shown::in_summary,
             .name = "failures_in_plane_bending_per_run",
             .label = "  in bending in the plane",
             .count = true,
             .since = 9},
};

/// All of them.
inline constexpr auto quantities = [] {
    std::array<Quantity, load_quantities.size() + work_quantities.size() + motion_quantities.size()> all{};
    std::ranges::copy(load_quantities, all.begin());
    std::ranges::copy(work_quantities, all.begin() + load_quantities.size());
    std::ranges::copy(motion_quantities, all.begin() + load_quantities.size() + work_quantities.size());
    return all;
}();

/// The quantity of that key in the list; nullptr if there is none.
constexpr const Quantity* find_quantity(std::string_view key) {
    const auto* const found = std::ranges::find(quantities, key, [](const Quantity& one) { return one.key.view(); });
    return found == quantities.end() ? nullptr : found;
}

/// `one` of the load averaged over `time`, s: "mean_maximum_0.5s". Shown in pairs at most.
Quantity averaged_over(const Quantity& one, double time);

/// The list with, after each quantity that is taken of the averaged load too, the same for each of `averaging_times`.
std::vector<Quantity> quantities_with(std::span<const double> averaging_times);

/// The quantity of that key, be it in the list or averaged; none where there is none.
std::optional<Quantity> any_quantity(std::string_view key);

/// quantity("mean_load"): a key that is not in the list does not compile.
consteval const Quantity& quantity(std::string_view key) {
    return *find_quantity(key);
}

/// Those of `all` that are shown at this level or above, in order.
constexpr auto shown_in(const std::ranges::forward_range auto& all, Shown least) {
    return std::views::filter(all, [least](const Quantity& one) { return one.shown >= least; });
}

/// Outputs without data: every quantity is NaN, each of `segments` maxima NaN.
MemberOutputs unmeasured(int segments);

}  // namespace floes
