#pragma once
// Where floes fail: a floe with its joints.

#include "findings/evidence.hpp"
#include "tables/section.hpp"

namespace floes {

/// How often each joint failed, and in which modes, of the most loaded cases; empty where no joint failed.
Section joint_failures_section(Evidence& evidence);

}  // namespace floes
