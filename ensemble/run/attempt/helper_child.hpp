#pragma once
// The child of a helper: one member, one process.

#include <sys/types.h>

#include "attempt/helper_protocol.hpp"
#include "attempt/member_function.hpp"

namespace floes {

/// Computes the member in this process, a fork of the process `helper`, and exits. Never returns.
[[noreturn]] void compute_and_leave(const helper_protocol::Request& request, const Descriptor& socket,
                                    const Campaign& campaign, const MemberFunction& compute, pid_t helper);

}  // namespace floes
