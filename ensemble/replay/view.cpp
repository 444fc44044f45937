#include "replay/view.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/contract.hpp"

namespace floes {

Projection::Projection(const Camera& camera, double width, double height)
    : eye_(camera.eye),
      forward_((camera.target - camera.eye).normalized()),
      right_(forward_.cross(camera.up).normalized()),
      up_(right_.cross(forward_)),
      middle_(width / 2, height / 2),
      depth_((camera.target - camera.eye).norm()),
      scale_(height / camera.height),
      parallel_(camera.angle == 0) {}

Vec2 Projection::at(const Vec3& point) const {
    const Vec3 from_eye = point - eye_;
    const double scale = parallel_ ? scale_ : scale_ * depth_ / from_eye.dot(forward_);
    return middle_ + scale * Vec2(from_eye.dot(right_), -from_eye.dot(up_));
}

Vec3 Projection::seen(const Vec3& point) const {
    const Vec2 on_picture = at(point);
    const double depth = (point - eye_).dot(forward_);
    return {on_picture.x(), on_picture.y(), parallel_ ? 1 - depth / (2 * depth_) : depth_ / depth};
}

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

constexpr double least_light = 0.60;  // on faces that look away from the sun
constexpr double deepest_tint = 0.85;
constexpr double golden_share = 0.61803398875;

Colour between(const Colour& a, const Colour& b, double share) {
    FLOES_EXPECTS(share >= 0 && share <= 1);
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
