#include "shapes/path.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace floes {
namespace {

/// The heading `to` as it is reached from `from` by the shorter way: 370 degrees for 10 from 350.
double by_the_shorter_way(double from, double to) {
    constexpr double half = std::numbers::pi * (1 + 1e-12);  // half a turn goes as it is written
    return std::abs(to - from) <= half ? to : from + std::remainder(to - from, 2 * std::numbers::pi);
}

struct Course {
    double heading = 0;
    double speed = 0;
};

/// Legs with the times at which they begin.
class Legs {
  public:
    explicit Legs(const Path& path) : legs_(path.legs), ramp_(path.ramp) {
        for (std::size_t k = 0; k < legs_.size(); ++k) {
            ends_.push_back((ends_.empty() ? 0 : ends_.back()) + legs_[k].time);
            if (k > 0) legs_[k].heading = by_the_shorter_way(end_of(k - 1).heading, legs_[k].heading);
        }
    }

    Course at(double time) const {
        const auto number = static_cast<std::size_t>(std::ranges::upper_bound(ends_, time) - ends_.begin());
        if (number == ends_.size()) return {end_of(number - 1).heading, 0};
        const PathLeg& leg = legs_[number];
        const double since = time - (number > 0 ? ends_[number - 1] : 0);
        const Course before = number > 0 ? end_of(number - 1) : Course{leg.heading, 0};
        const double share = since < ramp_ ? since / ramp_ : 1;
        return {before.heading + share * (leg.heading + leg.turn * since - before.heading),
                before.speed + share * (leg.speed - before.speed)};
    }

  private:
    Course end_of(std::size_t number) const {
        const PathLeg& leg = legs_[number];
        return {leg.heading + leg.turn * leg.time, leg.speed};
    }

    std::vector<PathLeg> legs_;  ///< with headings that go on, beyond a full turn too
    double ramp_;
    std::vector<double> ends_;
};

std::vector<PathPlace> along_legs(const Path& path, double step, int steps) {
    const Legs legs(path);
    const double side = path.of == PathOf::ice ? -1 : 1;
    const auto yaw_of = [&](const Course& course) { return path.bow == PathBow::ahead ? -course.heading : 0; };
    std::vector<PathPlace> places(static_cast<std::size_t>(steps) + 1);
    places.front().pose.yaw = yaw_of(legs.at(0));
    for (std::size_t k = 1; k < places.size(); ++k) {
        const PlanarPose& before = places[k - 1].pose;
        const Course middle = legs.at(step * (static_cast<double>(k) - 0.5));
        PathPlace& place = places[k];
        place.velocity = side * middle.speed * Vec2(std::cos(middle.heading), std::sin(middle.heading));
        place.pose = {before.x + step * place.velocity.x(), before.z + step * place.velocity.y(),
                      yaw_of(legs.at(step * static_cast<double>(k)))};
        place.turning = (place.pose.yaw - before.yaw) / step;
    }
    return places;
}

PlanarPose in_table(const std::vector<PathPoint>& table, double time) {
    const auto next =
        static_cast<std::size_t>(std::ranges::upper_bound(table, time, {}, &PathPoint::time) - table.begin());
    if (next == 0) return {table.front().x, table.front().z, table.front().yaw};
    const PathPoint& a = table[next - 1];
    if (next == table.size()) return {a.x, a.z, a.yaw};
    const PathPoint& b = table[next];
    const double share = (time - a.time) / (b.time - a.time);
    return {a.x + share * (b.x - a.x), a.z + share * (b.z - a.z), a.yaw + share * (b.yaw - a.yaw)};
}

}  // namespace

std::vector<PathPlace> places_of(const Path& path, double step, int steps) {
    if (!path.legs.empty()) return along_legs(path, step, steps);
    std::vector<PathPoint> table = path.table;
    for (std::size_t row = 1; row < table.size(); ++row)
        table[row].yaw = by_the_shorter_way(table[row - 1].yaw, table[row].yaw);
    std::vector<PathPlace> places(static_cast<std::size_t>(steps) + 1);
    places.front().pose = in_table(table, 0);
    for (std::size_t k = 1; k < places.size(); ++k) {
        const PlanarPose& before = places[k - 1].pose;
        const PlanarPose now = in_table(table, step * static_cast<double>(k));
        places[k] = {now, Vec2(now.x - before.x, now.z - before.z) / step, (now.yaw - before.yaw) / step};
    }
    return places;
}

double duration_of(const Path& path) {
    double time = path.table.empty() ? 0 : path.table.back().time;
    for (const PathLeg& leg : path.legs) time += leg.time;
    return time;
}

bool ends_moving(const Path& path) {
    if (!path.legs.empty()) return path.legs.back().speed > 0;
    if (path.table.size() < 2) return false;
    const PathPoint& before = path.table.end()[-2];
    const PathPoint& last = path.table.back();
    return before.x != last.x || before.z != last.z || before.yaw != last.yaw;
}

double way_of(const std::vector<PathPlace>& places, double step) {
    double way = 0;
    for (const PathPlace& place : places) way += step * place.velocity.norm();
    return way;
}

}  // namespace floes
