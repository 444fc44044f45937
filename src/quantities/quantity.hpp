#pragma once
// The list of scalar quantities of a member. It drives the journal, the columns of the campaign file and their page,
// the stop rule, summaries, pairs and designs. A new quantity is its field in MemberOutputs, one line here, and the
// computation in member/run_member.cpp. Quantities of the averaged load are made from the same lines at run time, one
// for each averaging time: quantities_with().

#include <algorithm>
#include <array>
#include <limits>
#include <optional>
#include <ranges>
#include <span>
#include <string_view>
#include <vector>

#include "quantities/member_outputs.hpp"
#include "quantities/short_text.hpp"

namespace floes {

/// Access to a quantity in the outputs.
struct Place {
    double (*get)(const MemberOutputs&);
    void (*set)(MemberOutputs&, double);
};

/// at<&MemberOutputs::load, &LoadStatistics::mean>: the chain of data members.
template <auto... Path>
constexpr Place at() {
    return {[](const MemberOutputs& outputs) { return (outputs.*....*Path); },
            [](MemberOutputs& outputs, double value) { (outputs.*....*Path) = value; }};
}

/// Joints that failed in this mode.
template <FailureMode mode>
constexpr Place failures_in() {
    constexpr auto number = static_cast<std::size_t>(mode);
    return {[](const MemberOutputs& outputs) { return outputs.failures[number]; },
            [](MemberOutputs& outputs, double value) { outputs.failures[number] = value; }};
}

inline constexpr double no_least = -std::numeric_limits<double>::infinity();
inline constexpr double no_most = std::numeric_limits<double>::infinity();

/// Where a quantity is shown; each level includes those before it.
enum class Shown {
    in_file,      ///< only a column of /members
    in_summary,   ///< also a line of each case's summary
    in_pairs,     ///< also in comparisons of cases
    in_table3,    ///< also with every interval: the rows of Table 3
    in_headlines  ///< also where there is room for only a few
};

struct Quantity {
    ShortText key;               ///< column of /members, word of stop.of
    std::string_view unit;       ///< in the file
    std::string_view long_name;  ///< in the file and on its page
    Place place;
    Shown shown = Shown::in_file;
    ShortText name = {};   ///< in JSON and CSV of summaries; ends in the unit
    ShortText label = {};  ///< in tables, with the unit
    double least = 0;      ///< values and intervals lie in [least, most]
    double most = no_most;
    bool positive = false;    ///< above 0 in any run: ranges of single runs are taken on a logarithmic scale
    bool percent = false;     ///< shown in percent
    bool count = false;       ///< a whole number whose total over runs is reported too
    bool stops = false;       ///< a stop rule may use it
    bool in_designs = false;  ///< used in the sensitivity to a design's axes
    int since = 0;            ///< minor version of the file's layout 1 that introduced it
    double AveragedLoad::*averaged = nullptr;  ///< the same for the averaged load; none: not taken
    double averaging = 0;                      ///< s, that the load is averaged over; 0: every step

    /// NaN where the outputs do not have that averaging time.
    double of(const MemberOutputs& outputs) const;
    /// Whether it can have the value: a count is a whole number, or NaN where nobody counted.
    bool holds(double value) const;
    constexpr double factor() const { return percent ? 100 : 1; }  ///< displayed value / stored value
};

/// In the order in which they are shown.
inline constexpr std::array quantities{
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
             .long_name = "broken floes over all floes at the end of the run",
             .place = at<&MemberOutputs::failure_ratio>(),
             .shown = Shown::in_headlines,
             .name = "failure_ratio",
             .label = "failure ratio, %",
             .most = 1,
             .percent = true,
             .stops = true,
             .in_designs = true},
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
    Quantity{
        .key = "work_ice_friction",
        .unit = "N",
        .long_name = "mean load that goes into friction between floes and on ice sheets; work over the distance towed",
        .place = at<&MemberOutputs::work, &WorkShares::ice_friction>(),
        .least = no_least,
        .since = 10},
    Quantity{
        .key = "work_ice_crushing",
        .unit = "N",
        .long_name = "mean load that goes into crushing and stopping of floes by floes; work over the distance towed",
        .place = at<&MemberOutputs::work, &WorkShares::ice_crushing>(),
        .least = no_least,
        .since = 10},
    Quantity{.key = "work_hull_friction",
             .unit = "N",
             .long_name = "mean load that goes into friction on the structure; work over the distance towed",
             .place = at<&MemberOutputs::work, &WorkShares::hull_friction>(),
             .least = no_least,
             .since = 10},
    Quantity{
        .key = "work_hull_crushing",
        .unit = "N",
        .long_name =
            "mean load that goes into crushing and stopping of floes by the structure; work over the distance towed",
        .place = at<&MemberOutputs::work, &WorkShares::hull_crushing>(),
        .least = no_least,
        .since = 10},
    Quantity{.key = "work_vertical_drag",
             .unit = "N",
             .long_name = "mean load that goes into drag along the normals of the ice; work over the distance towed",
             .place = at<&MemberOutputs::work, &WorkShares::vertical_drag>(),
             .least = no_least,
             .since = 10},
    Quantity{.key = "work_plane_drag",
             .unit = "N",
             .long_name = "mean load that goes into form and skin drag; work over the distance towed",
             .place = at<&MemberOutputs::work, &WorkShares::plane_drag>(),
             .least = no_least,
             .since = 10},
    Quantity{.key = "work_waves",
             .unit = "N",
             .long_name = "mean load that goes into waves: linear damping of heave; work over the distance towed",
             .place = at<&MemberOutputs::work, &WorkShares::waves>(),
             .least = no_least,
             .since = 10},
    Quantity{.key = "work_joints",
             .unit = "N",
             .long_name = "mean load that goes into bending: damped, released where floes break, or stored; work over "
                          "the distance towed",
             .place = at<&MemberOutputs::work, &WorkShares::joints>(),
             .least = no_least,
             .since = 10},
    Quantity{.key = "work_lifting",
             .unit = "N",
             .long_name = "mean load that goes into lifting and pushing ice under, against weight and buoyancy; work "
                          "over the distance towed",
             .place = at<&MemberOutputs::work, &WorkShares::lifting>(),
             .least = no_least,
             .since = 10},
    Quantity{.key = "work_motion",
             .unit = "N",
             .long_name =
                 "mean load that goes into motion of the ice and the water it carries; work over the distance towed",
             .place = at<&MemberOutputs::work, &WorkShares::motion>(),
             .least = no_least,
             .since = 10},
    Quantity{.key = "work_rest",
             .unit = "N",
             .long_name = "mean load that goes into what steps of finite length lose: the load less all other shares; "
                          "work over the distance towed",
             .place = at<&MemberOutputs::work, &WorkShares::rest>(),
             .least = no_least,
             .since = 10},
    Quantity{.key = "local_order",
             .unit = "1",
             .long_name = "mean cosine of four times the difference in yaw between a floe and its four nearest, at the "
                          "start",
             .place = at<&MemberOutputs::local_order>(),
             .shown = Shown::in_summary,
             .name = "local_order",
             .label = "local order at the start",
             .least = -1,
             .most = 1},
    Quantity{.key = "coverage_ahead",
             .unit = "1",
             .long_name = "share of the structure's path through the field covered by ice at the start",
             .place = at<&MemberOutputs::coverage_ahead>(),
             .shown = Shown::in_summary,
             .name = "coverage_ahead",
             .label = "coverage ahead at the start, %",
             .most = 1,
             .percent = true},
};

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
