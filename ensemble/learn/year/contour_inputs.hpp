#pragma once
// The ice of an environmental contour: two inputs with their joint distribution, and the hours that such ice is there.

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "inference/joint_inputs.hpp"

namespace floes {

struct ContourInputs {
    std::array<std::string, 2> keys;  ///< "ice.thickness_m"
    JointInputs inputs;
    double time = 0;                       ///< s in a year with this ice, above 0
    std::vector<ClassHours> classes = {};  ///< of a scatter diagram
    std::optional<JointFit> fit = {};      ///< to these
};

/// Reads what floes design --regimes reads, CSV (by the file's name) or TOML: a scatter diagram of two inputs, to which
/// a joint distribution is fitted. Or TOML with the distributions:
///
///     hours_per_year = 770
///     [[input]]
///     key = "ice.thickness_m"
///     distribution = "weibull"
///     scale = 0.029
///     shape = 4.1
///     [[input]]
///     key = "structure.speed_m_s"
///     distribution = "lognormal"
///     median = [0.1, 3.0, 1.5]        # 0.1 + 3.0 x^1.5, x the first input
///     sd_log = 0.3
///
/// Throws InputError, one sentence, as read_regimes() does, and for anything but two inputs, fewer than 3 values of
/// either, values that are not positive, and parameters that a distribution does not have or cannot have.
ContourInputs read_contour_inputs(std::string_view text, const std::string& file);

}  // namespace floes
