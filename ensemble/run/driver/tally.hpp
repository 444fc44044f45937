#pragma once
// Progress of a run: what existed when its session began, and what the session added. No file, no clock.

#include <chrono>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "driver/heartbeat.hpp"
#include "driver/inventory.hpp"

namespace floes {

class Tally {
  public:
    using Time = std::chrono::steady_clock::time_point;

    /// `campaign` must outlive the tally. `begin`: of the session.
    Tally(const Campaign& campaign, Inventory found, Time begin);

    /// An attempt at the member begins.
    void started(int number, int attempt, Time now);
    /// A member is done or set aside.
    void kept(const MemberRecord& record);

    /// What existed when the session began.
    const Inventory& found() const { return found_; }
    int computed() const { return computed_; }                             ///< members done in this session
    int set_aside() const { return static_cast<int>(set_aside_.size()); }  ///< members set aside in this session
    int done() const { return found_.done + computed_; }                   ///< of this session and before
    int failed() const;  ///< members of published() that are set aside, in this session and before

    /// The campaign's stop rule with the members known so far; empty if there is no rule.
    const std::optional<PrecisionStop>& precision() const { return precision_; }
    /// The stop rule is met: no more members are needed, and the published campaign ends with the arrangement at which
    /// the rule stopped.
    bool precise() const { return precision_ && precision_->met(); }
    /// The campaign as published.
    Campaign published() const;

    /// The member's identity in the journal.
    MemberIdentity identity_of(int number) const;
    /// The heartbeat without host, process and time.
    Heartbeat heartbeat(Time now) const;

  private:
    struct UnderWay {
        int number = 0;
        int attempt = 1;
        Time since{};
    };

    const Campaign& campaign_;
    std::vector<std::string> case_keys_;
    Inventory found_;
    std::optional<PrecisionStop> precision_;
    Time begin_;
    std::map<MemberIdentity, UnderWay> under_way_;
    int computed_ = 0;
    std::vector<int> set_aside_;  // arrangement of each
    double finished_cost_ = 0;    // expected, of both
};

}  // namespace floes
