// The points of a design.

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <boost/random/sobol.hpp>
#include <cctype>
#include <charconv>
#include <cmath>
#include <numeric>
#include <set>

#include "campaign/design.hpp"
#include "core/random.hpp"

namespace floes {
namespace {

constexpr std::size_t longest_name = 24;
constexpr int digits = 10;

/// Points in the unit cube, one row a point.
using UnitPoints = std::vector<std::vector<double>>;

UnitPoints latin_hypercube(std::size_t points, std::size_t axes, std::uint64_t seed) {
    UnitPoints all(points, std::vector<double>(axes));
    for (std::size_t axis = 0; axis < axes; ++axis) {
        RandomStream random(seed, static_cast<std::uint32_t>(axis), StreamId::latin_hypercube, points);
        std::vector<std::size_t> part(points);
        std::iota(part.begin(), part.end(), std::size_t{0});
        for (std::size_t left = points; left > 1; --left)
            std::swap(part[left - 1], part[random.below(static_cast<std::uint32_t>(left))]);
        for (std::size_t p = 0; p < points; ++p)
            all[p][axis] = (static_cast<double>(part[p]) + random.uniform()) / static_cast<double>(points);
    }
    return all;
}

UnitPoints sobol(std::size_t points, std::size_t dimensions, std::uint64_t seed) {
    constexpr int unused_bits = 64 - 53;
    std::vector<std::uint64_t> shift(dimensions);
    for (std::size_t d = 0; d < dimensions; ++d) {
        RandomStream random(seed, static_cast<std::uint32_t>(d), StreamId::sobol_shift, 0);
        shift[d] = static_cast<std::uint64_t>(random.uniform() * 0x1p53);
    }
    boost::random::sobol sequence(dimensions);
    UnitPoints all(points, std::vector<double>(dimensions));
    for (std::size_t p = 0; p < points; ++p) {
        for (std::size_t d = 0; d < dimensions; ++d) {
            const std::uint64_t bits = p == 0 ? 0 : sequence() >> unused_bits;  // Boost skips the first point, 0
            all[p][d] = static_cast<double>(bits ^ shift[d]) * 0x1p-53;
        }
    }
    return all;
}

/// A, B and A with one axis from B, for each base point in turn.
UnitPoints saltelli(std::size_t base_points, std::size_t axes, std::uint64_t seed) {
    UnitPoints all;
    for (const std::vector<double>& both : sobol(base_points, 2 * axes, seed)) {
        const auto middle = both.begin() + static_cast<std::ptrdiff_t>(axes);
        const std::vector<double> a(both.begin(), middle);
        all.push_back(a);
        all.emplace_back(middle, both.end());
        for (std::size_t axis = 0; axis < axes; ++axis) {
            all.push_back(a);
            all.back()[axis] = both[axes + axis];
        }
    }
    return all;
}

double rounded(double value) {
    const std::string text = fmt::format("{:.{}g}", value, digits);
    std::from_chars(text.data(), text.data() + text.size(), value);
    return value;
}

Value on_axis(const DesignAxis& axis, double unit) {
    // Half a number beyond either end: then each whole number is met equally often.
    const double beyond = axis.whole ? 0.5 : 0;
    const double low = axis.from - beyond;
    const double high = axis.to + beyond;
    const double value =
        axis.scale == AxisScale::log ? low * std::exp(unit * std::log(high / low)) : low + unit * (high - low);
    const double inside = std::clamp(axis.whole ? std::floor(value + 0.5) : rounded(value), axis.from, axis.to);
    return axis.whole ? Value{static_cast<std::int64_t>(inside)} : Value{inside};
}

std::string numbered(std::size_t point, std::size_t count) {
    const std::size_t width = std::max<std::size_t>(3, fmt::format("{}", count - 1).size());
    return fmt::format("p{:0{}}", point, width);
}

/// "0.03_open"; empty where the values are no short name.
std::string named_by_values(const std::vector<Value>& values) {
    std::vector<std::string> words;
    for (const Value& value : values) {
        const auto* word = std::get_if<std::string>(&value.data);
        words.push_back(word != nullptr ? *word : to_text(value));
    }
    const std::string name = fmt::format("{}", fmt::join(words, "_"));
    const auto plain = [](unsigned char c) { return std::isalnum(c) || c == '_' || c == '-' || c == '+' || c == '.'; };
    return name.size() <= longest_name && std::ranges::all_of(name, plain) ? name : "";
}

void name_points(std::vector<DesignPoint>& points, bool by_values) {
    std::set<std::string> names;
    for (DesignPoint& point : points) {
        if (by_values) point.name = named_by_values(point.values);
        by_values = by_values && !point.name.empty() && names.insert(point.name).second;
        if (!by_values) break;
    }
    if (by_values) return;
    for (std::size_t p = 0; p < points.size(); ++p) points[p].name = numbered(p, points.size());
}

std::vector<DesignPoint> given_points(const Design& design) {
    std::vector<DesignPoint> points(static_cast<std::size_t>(point_count(design)));
    for (std::size_t p = 0; p < points.size(); ++p) {
        std::size_t rest = p;
        points[p].values.resize(design.axes.size());
        for (std::size_t i = design.axes.size(); i-- > 0;) {
            const std::vector<Value>& values = design.axes[i].values;
            points[p].values[i] = values[design.method == DesignMethod::list ? p : rest % values.size()];
            rest /= values.size();
        }
    }
    return points;
}

UnitPoints unit_points(const Design& design, std::uint64_t seed) {
    const auto points = static_cast<std::size_t>(design.points);
    if (design.method == DesignMethod::latin_hypercube) return latin_hypercube(points, design.axes.size(), seed);
    if (design.indices) return saltelli(points, design.axes.size(), seed);
    return sobol(points, design.axes.size(), seed);
}

}  // namespace

std::int64_t point_count(const Design& design) {
    if (design.has_ranges()) {
        const std::int64_t each = design.indices ? static_cast<std::int64_t>(design.axes.size()) + 2 : 1;
        return std::min(each * design.points, most_cases + 1);
    }
    if (design.axes.empty()) return 0;
    std::int64_t count = 1;
    const auto length = static_cast<std::int64_t>(design.axes.front().values.size());
    for (const DesignAxis& axis : design.axes) {
        const auto own = static_cast<std::int64_t>(axis.values.size());
        if (design.method == DesignMethod::list && own != length) return 0;
        count = std::min(count * own, most_cases + 1);
    }
    return design.method == DesignMethod::list ? length : count;
}

std::vector<DesignPoint> design_points(const Design& design, std::uint64_t seed) {
    if (!design.has_ranges()) {
        std::vector<DesignPoint> points = given_points(design);
        name_points(points, true);
        return points;
    }
    std::vector<DesignPoint> points;
    for (const std::vector<double>& unit : unit_points(design, seed)) {
        DesignPoint& point = points.emplace_back();
        for (std::size_t i = 0; i < unit.size(); ++i) point.values.push_back(on_axis(design.axes[i], unit[i]));
    }
    name_points(points, false);
    return points;
}

}  // namespace floes
