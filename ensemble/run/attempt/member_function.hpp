#pragma once
// The function that computes a member. It is an argument of the driver, so that tests can pass fast, slow or broken
// members.

#include <functional>
#include <stop_token>

#include "campaign/campaign.hpp"
#include "member/result.hpp"

namespace floes {

/// (campaign, member number, stop): the result, a pure function of the first two. Called from many threads at once. An
/// exception means that the member failed; its what() is the reason. After a stop request the function must throw soon,
/// and the exception means that the member was abandoned and is to be run again.
using MemberFunction = std::function<MemberResult(const Campaign&, int number, std::stop_token)>;

/// The MemberFunction of real campaigns: run_member() on the scenario of the member's case, with the seed and the
/// number of its arrangement.
MemberResult compute_member(const Campaign& campaign, int number, std::stop_token stop);

}  // namespace floes
