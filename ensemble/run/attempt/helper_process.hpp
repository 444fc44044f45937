#pragma once
// The loop of the helper: a single thread that sleeps until a request, the end of a child, a closed socket, or a
// deadline.

#include "attempt/member_function.hpp"
#include "core/descriptor.hpp"

namespace floes {

/// Serves requests until the control socket is closed. Never returns.
[[noreturn]] void serve_as_helper(Descriptor control, const MemberFunction& compute);

}  // namespace floes
