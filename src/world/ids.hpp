#pragma once
// What the bodies and joints of a World are called.

#include "core/id.hpp"

namespace floes {

using BodyId = Id<struct BodyTag>;    ///< in order of creation in a World
using JointId = Id<struct JointTag>;  ///< in order of creation in a World; used again after removal by put_in alone

}  // namespace floes
