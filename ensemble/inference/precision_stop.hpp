#pragma once
// How well the design value of each case is known, of the load or of how a structure gives way: the longer side of the
// 95 % interval of the estimate by both tails, over the estimate. It is what floes design gives for the same members,
// with its defaults.

#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "campaign/campaign.hpp"
#include "core/units.hpp"
#include "inference/design_load.hpp"
#include "inference/paired.hpp"

namespace floes {

/// What a member says of a design value.
struct MeasuredPeaks {
    PeakRow peaks;
    MemberTrend trend;
};

class DesignPrecision {
  public:
    /// For the design value of the campaign's stop rule, in the cases with `watched`.
    DesignPrecision(const Campaign& campaign, std::vector<bool> watched);

    /// What the member of a case says; none if it did not measure it.
    std::optional<MeasuredPeaks> peaks_of(std::size_t case_index, const MemberOutputs& outputs) const;

    /// Adds the next member of a case, in index order.
    void add(std::size_t case_index, MeasuredPeaks member);

    /// Fits the tails of all watched cases: tenths of a second each. Deterministic.
    void judge();

    /// From the last judge(): the largest over the watched cases, a fraction; NaN if one has no design value, and
    /// before.
    double half_width() const { return half_width_; }
    /// Why it is NaN, "case E60: the load rises, …", without a full stop; empty if it is known or was not judged.
    const std::string& obstacle() const { return obstacle_; }

  private:
    struct OneCase {
        std::string name;
        Analysis analysis;
        double separation = 0;  ///< s, of peaks
        bool watched = false;
        std::vector<PeakRow> rows = {};
        std::vector<MemberTrend> trends = {};
    };

    double half_width_of(const OneCase& one);

    const DesignOf* of_;
    Exposure exposure_;
    double averaging_;
    bool of_expected_;
    std::vector<OneCase> cases_;
    double half_width_;
    std::string obstacle_;
};

// Whether a campaign has enough arrangements, judged in index order only, never in order of arrival. A member's run
// time grows with its load, so members with small loads arrive first, and a rule based on them would stop too early
// with a mean that is too low. In index order the result depends on the campaign alone, for any number of workers, and
// arrangements after the stop are not used.
//
// The rule: 95 % half-width t s / √n, over |mean|, is at most the target for each case that the rule names; for a
// contrast "B - A" it is that of the paired difference, over |mean of A|. Where members stand out, it is the longer
// side of the interval that counts them as a kind of their own (interval.hpp). The rule applies from `minimum`
// arrangements on, by default so many that a kind of member in a share of the target is missing in at most one of
// twenty campaigns (members with twice the load move the mean by their share, and nobody knows of those that were not
// met), and must also hold at each of the `look_ahead` arrangements before the stop, because it is often met once by
// chance. After K. Hoad, S. Robinson and R. Davies, "Automated selection of the number of replications for a
// discrete-event simulation", J. Oper. Res. Soc. 61 (2010) 1632-1644.
//
// For a design value it is the longer side of its interval over its estimate, for each case that
// the rule names. A tail is fitted in tenths of a second to seconds, so it is judged at ends of batches only, and not
// at each while the target is far: the next judgement is at half of the arrangements that an interval would need that
// shrinks as 1/√n, but a tenth to four tenths more than now. Once it holds it must hold again after `look_ahead`
// further ones.

class PrecisionStop {
  public:
    /// An active rule over cases of these names. `groups`: a number for each case, equal for cases that share
    /// arrangements (sharing_groups()), because only those can be paired; empty: all share them. Throws InputError if
    /// the rule names an unknown case, names nothing, or asks for the difference of cases that cannot be paired.
    PrecisionStop(const StopRule& rule, const std::vector<std::string>& cases, const std::vector<int>& groups = {});

    /// The rule of a campaign, which is active, over its cases; throws likewise.
    explicit PrecisionStop(const Campaign& campaign);

    /// Adds one member, in any order; nullptr if it failed: it is then not counted, but leaves no gap. Of two records
    /// of one member the first counts.
    void put_member(int arrangement, int case_index, const MemberOutputs* outputs);

    /// The same with the value that is to be precise, NaN if the member failed; not of a design value.
    void put(int arrangement, int case_index, double value);

    /// The rule is met: the campaign ends after arrangements().
    bool met() const { return met_; }

    /// Number of leading arrangements of which every member is known; once met, the number at which the rule stopped.
    int arrangements() const { return arrangements_; }

    /// Largest half-width over its mean, of all targets, at judged(); a fraction. NaN before there are two values of
    /// each, and where there is no design value.
    double achieved() const;

    /// Number of leading arrangements that achieved() is of: arrangements(), or fewer where it is of a design value.
    int judged() const { return design_ ? judged_ : arrangements_; }

    /// Why achieved() is not known, without a full stop; empty if that is plain.
    std::string obstacle() const { return design_ ? design_->obstacle() : std::string{}; }

    /// Brings achieved() to arrangements(), for who wants to know; when the rule is met does not depend on it.
    void look();

    double target() const { return rule_.half_width; }

    /// Arrangements before which the rule is not applied.
    int minimum() const { return minimum_; }

    /// The share of all members in which a kind of member is missing, in at most one of twenty campaigns, of so many
    /// arrangements as the rule asks for where stop.minimum is not given.
    static double share_seen(const StopRule& rule);

  private:
    /// What a member says; of one that failed nothing.
    struct Said {
        double value = undefined;              ///< that is to be precise
        std::optional<MeasuredPeaks> peaks{};  ///< for a design value
    };
    /// Of an arrangement, one a case; none of one that is not known yet.
    using Members = std::vector<std::optional<Said>>;

    // One case, or the difference of two, over the leading arrangements; mean and squares after Welford.
    struct Target {
        int case_index = 0;
        std::optional<int> minus;  ///< case that is subtracted; its mean is the reference of the half-width
        int count = 0;
        double mean = 0;
        double squares = 0;
        double base_mean = 0;
        std::vector<double> taken = {};

        void add(const Members& members);
        double half_width_over_mean() const;
        double by_student() const;
    };

    static std::vector<Target> targets_of(const StopRule& rule, const std::vector<std::string>& cases,
                                          const std::vector<int>& groups);

    void take_in(int arrangement, int case_index, Said said);
    void take(const Members& members);
    void take_peaks(const Members& members);
    int end_of_batch(double arrangements) const;
    int next_judgement(bool holds) const;

    StopRule rule_;
    int minimum_;
    std::size_t cases_;
    std::vector<Target> targets_;
    std::map<int, Members> waiting_;  ///< later arrangements, by number
    int arrangements_ = 0;
    int held_for_ = 0;  ///< consecutive arrangements
    bool met_ = false;

    std::optional<DesignPrecision> design_;  ///< of a design value
    int judged_ = 0;                         ///< arrangements of its last judgement
    int next_ = 0;                           ///< of the next one that counts
    int held_from_ = 0;                      ///< of the first one of those that hold now; 0: it does not hold
};

}  // namespace floes
