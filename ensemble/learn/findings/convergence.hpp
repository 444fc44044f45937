#pragma once
// How the mean load settles as arrangements are added.

#include "findings/evidence.hpp"
#include "tables/section.hpp"

namespace floes {

/// The mean load of the first n arrangements of each case with its 95 % interval, from three on.
Section convergence_section(Evidence& evidence);

}  // namespace floes
