#include "picture/forces.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "picture/canvas.hpp"
#include "tables/number_text.hpp"

namespace floes {
namespace {

constexpr double least_shown = 0.004;  // of the largest load: smaller contact forces are not drawn
constexpr double contact_stretch = 2;  // arrows of contacts are so much longer than those of the load

/// Length of a newton of the load, m; 0 without any load.
double metres_a_newton(const Stage& stage) {
    const double largest = stage.largest_load();
    return largest > 0 ? 2.2 * stage.subject().scenario.structure.shape.largest_radius() / largest : 0;
}

/// 1, 2 or 5 times a power of ten, at least `value`.
double round_number(double value) {
    const double power = std::pow(10, std::floor(std::log10(value)));
    for (const double factor : {1.0, 2.0, 5.0})
        if (factor * power >= value * (1 - 1e-9)) return factor * power;
    return 10 * power;
}

/// A bar of this length with ends, and its words behind it.
void draw_bar(Canvas& canvas, const Vec2& at, double length, const std::string& words, double unit) {
    const double end = 5 * unit;
    canvas.line(at, at + Vec2(length, 0), bright, 2 * unit);
    for (const double x : {0.0, length}) canvas.line(at + Vec2(x, -end), at + Vec2(x, end), bright, 2 * unit);
    canvas.text(at + Vec2(length + 10 * unit, 5 * unit), words, bright, 13 * unit);
}

/// A length of line in this colour, and what it means; where the next one begins.
double draw_sample(Canvas& canvas, const Vec2& at, const Colour& colour, const std::string& words, double unit) {
    canvas.line(at + Vec2(0, -4 * unit), at + Vec2(18 * unit, -4 * unit), bright, 5 * unit);
    canvas.line(at + Vec2(0, -4 * unit), at + Vec2(18 * unit, -4 * unit), colour, 3 * unit);
    return at.x() + 24 * unit + canvas.text(at + Vec2(24 * unit, 0), words, bright, 13 * unit) + 16 * unit;
}

}  // namespace

void draw_ground(Canvas& canvas, const Vec2& from, const Vec2& to) {
    canvas.fill(std::array<Vec2, 4>{from, Vec2(to.x(), from.y()), to, Vec2(from.x(), to.y())},
                {0.04, 0.10, 0.16, 0.62});
}

void draw_lines(Canvas& canvas, const Stage& stage, const Frame& frame, const Projection& projection, double unit) {
    const double most = 3 * stage.subject().scenario.structure.shape.largest_radius();
    for (const FrameLine& line : frame.lines) {
        const Vec3 way = line.anchor - line.fairlead;
        const Vec3 end = line.fairlead + std::min(1.0, most / way.norm()) * way;
        if (!projection.before(line.fairlead) || !projection.before(end)) continue;
        canvas.line(projection.at(line.fairlead), projection.at(end), ink, 2.5 * unit);
    }
}

void draw_tow(Canvas& canvas, const Stage& stage, const Frame& frame, const Projection& projection, double unit) {
    if (stage.subject().scenario.path.any()) return;  // it goes elsewhere than along +x
    const Structure& structure = stage.subject().scenario.structure;
    const double ahead = structure.speed < 0 ? -1 : 1;
    const double radius = structure.shape.largest_radius();
    const Vec3 from(frame.structure.x + 1.08 * ahead * radius, structure.shape.top(), frame.structure.z);
    const Vec3 to = from + Vec3(0.75 * ahead * radius, 0, 0);
    if (!projection.before(from) || !projection.before(to)) return;
    canvas.arrow(projection.at(from), projection.at(to), tow_orange, 5 * unit);
}

void draw_forces(Canvas& canvas, const Stage& stage, const Frame& frame, const Projection& projection, double unit) {
    const double largest = stage.largest_load();
    const double metres = metres_a_newton(stage);
    if (!(metres > 0)) return;
    const auto draw = [&](const Vec3& from, const Vec3& force, const Colour& colour, double width, bool head) {
        const Vec3 to = from + metres * force;
        if (!projection.before(from) || !projection.before(to)) return;
        if (head) {
            canvas.arrow(projection.at(from), projection.at(to), colour, width);
        } else {
            canvas.line(projection.at(from), projection.at(to), colour, width);
        }
    };
    for (const FrameContact& contact : frame.contacts) {
        if ((contact.normal + contact.friction).norm() < least_shown * largest) continue;
        draw(contact.point, contact_stretch * contact.normal, normal_magenta, 1.8 * unit, false);
        draw(contact.point, contact_stretch * contact.friction, friction_teal, 1.8 * unit, false);
    }
    const Vec3 middle(frame.structure.x, stage.subject().scenario.structure.shape.top(), frame.structure.z);
    draw(middle, frame.load, ink.faded(0.55), 7 * unit, true);
    draw(middle, frame.load, sum_white, 4 * unit, true);
    draw(middle, {frame.load.x(), 0, 0}, surge_red, 4 * unit, true);
    draw(middle, {0, frame.load.y(), 0}, heave_green, 4 * unit, true);
    draw(middle, {0, 0, frame.load.z()}, sway_blue, 4 * unit, true);
}

void draw_scales(Canvas& canvas, const Stage& stage, const Projection& projection, const Vec2& size, double unit,
                 bool forces) {
    const double newton = metres_a_newton(stage) * projection.scale();  // pixels
    const bool both = forces && newton > 0;
    const double width = (both ? 480 : 330) * unit;
    const double height = (both ? 60 : 36) * unit;
    const Vec2 corner(size.x() - width, size.y() - height);
    draw_ground(canvas, corner, size);
    const double left = corner.x() + 14 * unit;
    const double metres = round_number(60 * unit / projection.scale());
    draw_bar(canvas, {left, corner.y() + 18 * unit}, metres * projection.scale(), fmt::format("{:g} m", metres), unit);
    const double speed = std::abs(stage.subject().scenario.structure.speed);
    const double second = corner.y() + (both ? 46 : 23) * unit;
    if (!both) {
        draw_sample(canvas, {left + 165 * unit, second}, tow_orange, fmt::format("tow, {:g} m/s", speed), unit);
        return;
    }
    const double force = round_number(60 * unit / newton);
    const LoadUnit newtons = load_unit(10 * force);  // the shorter number
    draw_bar(canvas, {left + 150 * unit, corner.y() + 18 * unit}, force * newton,
             fmt::format("{:g} {unit}; on floes {:g} {unit}", force * newtons.factor,
                         force * newtons.factor / contact_stretch, fmt::arg("unit", newtons.name)),
             unit);
    double x = draw_sample(canvas, {left, second}, tow_orange, fmt::format("tow, {:g} m/s", speed), unit);
    x = draw_sample(canvas, {x, second}, normal_magenta, "normal", unit);
    draw_sample(canvas, {x, second}, friction_teal, "friction on floes", unit);
}

}  // namespace floes
