#pragma once
// A campaign of two cases, small and short, in which floes jam and break; and its campaign file.

#include <filesystem>
#include <vector>

#include "campaign/campaign.hpp"
#include "campaign_file/publish.hpp"
#include "run/attempt.hpp"
#include "store/member_record.hpp"
#include "support/jam_scenario.hpp"

namespace floes::jam {

inline Campaign campaign() {
    Scenario scenario = jam_scenario();
    Campaign made;
    made.name = "jam";
    made.seed = 7;
    made.arrangements = 2;
    made.cases.push_back({"soft", scenario});
    scenario.joint.cfm = 1e-10;
    made.cases.push_back({"stiff", scenario});
    return made;
}

inline std::vector<MemberRecord> records(const Campaign& campaign) {
    std::vector<MemberRecord> made;
    for (int number = 0; number < member_count(campaign); ++number) {
        const MemberKey key = member_key(campaign, number);
        MemberRecord& record = made.emplace_back();
        record.case_key = case_fingerprint(campaign, key.case_index);
        record.arrangement = key.arrangement;
        record.result = compute_member(campaign, number, {});
    }
    return made;
}

}  // namespace floes::jam
