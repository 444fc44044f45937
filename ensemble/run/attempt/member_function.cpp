#include "attempt/member_function.hpp"

#include <cstdint>
#include <utility>

#include "member/run_member.hpp"

namespace floes {

MemberResult compute_member(const Campaign& campaign, int number, std::stop_token stop) {
    const MemberKey key = member_key(campaign, number);
    const Scenario& scenario = campaign.cases[static_cast<std::size_t>(key.case_index)].scenario;
    return run_member(scenario, arrangement_seed(campaign, key.case_index), static_cast<std::uint32_t>(key.arrangement),
                      std::move(stop));
}

}  // namespace floes
