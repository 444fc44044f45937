#include "match/next_wave.hpp"

#include <fmt/format.h>

#include <cmath>
#include <set>

#include "keys/read.hpp"
#include "scenario/keys.hpp"

namespace floes {
namespace {

/// A number of six digits, as an axis takes it.
Value value_of(const DesignAxis& axis, double number) {
    Value value;
    if (axis.whole) {
        value.data = static_cast<std::int64_t>(std::llround(number));
    } else {
        value.data = std::stod(fmt::format("{:.6g}", number));
    }
    return value;
}

}  // namespace

Campaign next_wave(const MatchWave& wave, const std::vector<MatchAxis>& axes, const Eigen::MatrixXd& coordinates,
                   const std::string& name, std::uint64_t seed) {
    Campaign next = wave.campaign;
    next.name = name;
    next.seed = seed;
    next.cases.clear();
    next.design.method = DesignMethod::list;
    next.design.points = 0;
    next.design.indices = false;
    for (std::size_t k = 0; k < axes.size(); ++k) {
        DesignAxis& axis = next.design.axes[k];
        axis.values.clear();
        for (Eigen::Index row = 0; row < coordinates.rows(); ++row)
            axis.values.push_back(value_of(axis, axes[k].value(coordinates(row, static_cast<Eigen::Index>(k)))));
    }
    std::set<std::string> bases;
    for (const Case& one : wave.campaign.cases) {
        if (!bases.insert(one.base).second) continue;
        for (Eigen::Index row = 0; row < coordinates.rows(); ++row) {
            Case& made = next.cases.emplace_back(one);
            made.point = static_cast<int>(row);
            made.name = fmt::format("{}{}p{:03}", one.base, one.base.empty() ? "" : "+", row);
            const Keys keys = describe(made.scenario);
            for (const DesignAxis& axis : next.design.axes)
                assign(*find_key(keys, axis.key), {axis.key, axis.values[static_cast<std::size_t>(row)], "next wave"});
        }
    }
    return next;
}

}  // namespace floes
