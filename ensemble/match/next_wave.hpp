#pragma once
// The campaign that looks closer at what is left.

#include <Eigen/Core>

#include <string>
#include <vector>

#include "match/waves.hpp"

namespace floes {

/// The campaign of `wave` at other points: `coordinates` of its axes, a row each. Numbers have six digits, so that they
/// can be read. Its seed and arrangements are those of the wave, so points of both begin from the same floes.
Campaign next_wave(const MatchWave& wave, const std::vector<MatchAxis>& axes, const Eigen::MatrixXd& coordinates,
                   const std::string& name);

}  // namespace floes
