#pragma once
// The next wave: a campaign at points of what is left.

#include <Eigen/Core>

#include <cstdint>
#include <string>
#include <vector>

#include "match/waves.hpp"

namespace floes {

/// The campaign of `wave` at other points: `coordinates` of its axes, a row each. Numbers have six digits, so that they
/// can be read. `seed`: a new one, because on the same floes the errors of waves correlate.
Campaign next_wave(const MatchWave& wave, const std::vector<MatchAxis>& axes, const Eigen::MatrixXd& coordinates,
                   const std::string& name, std::uint64_t seed);

}  // namespace floes
