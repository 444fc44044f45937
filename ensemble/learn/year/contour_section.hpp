#pragma once
// An environmental contour as sections and as a figure.

#include <vector>

#include "tables/section.hpp"
#include "year/contour_inputs.hpp"

namespace floes {

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
