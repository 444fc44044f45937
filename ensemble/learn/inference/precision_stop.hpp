#pragma once
// Whether a campaign has enough arrangements, judged in index order only, never in order of arrival. A member's run
// time grows with its load, so members with small loads arrive first, and a rule based on them would stop too early
// with a mean that is too low. In index order the result depends on the campaign alone, for any number of workers, and
// arrangements after the stop are not used.
//
// The rule: 95 % half-width t s / √n, over |mean|, is at most the target for each case that the rule names; for a
// contrast "B - A" it is that of the paired difference, over |mean of A|. Where members stand out, it is the longer
// side of the interval that counts them as a kind of their own (mixed_mean.hpp). The rule applies from `minimum`
// arrangements on, by default so many that a kind of member in a share of the target is missing in at most one of
// twenty campaigns (members with twice the load move the mean by their share, and nobody knows of those that were not
// met), and must also hold at each of the `look_ahead` arrangements before the stop, because it is often met once by
// chance. After K. Hoad, S. Robinson and R. Davies, "Automated selection of the number of replications for a
// discrete-event simulation", J. Oper. Res. Soc. 61 (2010) 1632-1644.

#include <limits>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "campaign/rules.hpp"

namespace floes {

class PrecisionStop {
  public:
    /// An active rule over cases of these names. `groups`: a number for each case, equal for cases that share
    /// arrangements (sharing_groups()), because only those can be paired; empty: all share them. Throws InputError if
    /// the rule names an unknown case, names nothing, or asks for the difference of cases that cannot be paired.
    PrecisionStop(const StopRule& rule, const std::vector<std::string>& cases, const std::vector<int>& groups = {});

    /// Adds the value of one member, in any order; NaN if it failed: it is then not counted, but leaves no gap. Of two
    /// values for one member the first counts.
    void put(int arrangement, int case_index, double value);

    /// The rule is met: the campaign ends after arrangements().
    bool met() const { return met_; }

    /// Number of leading arrangements of which every member is known; once met, the number at which the rule stopped.
    int arrangements() const { return arrangements_; }

    /// Largest half-width over its mean, of all targets, at arrangements(); a fraction. NaN before there are two values
    /// of each.
    double achieved() const;

    double target() const { return rule_.half_width; }

    /// Arrangements before which the rule is not applied.
    int minimum() const { return minimum_; }

  private:
    // One case, or the difference of two, over the leading arrangements; mean and squares after Welford.
    struct Target {
        int case_index = 0;
        std::optional<int> minus;  ///< case that is subtracted; its mean is the reference of the half-width
        int count = 0;
        double mean = 0;
        double squares = 0;
        double base_mean = 0;
        std::vector<double> taken = {};

        void add(const std::vector<double>& values);
        double half_width_over_mean() const;
        double by_student() const;
    };

    void take(const std::vector<double>& values);

    StopRule rule_;
    int minimum_;
    std::size_t cases_;
    std::vector<Target> targets_;
    struct Waiting {
        std::vector<double> values;
        std::vector<bool> known;
    };
    std::map<int, Waiting> waiting_;  ///< later arrangements, by number
    int arrangements_ = 0;
    int held_for_ = 0;  ///< consecutive arrangements
    bool met_ = false;
};

}  // namespace floes
