#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "findings/key_words.hpp"
#include "year/contour_section.hpp"
#include "year/year_words.hpp"

namespace floes {

Figure contour_figure(const ContourInputs& inputs, const std::vector<ContourOf>& contours) {
    constexpr double largest_dot = 7;  // of the class with most hours
    std::array<std::vector<double>, 2> values;
    for (const ContourOf& one : contours)
        for (const ContourPoint& point : one.curve)
            for (std::size_t k = 0; k < 2; ++k) values[k].push_back(point.value[k]);
    double most = 0;
    for (const ClassHours& one : inputs.classes) {
        most = std::max(most, one.hours);
        for (std::size_t k = 0; k < 2; ++k) values[k].push_back(one.value[k]);
    }
    Figure figure{.description = "Environmental contours of two inputs",
                  .x = axis_around(key_words(inputs.keys[0]).heading(), values[0], true),
                  .y = axis_around(key_words(inputs.keys[1]).heading(), values[1], true),
                  .size = {720, 420}};
    for (const ClassHours& one : inputs.classes)
        figure.dot(one.value[0], one.value[1], "faint", std::max(1.0, largest_dot * std::sqrt(one.hours / most)));
    for (std::size_t k = 0; k < contours.size(); ++k) {
        Figure::Points line;
        for (const ContourPoint& point : contours[k].curve) line.emplace_back(point.value[0], point.value[1]);
        line.push_back(line.front());
        figure.line(std::move(line), colour(k));
        for (const ContourPoint& point : contours[k].points) figure.dot(point.value[0], point.value[1], colour(k), 3);
        figure.legend.emplace_back(colour(k), fmt::format("{} a year", per_year_text(contours[k].per_year)));
    }
    figure.caption = fmt::format(
        "Contours by IFORM: a year has a state outside of a tangent (in standard normal space) with the probability of "
        "the contour. Dots on the lines: the points of the table.{}",
        inputs.classes.empty() ? "" : " Grey dots: the classes of the scatter diagram, their area the hours.");
    return figure;
}

}  // namespace floes
