#pragma once
// The numbers of a member: what each is, and the list of them all.

#include <algorithm>
#include <array>
#include <limits>
#include <optional>
#include <ranges>
#include <span>
#include <string_view>
#include <vector>

#include "core/contract.hpp"
#include "member/member_outputs.hpp"

namespace floes {

/// A short text that is a value of its own: constants of the compiler and what is made at run time alike.
class ShortText {
  public:
    constexpr ShortText() = default;
    constexpr ShortText(const char* text) : ShortText(std::string_view{text}) {}
    /// One text after the other. Throws ContractError for what is too long.
    constexpr explicit ShortText(std::string_view text, std::string_view more = "") : size_(text.size() + more.size()) {
        if (size_ > letters_.size()) throw ContractError("A short text is too long.");
        more.copy(letters_.data() + text.copy(letters_.data(), text.size()), more.size());
    }

    constexpr operator std::string_view() const { return view(); }
    constexpr std::string_view view() const { return {letters_.data(), size_}; }
    constexpr bool empty() const { return size_ == 0; }
    friend constexpr bool operator==(const ShortText& one, const ShortText& other) {
        return one.view() == other.view();
    }

  private:
    std::array<char, 160> letters_{};
    std::size_t size_ = 0;
};

/// How fmt writes it.
constexpr std::string_view format_as(const ShortText& text) {
    return text.view();
}

// What a quantity of a member is: its name and unit, where it stands in the outputs, and where it is shown.

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

/// A number of the averaged load.
template <double AveragedLoad::*number>
constexpr double of_averaged(const AveragedLoad& load) {
    return load.*number;
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
    ShortText key;          ///< its name everywhere: column of /members, of CSV and JSON, word of stop.of
    std::string_view unit;  ///< in the file
    ShortText long_name;    ///< in the file and on its page
    Place place;
    Shown shown = Shown::in_file;
    ShortText label = {};  ///< in tables, without the unit
    double least = 0;      ///< values and intervals lie in [least, most]
    double most = no_most;
    bool positive = false;    ///< above 0 in any run: ranges of single runs are taken on a logarithmic scale
    bool percent = false;     ///< shown in percent
    bool count = false;       ///< a whole number whose total over runs is reported too
    bool stops = false;       ///< a stop rule may use it
    bool in_designs = false;  ///< used in the sensitivity to a design's axes
    int since = 0;            ///< minor version of the file's layout 1 that introduced it
    double (*averaged)(const AveragedLoad&) = nullptr;  ///< the same of the averaged load; none: not taken
    double averaging = 0;                               ///< s, that the load is averaged over; 0: every step
    bool of_moored = false;                             ///< of structures that give way alone
    bool for_programs = false;                          ///< in CSV and JSON, but in no table for people

    /// NaN where the outputs do not have that averaging time.
    double of(const MemberOutputs& outputs) const;
    /// Whether it can have the value: a count is a whole number, or NaN where nobody counted.
    bool holds(double value) const;
    constexpr double factor() const { return percent ? 100 : 1; }  ///< displayed value / stored value
};

/// What cracks have made of the ice; `share`: of all floes.
constexpr Quantity crack_quantity(const char* key, const char* label, const char* long_name, Place place, bool share) {
    return {.key = key,
            .unit = "1",
            .long_name = long_name,
            .place = place,
            .shown = Shown::in_summary,
            .label = label,
            .most = share ? 1 : no_most,
            .percent = share,
            .stops = share,
            .since = 12};
}

/// Only a column of /members.
constexpr Quantity column_quantity(ShortText key, std::string_view unit, ShortText long_name, Place place,
                                   double least = 0, int since = 0) {
    return {.key = key, .unit = unit, .long_name = long_name, .place = place, .least = least, .since = since};
}

/// Joints that failed in a mode.
template <FailureMode mode>
constexpr Quantity failures_quantity(const char* key, const char* long_name, const char* label, int since = 0) {
    return {.key = key,
            .unit = "1",
            .long_name = long_name,
            .place = failures_in<mode>(),
            .shown = Shown::in_summary,
            .label = label,
            .count = true,
            .since = since};
}

/// A share of the work of the tow (statistics/work_shares.hpp), by what it goes into.
template <auto share>
constexpr Quantity work_quantity(const char* key, std::string_view into, int since = 10) {
    return column_quantity(key, "N", ShortText("work over the distance towed that goes into ", into),
                           at<&MemberOutputs::work, share>(), no_least, since);
}

/// What swings, by its mean_KEY, sd_KEY and largest_KEY. `words`: before its name in each; `least`: of the last two.
template <auto... swing>
constexpr std::array<Quantity, 3> swing_quantities(std::string_view key, std::string_view unit,
                                                   const std::array<std::string_view, 3>& words, std::string_view name,
                                                   double least, int since) {
    return {column_quantity(ShortText("mean_", key), unit, ShortText(words[0], name), at<swing..., &Swing::mean>(),
                            no_least, since),
            column_quantity(ShortText("sd_", key), unit, ShortText(words[1], name), at<swing..., &Swing::sd>(), least,
                            since),
            column_quantity(ShortText("largest_", key), unit, ShortText(words[2], name),
                            at<swing..., &Swing::largest>(), least, since)};
}

/// A moment on the structure in the window; simulation/hull_loads.hpp has the signs.
template <auto moment>
constexpr auto moment_quantities(std::string_view key, std::string_view name) {
    return swing_quantities<moment>(key, "N m", {"mean ", "SD of the ", "largest "}, name, 0, 13);
}

/// One list after another.
template <class Value, std::size_t... sizes>
constexpr auto joined(const std::array<Value, sizes>&... lists) {
    std::array<Value, (sizes + ...)> all{};
    auto place = all.begin();
    ((place = std::ranges::copy(lists, place).out), ...);
    return all;
}

// The quantities of where the work of the tow goes, of how the floes lay at its start, and of what the solver did. Part
// of quantity.hpp's list.

inline constexpr std::array work_quantities{
    work_quantity<&WorkShares::ice_friction>("work_ice_friction", "friction between floes and on ice sheets"),
    work_quantity<&WorkShares::ice_crushing>("work_ice_crushing", "crushing and stopping of floes by floes"),
    work_quantity<&WorkShares::hull_friction>("work_hull_friction", "friction on the structure"),
    work_quantity<&WorkShares::hull_crushing>("work_hull_crushing", "crushing and stopping of floes by the structure"),
    work_quantity<&WorkShares::vertical_drag>("work_vertical_drag", "drag along the normals of the ice"),
    work_quantity<&WorkShares::plane_drag>("work_plane_drag", "form and skin drag"),
    work_quantity<&WorkShares::waves>("work_waves", "waves: linear damping of heave"),
    work_quantity<&WorkShares::joints>("work_joints", "bending: damped, released where floes break, or stored"),
    work_quantity<&WorkShares::lifting>("work_lifting", "lifting and pushing ice under, against weight and buoyancy"),
    work_quantity<&WorkShares::driving>("work_driving",
                                        "ice sheets that give way and "
                                        "against the wind; negative where these push the ice",
                                        11),
    work_quantity<&WorkShares::motion>("work_motion", "motion of the ice and the water it carries"),
    work_quantity<&WorkShares::giving_way>("work_giving_way",
                                           "motion of the moored "
                                           "structure: damped by moorings, water and thrusters, or stored",
                                           16),
    work_quantity<&WorkShares::rest>("work_rest", "what steps of finite length lose: the load less all other shares"),
    Quantity{.key = "local_order",
             .unit = "1",
             .long_name = "mean cosine of four times the difference in yaw between a floe and its four nearest, at the "
                          "start",
             .place = at<&MemberOutputs::local_order>(),
             .shown = Shown::in_summary,
             .label = "local order at the start",
             .least = -1,
             .most = 1},
    Quantity{.key = "coverage_ahead",
             .unit = "1",
             .long_name = "share of the structure's path through the field covered by ice at the start",
             .place = at<&MemberOutputs::coverage_ahead>(),
             .shown = Shown::in_summary,
             .label = "coverage ahead at the start",
             .most = 1,
             .percent = true},
    column_quantity("mean_sweeps", "1", "sweeps of the solver a step, on average over the run",
                    at<&MemberOutputs::mean_sweeps>(), 0, 10),
};

// The quantities of structures that are not towed straight on: offsets, mooring forces, yaw. Part of quantity.hpp's
// list.

/// Motion of a structure that is not towed straight on; NaN in other members. `number`: of the response.
template <auto number>
constexpr Quantity motion_quantity(const char* key, std::string_view unit, const char* long_name, int since = 13) {
    return column_quantity(key, unit, long_name, at<&MemberOutputs::moored, number>(), no_least, since);
}

/// The same, of which a stop rule can ask a precision relative to its mean.
template <auto number>
constexpr Quantity stopping_motion(const char* key, std::string_view unit, const char* long_name) {
    Quantity quantity = motion_quantity<number>(key, unit, long_name);
    quantity.stops = quantity.of_moored = true;
    return quantity;
}

/// What swings of it; `stops`: a stop rule can ask a precision of its mean.
template <auto number>
constexpr auto motion_swing(std::string_view key, std::string_view unit, std::string_view name, int since = 13,
                            bool stops = false) {
    std::array<Quantity, 3> all = swing_quantities<&MemberOutputs::moored, number>(
        key, unit, {"mean ", "population standard deviation of the ", "largest amount of the "}, name, no_least, since);
    all[0].stops = all[0].of_moored = stops;
    return all;
}

inline constexpr auto motion_quantities = joined(
    motion_swing<&MooredResponse::surge_offset>("surge_offset", "m",
                                                "offset of the moored structure along the surge load", 13, true),
    motion_swing<&MooredResponse::sway_offset>("sway_offset", "m", "offset of the moored structure towards +z"),
    motion_swing<&MooredResponse::yaw>("yaw", "rad", "yaw of the moored structure, positive where +z turns to +x"),
    motion_swing<&MooredResponse::surge_mooring>("surge_mooring", "N",
                                                 "force of springs and lines against the surge load", 13, true),
    motion_swing<&MooredResponse::sway_mooring>("sway_mooring", "N",
                                                "force of springs and lines against the sway load"),
    std::array{stopping_motion<&MooredResponse::mean_maximum>(
                   "mean_maximum_surge_mooring", "N",
                   "mean of the segment maxima of the force of springs and lines against the surge load"),
               motion_quantity<&MooredResponse::rms_velocity>(
                   "rms_surge_velocity", "m s-1",
                   "root mean square of the moored structure's velocity in surge, relative to its anchors"),
               stopping_motion<&MooredResponse::line_tension>(
                   "largest_line_tension", "N",
                   "largest tension of a mooring line over the run, horizontal where it has no weight"),
               Quantity{.key = "broken_lines",
                        .unit = "1",
                        .long_name = "mooring lines that broke",
                        .place = at<&MemberOutputs::moored, &MooredResponse::broken_lines>(),
                        .count = true,
                        .since = 13}},
    motion_swing<&MooredResponse::surge_thrust>("surge_thrust", "N", "force of thrusters against the surge load", 14),
    motion_swing<&MooredResponse::sway_thrust>("sway_thrust", "N", "force of thrusters against the sway load", 14),
    motion_swing<&MooredResponse::yaw_thrust>("yaw_thrust", "N m", "moment of thrusters against the yaw load", 14),
    std::array{motion_quantity<&MooredResponse::thrust_at_limit>(
        "thrust_at_limit", "1", "share of the window in which thrusters are at their limit", 14)},
    motion_swing<&MooredResponse::heave>("heave_offset", "m", "heave of the floating structure, upwards", 15),
    motion_swing<&MooredResponse::pitch>("pitch", "rad", "pitch of the floating structure, positive with the bow up",
                                         15),
    motion_swing<&MooredResponse::roll>("roll", "rad",
                                        "roll of the floating structure, positive with starboard (+z) down", 15));

// The list of scalar quantities of a member: of the journal, the campaign file and its page, the stop rule, summaries,
// pairs and designs. CONTRIBUTING.md says how to add one. Those of the averaged load are made of it: quantities_with().

/// Load and ice, in the order in which they are shown; those of the structure's motion follow.
inline constexpr std::array load_quantities{
    Quantity{.key = "mean_load",
             .unit = "N",
             .long_name = "mean surge load over the window",
             .place = at<&MemberOutputs::load, &LoadStatistics::mean>(),
             .shown = Shown::in_headlines,
             .label = "mean",
             .least = no_least,
             .stops = true,
             .in_designs = true},
    Quantity{.key = "sd_load",
             .unit = "N",
             .long_name = "population standard deviation of the surge load over the window",
             .place = at<&MemberOutputs::load, &LoadStatistics::sd>(),
             .shown = Shown::in_table3,
             .label = "SD",
             .stops = true,
             .in_designs = true,
             .averaged = of_averaged<&AveragedLoad::sd>},
    Quantity{.key = "maximum_load",
             .unit = "N",
             .long_name = "largest surge load in the window",
             .place = at<&MemberOutputs::load, &LoadStatistics::maximum>(),
             .shown = Shown::in_table3,
             .label = "maximum",
             .least = no_least,
             .positive = true,
             .stops = true,
             .averaged = largest_of},
    column_quantity("skewness", "1", "skewness of the surge load over the window",
                    at<&MemberOutputs::load, &LoadStatistics::skewness>(), no_least),
    column_quantity("excess_kurtosis", "1", "excess kurtosis of the surge load over the window",
                    at<&MemberOutputs::load, &LoadStatistics::excess_kurtosis>(), no_least),
    Quantity{.key = "mean_maximum",
             .unit = "N",
             .long_name = "mean of the segment maxima of the surge load",
             .place = at<&MemberOutputs::load, &LoadStatistics::mean_maximum>(),
             .shown = Shown::in_headlines,
             .label = "mean maximum",
             .least = no_least,
             .positive = true,
             .stops = true,
             .in_designs = true,
             .averaged = of_averaged<&AveragedLoad::mean_maximum>},
    Quantity{.key = "sd_maximum",
             .unit = "N",
             .long_name = "population standard deviation of the segment maxima of the surge load",
             .place = at<&MemberOutputs::load, &LoadStatistics::sd_maximum>(),
             .shown = Shown::in_table3,
             .label = "SD maximum",
             .averaged = of_averaged<&AveragedLoad::sd_maximum>},
    Quantity{.key = "failure_ratio",
             .unit = "1",
             .long_name = "broken floes over all floes that were computed, at the end of the run",
             .place = at<&MemberOutputs::failure_ratio>(),
             .shown = Shown::in_headlines,
             .label = "broken floes",
             .most = 1,
             .percent = true,
             .stops = true,
             .in_designs = true},
    column_quantity("floes_entered", "1", "floes that were computed at any time of the run: all of a field with an end",
                    at<&MemberOutputs::floes_entered>(), 0, 13),
    column_quantity("floes_met", "1", "floes that touched the structure at any time of the run",
                    at<&MemberOutputs::floes_met>(), 0, 13),
    Quantity{.key = "met_failure_ratio",
             .unit = "1",
             .long_name = "broken floes among those that touched the structure, over these",
             .place = at<&MemberOutputs::met_failure_ratio>(),
             .most = 1,
             .percent = true,
             .since = 13},
    Quantity{.key = "mean_concentration",
             .unit = "1",
             .long_name = "mean over the window of the ice concentration in a box round the structure, a breadth ahead "
                          "and aside",
             .place = at<&MemberOutputs::mean_concentration>(),
             .percent = true,
             .since = 17},
    column_quantity("pile_height", "m",
                    "mean over the window of the height above the water of the highest ice in that box",
                    at<&MemberOutputs::pile_height>(), 0, 19),
    column_quantity("pile_draught", "m",
                    "mean over the window of the depth below the water of the deepest ice in that box",
                    at<&MemberOutputs::pile_draught>(), 0, 19),
    column_quantity("mean_bed_surge", "N", "mean force of the ice on the bed against the tow over the window",
                    at<&MemberOutputs::mean_bed_surge>(), no_least, 19),
    column_quantity("mean_bed_weight", "N", "mean force of the ice on the bed downwards over the window",
                    at<&MemberOutputs::mean_bed_weight>(), no_least, 19),
    column_quantity("mean_grounded", "m2", "mean area of the elements that bear on the bed over the window",
                    at<&MemberOutputs::mean_grounded>(), 0, 19),
    column_quantity("ice_flux", "m2 s-1",
                    "area of ice that fell astern of the structure in the window, less what came back, over its "
                    "length; of a straight tow, moored or not",
                    at<&MemberOutputs::ice_flux>(), no_least, 17),
    column_quantity("floes_astern", "1",
                    "floes whose middle fell astern of the structure in the window, less those that came back",
                    at<&MemberOutputs::floes_astern>(), no_least, 17),
    crack_quantity("split_ratio", "floes cracked through",
                   "floes that a crack went through, over all floes, at the end of the run",
                   at<&MemberOutputs::split_ratio>(), true),
    crack_quantity("cracked_ratio", "floes with any crack",
                   "floes of which a joint began to crack, over all floes, at the end of the run",
                   at<&MemberOutputs::cracked_ratio>(), true),
    crack_quantity("pieces", "pieces of ice at the end", "pieces of ice at the end of the run",
                   at<&MemberOutputs::pieces>(), false),
    column_quantity("fracture_work", "J", "energy that cracks took over the run, of joints that fail by stress",
                    at<&MemberOutputs::fracture_work>(), 0, 12),
    column_quantity("mean_sway", "N", "mean sway load over the window", at<&MemberOutputs::mean_sway>(), no_least),
    column_quantity("mean_heave", "N", "mean heave load over the window", at<&MemberOutputs::mean_heave>(), no_least),
};

/// The trend of the load, and what it did to the joints; after the moments.
inline constexpr std::array joint_quantities{
    column_quantity("trend", "N s-1", "slope of the surge load over the window",
                    at<&MemberOutputs::load, &LoadStatistics::trend>(), no_least),
    Quantity{.key = "trend_p",
             .unit = "1",
             .long_name = "probability of a slope at least so far from zero if there were none",
             .place = at<&MemberOutputs::load, &LoadStatistics::trend_p>(),
             .most = 1},
    column_quantity("peak_compression", "N", "largest axial compression in any joint over the run",
                    at<&MemberOutputs::peaks, &PeakReactions::compression>()),
    column_quantity("peak_tension", "N", "largest axial tension in any joint over the run",
                    at<&MemberOutputs::peaks, &PeakReactions::tension>()),
    column_quantity("peak_shear", "N", "largest resultant shear in any joint over the run",
                    at<&MemberOutputs::peaks, &PeakReactions::shear>()),
    column_quantity("peak_bending", "N m", "largest bending moment in any joint over the run",
                    at<&MemberOutputs::peaks, &PeakReactions::bending>()),
    column_quantity("peak_torsion", "N m", "largest torsion in any joint over the run",
                    at<&MemberOutputs::peaks, &PeakReactions::torsion>()),
    column_quantity("peak_in_plane_bending", "N m", "largest in-plane bending moment in any joint over the run",
                    at<&MemberOutputs::peaks, &PeakReactions::in_plane_bending>()),
    failures_quantity<FailureMode::bending>("failures_bending", "joints that failed in bending",
                                            "joints failed in bending"),
    failures_quantity<FailureMode::shear>("failures_shear", "joints that failed in shear", "  in shear"),
    failures_quantity<FailureMode::compression>("failures_compression", "joints that failed in compression",
                                                "  in compression"),
    failures_quantity<FailureMode::tension>("failures_tension", "joints that failed in tension", "  in tension", 9),
    failures_quantity<FailureMode::torsion>("failures_torsion", "joints that failed in torsion", "  in torsion", 9),
    failures_quantity<FailureMode::in_plane_bending>(
        "failures_in_plane_bending", "joints that failed in bending in the plane", "  in bending in the plane", 9),
};

/// All of them.
inline constexpr auto quantities =
    joined(load_quantities, moment_quantities<&MemberOutputs::yaw>("yaw_moment", "yaw moment"),
           moment_quantities<&MemberOutputs::roll>("roll_moment", "moment about the tow"),
           moment_quantities<&MemberOutputs::pitch>("pitch_moment", "overturning moment"), joint_quantities,
           work_quantities, motion_quantities);

/// The quantity of that key in the list; nullptr if there is none.
constexpr const Quantity* find_quantity(std::string_view key) {
    const auto* const found = std::ranges::find(quantities, key, [](const Quantity& one) { return one.key.view(); });
    return found == quantities.end() ? nullptr : found;
}

/// `one` of the load averaged over `time`, s: "mean_maximum_0.5s". Shown in pairs at most.
Quantity averaged_over(const Quantity& one, double time);

/// The list with, after each quantity that is taken of the averaged load too, the same for each of `averaging_times`.
/// The maximum of the headlines is then that over 1 s or, without it, over the longest time; those of single steps,
/// which depend on the time step, are named so and for programs.
std::vector<Quantity> quantities_with(std::span<const double> averaging_times);

/// The maximum of the headlines in a list of quantities_with().
const Quantity& headline_maximum(std::span<const Quantity> all);

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
