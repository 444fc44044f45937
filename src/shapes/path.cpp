#include "shapes/path.hpp"

#include <algorithm>
#include <cmath>

namespace floes {
namespace {

struct Course {
    double heading = 0;
    double speed = 0;
};

/// Legs with the times at which they begin.
class Legs {
  public:
    explicit Legs(const Path& path) : path_(path) {
        for (const PathLeg& leg : path.legs) ends_.push_back((ends_.empty() ? 0 : ends_.back()) + leg.time);
    }

    Course at(double time) const {
        const auto number = static_cast<std::size_t>(std::ranges::upper_bound(ends_, time) - ends_.begin());
        if (number == ends_.size()) return {end_of(number - 1).heading, 0};
        const PathLeg& leg = path_.legs[number];
        const double since = time - (number > 0 ? ends_[number - 1] : 0);
        const Course before = number > 0 ? end_of(number - 1) : Course{leg.heading, 0};
        const double share = since < path_.ramp ? since / path_.ramp : 1;
        return {before.heading + share * (leg.heading + leg.turn * since - before.heading),
                before.speed + share * (leg.speed - before.speed)};
    }

  private:
    Course end_of(std::size_t number) const {
        const PathLeg& leg = path_.legs[number];
        return {leg.heading + leg.turn * leg.time, leg.speed};
    }

    const Path& path_;
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
    std::vector<PathPlace> places(static_cast<std::size_t>(steps) + 1);
    places.front().pose = in_table(path.table, 0);
    for (std::size_t k = 1; k < places.size(); ++k) {
        const PlanarPose& before = places[k - 1].pose;
        const PlanarPose now = in_table(path.table, step * static_cast<double>(k));
        places[k] = {now, Vec2(now.x - before.x, now.z - before.z) / step, (now.yaw - before.yaw) / step};
    }
    return places;
}

double way_of(const std::vector<PathPlace>& places, double step) {
    double way = 0;
    for (const PathPlace& place : places) way += step * place.velocity.norm();
    return way;
}

}  // namespace floes
