#pragma once
// How a campaign is run, and when it has enough arrangements: the tables [run] and [stop].

#include <string>
#include <string_view>

#include "core/units.hpp"

namespace floes {

/// What StopRule::of says for the largest load in an exposure, which is no quantity of a member.
inline constexpr std::string_view design_load_word = "design_load";

struct StopRule {
    double half_width = 0;             ///< of the 95 % interval, relative to the mean; 0: all arrangements are run
    std::string of = "mean_load";      ///< key of the quantity that has to be precise
    std::string case_name = "all";     ///< or "none", or the name of one case
    std::string contrast = "none";     ///< or "all", or "B - A" for the paired difference of two cases
    int minimum = 0;                   ///< arrangements before the rule is applied; 0: by half_width, at least 20
    int look_ahead = 5;                ///< further arrangements for which it must stay satisfied
    int batch = 10;                    ///< arrangements handed out before any later one
    double exposure = 3 * unit::hour;  ///< s, of a design load
    double averaging = 1;              ///< s, that a design load is averaged over
    double quantile = 0.9;  ///< probability that a design load is not exceeded in the exposure; 0: the expected largest

    bool of_design_load() const { return of == design_load_word; }
    bool active() const { return half_width > 0; }
    friend bool operator==(const StopRule&, const StopRule&) = default;
};

/// Where a member is computed: in the process that was given it, or in a process of its own.
enum class Isolation { none, process };

struct RunRules {
    Isolation isolation = Isolation::none;
    double member_deadline = 6 * 3600;            ///< s of wall clock for one attempt; 0: none
    double member_memory = 2048.0 * 1024 * 1024;  ///< bytes, for a member in a process of its own; 0: no limit
    bool nominal_modulus = false;                 ///< E of joints that follow Σ is a name only
    std::string base_case = "";                   ///< whose variations all other cases are; empty: none
    int attempts = 2;                             ///< failed ones after which a member is set aside, >= 1
};

}  // namespace floes
