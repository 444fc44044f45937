#pragma once
// Environmental contours: the ice that they are of, and what people are shown of them.

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "inference/joint_inputs.hpp"
#include "tables/section.hpp"

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

struct ContourRequest {
    std::vector<double> per_year{1e-2, 1e-4};  ///< probabilities that a year has a state beyond, falling
    double state = 3 * 3600;                   ///< s, of each of the independent states of a year
    int points = 12;                           ///< on each contour
};

struct ContourOf {
    double per_year = 0;
    double radius = 0;
    std::vector<ContourPoint> points;
    std::vector<ContourPoint> curve;  ///< the same with many points, for pictures
};

/// One for each probability. Throws InputError, one sentence, where there are so few states that none is exceeded so
/// rarely, and where the parameters of the second input do not exist for some value of the first.
std::vector<ContourOf> find_contours(const ContourInputs& inputs, const ContourRequest& request);

std::vector<Section> contour_sections(const ContourInputs& inputs, const ContourRequest& request,
                                      const std::vector<ContourOf>& contours);

Figure contour_figure(const ContourInputs& inputs, const std::vector<ContourOf>& contours);

}  // namespace floes
