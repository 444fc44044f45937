#pragma once
// What a quantity of a member is: its name and unit, where it stands in the outputs, and where it is shown.

#include <limits>
#include <string_view>

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

/// What cracks have made of the ice; `share`: of all floes.
constexpr Quantity crack_quantity(const char* key, const char* name, const char* label, std::string_view long_name,
                                  Place place, bool share) {
    return {.key = key,
            .unit = "1",
            .long_name = long_name,
            .place = place,
            .shown = Shown::in_summary,
            .name = name,
            .label = label,
            .most = share ? 1 : no_most,
            .percent = share,
            .stops = share,
            .since = 12};
}

/// A number of floes.
constexpr Quantity floe_count(const char* key, std::string_view long_name, Place place) {
    return {.key = key, .unit = "1", .long_name = long_name, .place = place, .since = 13};
}

/// A share of the work of the tow (statistics/work_shares.hpp).
constexpr Quantity work_quantity(const char* key, std::string_view long_name, Place place, int since = 10) {
    return {.key = key, .unit = "N", .long_name = long_name, .place = place, .least = no_least, .since = since};
}

/// A statistic of a moment on the structure in the window; simulation/hull_loads.hpp has the signs.
template <auto moment, auto statistic>
constexpr Quantity moment_quantity(const char* key, std::string_view long_name) {
    const bool has_sign = ShortText(key).view().starts_with("mean");
    return {.key = key,
            .unit = "N m",
            .long_name = long_name,
            .place = at<moment, statistic>(),
            .least = has_sign ? no_least : 0,
            .since = 13};
}

}  // namespace floes
