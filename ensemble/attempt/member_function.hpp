#pragma once
// What computes a member. The driver is given it, so that tests can drive members that are fast, slow or broken.

#include <functional>
#include <stop_token>

#include "campaign/campaign.hpp"
#include "member/result.hpp"

namespace floes {

/// (campaign, member number, stop): the result, a pure function of the first two. Called from many threads at once.
/// An exception means that the member failed, and its what() is the reason; but after a stop was requested, when the
/// function is to throw soon, it means that the member was abandoned and is to be run again.
using MemberFunction = std::function<MemberResult(const Campaign&, int number, std::stop_token)>;

/// The MemberFunction of every campaign that is meant: run_member() on the scenario of the member's case, with the seed
/// and the number of its arrangement.
MemberResult compute_member(const Campaign& campaign, int number, std::stop_token stop);

}  // namespace floes
