#include "shapes/catenary.hpp"

#include <boost/math/tools/toms748_solve.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "core/contract.hpp"

namespace floes {

namespace {

/// Where a function that rises is 0, above `low`; `guess` > 0 is the first width of the search.
template <class Rising>
double root_above(const Rising& f, double low, double guess) {
    double at_low = f(low);
    if (at_low >= 0) return low;
    double high = low + guess;
    double at_high = f(high);
    while (at_high < 0) {
        low = high;
        at_low = at_high;
        guess *= 4;
        high += guess;
        at_high = f(high);
    }
    if (at_high == 0) return high;
    std::uintmax_t most = 200;
    const auto enough = [](double a, double b) {
        return std::abs(b - a) <= 1e-13 * std::max(std::abs(a), std::abs(b));
    };
    const auto [from, to] = boost::math::tools::toms748_solve(f, low, high, at_low, at_high, enough, most);
    return 0.5 * (from + to);
}

double down_lying(const Cable& cable, double along, double z) {
    const double strain = cable.stiffness;
    const double tension =
        strain * (std::sqrt(1 + 2 * (along + cable.weight * z + along * along / (2 * strain)) / strain) - 1);
    return std::sqrt(std::max(0.0, (tension - along) * (tension + along)));
}

double down_hanging(const Cable& cable, double along, double z) {
    const double all = cable.weight * cable.length;
    const auto rise = [&](double down) {
        const double above = std::hypot(along, down);
        const double below = std::hypot(along, down - all);
        return (above - below) / cable.weight + cable.length / cable.stiffness * (down - 0.5 * all) - z;
    };
    return root_above(rise, 0.5 * all, all);  // at half of the weight both ends are level
}

double down(const Cable& cable, double along, double z) {
    const double lying = down_lying(cable, along, z);
    return lying <= cable.weight * cable.length ? lying : down_hanging(cable, along, z);
}

double reach(const Cable& cable, double along, double down) {
    const auto [length, weight, stiffness, friction] = cable;
    const double bow = along / weight;
    const double stretched = along * length / stiffness;
    const double resting = length - down / weight;
    if (resting < 0) return bow * (std::asinh(down / along) - std::asinh((down - weight * length) / along)) + stretched;
    double held = 0;
    if (friction > 0) {
        const double loose = resting - bow / friction;
        held = friction * weight / (2 * stiffness) * (loose * std::max(loose, 0.0) - resting * resting);
    }
    return resting + bow * std::asinh(down / along) + stretched + held;
}

}  // namespace

double CablePull::tension() const {
    return std::hypot(along, down);
}

CablePull hang(const Cable& cable, double x, double z) {
    FLOES_EXPECTS(x >= 0 && z > 0 && cable.length > 0 && cable.weight > 0 && cable.stiffness > 0);
    const double all = cable.weight * cable.length;
    const double straight_down = down_lying(cable, 0, z);
    if (straight_down <= all && x <= cable.length - straight_down / cable.weight)
        return {0, straight_down, cable.length - straight_down / cable.weight, 0};
    const double least = 1e-9 * all;
    const double along =
        root_above([&](double pull) { return reach(cable, pull, down(cable, pull, z)) - x; }, least, all);
    const double found = down(cable, along, z);
    const double resting = std::max(0.0, cable.length - found / cable.weight);
    const double anchor =
        resting > 0 ? std::max(0.0, along - cable.friction * cable.weight * resting) : std::hypot(along, found - all);
    return {along, found, resting, anchor};
}

std::vector<Vec2> course(const Cable& cable, double x, double z, int parts) {
    const CablePull pull = hang(cable, x, z);
    const double hanging = cable.length - pull.resting;
    const double lowest = pull.down - cable.weight * hanging;  // V where it leaves the bottom, or at the anchor
    /// From there to the point `length` farther up.
    const auto from_below = [&](double length) {
        const double down = lowest + cable.weight * length;
        const double rise = (std::hypot(pull.along, down) - std::hypot(pull.along, lowest)) / cable.weight +
                            (down + lowest) / 2 * length / cable.stiffness;
        if (pull.along == 0) return Vec2(0, rise);
        return Vec2(pull.along / cable.weight * (std::asinh(down / pull.along) - std::asinh(lowest / pull.along)) +
                        pull.along * length / cable.stiffness,
                    rise);
    };
    const double leaves = x - from_below(hanging).x();
    std::vector<Vec2> points;
    for (int k = 0; k <= parts; ++k) {
        const double length = cable.length * (parts - k) / parts;
        if (length < pull.resting)
            points.emplace_back(leaves * length / pull.resting, 0);
        else
            points.emplace_back(Vec2(leaves, 0) + from_below(length - pull.resting));
    }
    return points;
}

}  // namespace floes
