#include "view/camera.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace floes {
namespace {

constexpr double angle_of_view = 32 * std::numbers::pi / 180;

/// A camera that sees `height` m at the target, from the direction `from`.
Camera looking(const Vec3& target, const Vec3& from, const Vec3& up, double height) {
    const double distance = height / (2 * std::tan(angle_of_view / 2));
    return {target + distance * from.normalized(), target, up, angle_of_view, height};
}

}  // namespace

Vec2 plan_of(const RecordingSubject& subject, double structure) {
    if (subject.scenario.field.endless()) return {structure - subject.seen_behind(), structure + subject.seen_ahead()};
    const Channel channel = subject.channel();
    return {channel.begin, channel.end};
}

Camera camera(View view, const RecordingSubject& subject, double structure, double across) {
    // So much ice round the structure that floes are seen to come, to turn and to leave.
    const double seen = 2 * subject.scenario.structure.shape.largest_radius() + 3 * largest_side(subject.floes);
    const double radius = subject.scenario.structure.shape.largest_radius();
    switch (view) {
        case View::above:
            return looking({structure, 0, across}, Vec3::UnitY(), Vec3::UnitX(), 1.3 * seen);
        case View::side: {
            const Vec3 target(structure + 0.1 * seen, 0.5 * subject.scenario.structure.shape.bottom(), across);
            return {target + Vec3(0, 0, 1.02 * radius), target, Vec3::UnitY(), 0, 0.7 * seen};
        }
        case View::below:
            return looking({structure, 0.5 * subject.scenario.structure.shape.bottom(), across}, {1.0, -0.55, 1.1},
                           Vec3::UnitY(), 0.9 * seen);
        case View::plan: {
            const Vec2 x = plan_of(subject, structure);
            const Vec3 middle(x.mean(), 0, 0);
            const double height = 2 * subject.channel().outer_edge;
            return {middle + Vec3(0, height, 0), middle, -Vec3::UnitZ(), 0, height};
        }
        case View::perspective:
            break;
    }
    return looking({structure + 0.15 * seen, 0, across}, {-0.75, 0.75, 1.0}, Vec3::UnitY(), 0.85 * seen);
}

}  // namespace floes
