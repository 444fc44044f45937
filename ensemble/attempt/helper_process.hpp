#pragma once
// The helper at work: a single thread that sleeps until a request, the end of a child, a parent that hung up, or a
// deadline.

#include "attempt/member_function.hpp"
#include "core/descriptor.hpp"

namespace floes {

/// Does all that a helper does, until the control socket is closed. Never returns.
[[noreturn]] void serve_as_helper(Descriptor control, const MemberFunction& compute);

}  // namespace floes
