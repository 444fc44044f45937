#pragma once
// How well the design load of each case is known: the longer side of the 95 % interval of the estimate by both tails,
// over the estimate. It is what floes design gives for the same members, with its defaults.

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "campaign/campaign.hpp"
#include "inference/design_load.hpp"
#include "inference/joint_trend.hpp"

namespace floes {

/// What a member says of a design load.
struct MemberLoad {
    PeakRow peaks;
    MemberTrend trend;
};

class LoadPrecision {
  public:
    /// For the design load of the campaign's stop rule, in the cases with `watched`; all cases are needed, because
    /// whether one rises is tested over all.
    LoadPrecision(const Campaign& campaign, std::vector<bool> watched);

    /// What the member of a case says; none if it did not average its load over the rule's time.
    std::optional<MemberLoad> member_load(std::size_t case_index, const MemberOutputs& outputs) const;

    /// Adds the next member of a case, in index order.
    void add(std::size_t case_index, MemberLoad member);

    /// Fits the tails of all watched cases: tenths of a second each. Deterministic.
    void judge();

    /// Of the last judge(): the largest over the watched cases, a fraction; NaN if one has no design load, and before.
    double half_width() const { return half_width_; }
    /// Why it is NaN, "case E60: the load rises by …", without a full stop; empty if it is known or was not judged.
    const std::string& obstacle() const { return obstacle_; }

  private:
    struct OneCase {
        std::string name;
        Analysis analysis;
        bool watched = false;
        std::vector<PeakRow> rows = {};
        std::vector<MemberTrend> trends = {};
    };

    double half_width_of(const OneCase& one, const JointTrend& trend);

    Exposure exposure_;
    double averaging_;
    bool of_expected_;
    std::vector<OneCase> cases_;
    double half_width_;
    std::string obstacle_;
};

}  // namespace floes
