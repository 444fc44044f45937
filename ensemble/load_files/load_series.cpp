#include "load_files/load_series.hpp"

#include <algorithm>
#include <cmath>

#include "core/contract.hpp"
#include "core/vector.hpp"

namespace floes {

LoadSeries load_series(const HullHistories& stored, LoadAxes axes, double tow_towards) {
    FLOES_EXPECTS(stored.sway.size() == stored.surge.size() && stored.heave.size() == stored.surge.size());
    FLOES_EXPECTS(stored.yaw.empty() || stored.yaw.size() == stored.surge.size());
    FLOES_EXPECTS(stored.pitch.empty() || stored.pitch.size() == stored.surge.size());
    FLOES_EXPECTS(stored.roll.size() == stored.pitch.size());
    LoadSeries series{.step = stored.step,
                      .force = {},
                      .moment = {stored.yaw_load.begin(), stored.yaw_load.end()}};  // about y: our y is their Z
    for (std::size_t k = 0; k < stored.surge.size(); ++k) {
        // Yaw turns the bow to port, and so from X towards Y.
        const bool turned = axes == LoadAxes::earth;
        const double angle = turned ? tow_towards + (stored.yaw.empty() ? 0 : stored.yaw[k]) : 0;
        Vec3 load(-stored.surge[k], stored.heave[k], stored.sway[k]);  // ahead, up, to starboard
        if (!stored.pitch.empty())
            load = StructurePose{.pitch = stored.pitch[k], .roll = stored.roll[k]}.orientation() * load;
        const double ahead = load.x();
        const double to_port = -load.z();
        series.force[0].push_back(ahead * std::cos(angle) - to_port * std::sin(angle));
        series.force[1].push_back(ahead * std::sin(angle) + to_port * std::cos(angle));
        series.force[2].push_back(load.y());
    }
    return series;
}

LoadSeries scaled(LoadSeries series, double scale) {
    FLOES_EXPECTS(scale > 0);
    series.step *= std::sqrt(scale);
    for (std::vector<double>& along : series.force)
        for (double& value : along) value *= scale * scale * scale;
    for (double& value : series.moment) value *= scale * scale * scale * scale;
    return series;
}

std::size_t whole_steps(double from, double to, double step) {
    constexpr double rounding = 1e-6;  // of a step: 0.3 s are three steps of 0.1 s
    return to > from ? static_cast<std::size_t>((to - from) / step + rounding) : 0;
}

namespace {

/// Means over the new cells of values over the old ones.
std::vector<double> means(const std::vector<double>& old, double old_step, double from, double step,
                          std::size_t count) {
    std::vector<double> made;
    made.reserve(count);
    for (std::size_t k = 0; k < count; ++k) {
        const double begin = from + step * static_cast<double>(k);
        const double end = begin + step;
        double sum = 0;
        double length = 0;
        for (auto cell = static_cast<std::size_t>(begin / old_step); cell < old.size(); ++cell) {
            const double its_begin = old_step * static_cast<double>(cell);
            if (its_begin >= end) break;
            const double shared = std::min(end, its_begin + old_step) - std::max(begin, its_begin);
            if (shared <= 0) continue;
            sum += shared * old[cell];
            length += shared;
        }
        made.push_back(sum / length);
    }
    return made;
}

}  // namespace

LoadSeries resampled(const LoadSeries& series, double from, double to, double step) {
    const std::size_t count = whole_steps(from, to, step);
    FLOES_EXPECTS(from >= 0 && count > 0 && to <= series.length() * (1 + 1e-9));
    LoadSeries made{.step = step, .force = {}, .moment = {}};
    for (std::size_t axis = 0; axis < 3; ++axis)
        made.force[axis] = means(series.force[axis], series.step, from, step, count);
    if (!series.moment.empty()) made.moment = means(series.moment, series.step, from, step, count);
    return made;
}

std::array<double, 4> impulse(const LoadSeries& series) {
    const auto of = [&](const std::vector<double>& values) {
        double sum = 0;
        for (const double value : values) sum += value;
        return sum * series.step;
    };
    return {of(series.force[0]), of(series.force[1]), of(series.force[2]), of(series.moment)};
}

}  // namespace floes
