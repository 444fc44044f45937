#pragma once
// Whether a campaign has enough arrangements: asked of the arrangements in index order only, never in order of arrival.
// A member's run time goes with its load, so those that are there first are the easy ones: a rule that looks at them
// stops too soon and too low. In index order the answer is a function of the campaign alone, the same on any number of
// workers, and what lies beyond the arrangement where it stops is not used.
//
// The rule: 95 % half-width t s / √n, over |mean|, at most the target for each case that it is asked of; for a contrast
// "B - A" that of the paired difference over |mean of A|. It is asked from `minimum` arrangements on, and must have
// held at each of the `look_ahead` arrangements before the one that it stops after: once alone it holds by chance too
// often. After K. Hoad, S. Robinson and R. Davies, "Automated selection of the number of replications for a
// discrete-event simulation", J. Oper. Res. Soc. 61 (2010) 1632-1644.

#include <limits>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "campaign/stop_rule.hpp"

namespace floes {

class PrecisionStop {
  public:
    /// An active rule over cases of these names. `groups`: a number for each case, equal for those that share
    /// arrangements (sharing_groups()), since only they have paired differences; empty: all do. Throws InputError when
    /// the rule names a case that is none of them, asks for nothing, or for a difference of cases that are no pair.
    PrecisionStop(const StopRule& rule, const std::vector<std::string>& cases, const std::vector<int>& groups = {});

    /// The value of one member, in any order; NaN when it failed: then it does not count, but is no gap. Of two values
    /// for one member the first counts.
    void put(int arrangement, int case_index, double value);

    /// The rule holds: the campaign ends after arrangements().
    bool met() const { return met_; }

    /// Arrangements from the first on of which every member is known; once met, those that the rule stopped after.
    int arrangements() const { return arrangements_; }

    /// Largest half-width over its mean, of all that is asked for, at arrangements(); a part of 1. NaN before there are
    /// two values of each.
    double achieved() const;

    double target() const { return rule_.half_width; }

  private:
    // Mean and spread of one case, or of the difference of two, over the prefix (Welford).
    struct Target {
        int case_index = 0;
        std::optional<int> minus;  ///< case that is subtracted, and whose mean the half-width is compared with
        int count = 0;
        double mean = 0;
        double squares = 0;
        double base_mean = 0;

        void add(const std::vector<double>& values);
        double half_width_over_mean() const;
    };

    void take(const std::vector<double>& values);

    StopRule rule_;
    std::size_t cases_;
    std::vector<Target> targets_;
    struct Waiting {
        std::vector<double> values;
        std::vector<bool> known;
    };
    std::map<int, Waiting> waiting_;  ///< arrangements beyond the prefix
    int arrangements_ = 0;
    int held_for_ = 0;  ///< arrangements in a row
    bool met_ = false;
};

}  // namespace floes
