#include "outline/distance.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace floes {

double distance_between(Corners a, Corners b) {
    const double apart = separation(a, b);
    if (apart <= 0) return apart;
    double least = std::numeric_limits<double>::infinity();
    for (const auto& [one, other] : {std::pair(a, b), std::pair(b, a)}) {
        for (std::size_t k = 0; k < one.size(); ++k) {
            const Corner along = after(one, k) - one[k];
            for (const Corner& corner : other) {
                const double share = std::clamp(dot(along, corner - one[k]) / dot(along, along), 0.0, 1.0);
                const Corner left = corner - one[k] - share * along;
                least = std::min(least, std::sqrt(dot(left, left)));
            }
        }
    }
    return least;
}

}  // namespace floes
