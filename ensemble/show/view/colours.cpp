#include "view/colours.hpp"

#include <algorithm>
#include <cmath>

namespace floes {
namespace {

constexpr double least_light = 0.60;  // on faces that look away from the sun
constexpr double deepest_tint = 0.85;
constexpr double golden_share = 0.61803398875;

}  // namespace

Colour between(const Colour& a, const Colour& b, double share) {
    const auto mix = [share](double from, double to) { return from + share * (to - from); };
    return {mix(a.red, b.red), mix(a.green, b.green), mix(a.blue, b.blue), mix(a.opacity, b.opacity)};
}

Colour scale_colour(double share) {
    constexpr std::array<Colour, 5> stops{
        {{0.27, 0.22, 0.55}, {0.19, 0.44, 0.62}, {0.13, 0.64, 0.58}, {0.45, 0.80, 0.34}, {0.99, 0.90, 0.15}}};
    const double at = std::clamp(share, 0.0, 1.0) * (stops.size() - 1);
    const std::size_t first = std::min<std::size_t>(static_cast<std::size_t>(at), stops.size() - 2);
    return between(stops[first], stops[first + 1], at - static_cast<double>(first));
}

Colour piece_colour(int piece) {
    const double hue = 6 * std::fmod(golden_share * piece, 1.0);
    const auto part = [hue](double shift) {
        return 0.50 + 0.45 * std::clamp(std::abs(std::fmod(hue + shift, 6.0) - 3) - 1, 0.0, 1.0);
    };
    return {part(0), part(4), part(2)};
}

Colour lit(const Colour& colour, const Vec3& normal) {
    const Vec3 sun = Vec3(-0.35, 0.85, 0.40).normalized();
    const double light = least_light + (1 - least_light) * std::max(0.0, normal.dot(sun));
    return {colour.red * light, colour.green * light, colour.blue * light, colour.opacity};
}

Colour through_water(const Colour& colour, double depth, double clear) {
    if (depth <= 0) return colour;
    return between(colour, sea, deepest_tint * (1 - std::exp(-3 * depth / clear)));
}

}  // namespace floes
