#include "draw/scene.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "draw/canvas.hpp"
#include "tables/units.hpp"

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

/// A bar of this length with ends, and its words behind it; where the next one begins.
double draw_bar(Canvas& canvas, const Vec2& at, double length, const std::string& words, double unit) {
    const double end = 5 * unit;
    canvas.line(at, at + Vec2(length, 0), bright, 2 * unit);
    for (const double x : {0.0, length}) canvas.line(at + Vec2(x, -end), at + Vec2(x, end), bright, 2 * unit);
    return at.x() + length + 10 * unit +
           canvas.text(at + Vec2(length + 10 * unit, 5 * unit), words, bright, 13 * unit) + 20 * unit;
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

std::vector<Vec3> beginning_of(const Moorings& moorings, const FrameLine& line, double most) {
    std::vector<Vec3> points = course(moorings, static_cast<std::size_t>(line.line), line.fairlead, line.anchor);
    for (std::size_t k = 1; k < points.size(); ++k) {
        const double length = (points[k] - points[k - 1]).norm();
        if (length < most) {
            most -= length;
            continue;
        }
        points[k] = points[k - 1] + most / length * (points[k] - points[k - 1]);
        points.resize(k + 1);
    }
    return points;
}

void draw_lines(Canvas& canvas, const Stage& stage, const Frame& frame, const Projection& projection, double unit) {
    const double most = 3 * stage.subject().scenario.structure.shape.largest_radius();
    for (const FrameLine& line : frame.lines) {
        const std::vector<Vec3> points = beginning_of(stage.subject().scenario.moorings, line, most);
        for (std::size_t k = 0; k + 1 < points.size(); ++k)
            if (projection.before(points[k]) && projection.before(points[k + 1]))
                canvas.line(projection.at(points[k]), projection.at(points[k + 1]), ink, 2.5 * unit);
    }
}

void draw_tow(Canvas& canvas, const Stage& stage, const Frame& frame, const Projection& projection, double unit) {
    if (stage.subject().scenario.path.any()) return;  // it goes elsewhere than along +x
    const Structure& structure = stage.subject().scenario.structure;
    const double ahead = structure.speed < 0 ? -1 : 1;
    const double radius = structure.shape.largest_radius();
    const Vec3 from = frame.structure.position + Vec3(1.08 * ahead * radius, structure.shape.top(), 0);
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
    const Vec3 middle = frame.structure.position + Vec3(0, stage.subject().scenario.structure.shape.top(), 0);
    draw(middle, frame.load, ink.faded(0.55), 7 * unit, true);
    draw(middle, frame.load, sum_white, 4 * unit, true);
    draw(middle, {frame.load.x(), 0, 0}, surge_red, 4 * unit, true);
    draw(middle, {0, frame.load.y(), 0}, heave_green, 4 * unit, true);
    draw(middle, {0, 0, frame.load.z()}, sway_blue, 4 * unit, true);
}

void draw_scales(Canvas& canvas, const Stage& stage, const Frame& frame, const Projection& projection, const Vec2& size,
                 double unit, bool forces) {
    const double newton = metres_a_newton(stage) * projection.scale();  // pixels
    const bool both = forces && newton > 0;
    const bool lines = !frame.lines.empty();
    const double width = ((both ? 480 : 400) + (lines ? 130 : 0)) * unit;
    const double height = (both ? 60 : 36) * unit;
    const Vec2 corner(size.x() - width, size.y() - height);
    draw_ground(canvas, corner, size);
    const double left = corner.x() + 14 * unit;
    const double least = 45 * unit;  // a bar is at most two and a half times as long: two and their words fit
    const double metres = round_number(least / projection.scale());
    const double next = draw_bar(canvas, {left, corner.y() + 18 * unit}, metres * projection.scale(),
                                 fmt::format("{:g} m", metres), unit);
    const std::string through =
        fmt::format("through ice, {:g} m/s", std::abs(stage.subject().scenario.structure.speed));
    const double second = corner.y() + (both ? 46 : 23) * unit;
    if (!both) {
        const double x = draw_sample(canvas, {left + 165 * unit, second}, tow_orange, through, unit);
        if (lines) draw_sample(canvas, {x, second}, ink, "mooring line", unit);
        return;
    }
    const double force = round_number(least / newton);
    const Units::Shown newtons = Units(10 * force).of("N");  // the shorter number
    draw_bar(canvas, {next, corner.y() + 18 * unit}, force * newton,
             fmt::format("{:g} {unit}; on floes {:g} {unit}", force * newtons.factor,
                         force * newtons.factor / contact_stretch, fmt::arg("unit", newtons.name)),
             unit);
    double x = draw_sample(canvas, {left, second}, tow_orange, through, unit);
    x = draw_sample(canvas, {x, second}, normal_magenta, "normal", unit);
    x = draw_sample(canvas, {x, second}, friction_teal, "friction on floes", unit);
    if (lines) draw_sample(canvas, {x, second}, ink, "mooring line", unit);
}

namespace {

constexpr int directions = 48;  // of the structure's wall
constexpr std::uint8_t all_edges = 0b1111;

struct Box {
    Vec3 centre;
    Mat3 rotation;
    Vec3 half;
};

/// Collects faces that a picture shows.
class Faces {
  public:
    Faces(const Projection& projection, const Vec2& size) : projection_(projection), size_(size) {}

    /// Looks outward along `normal`; left out where the eye is behind it or the picture elsewhere.
    void add(std::span<const Vec3> corners, const Vec3& normal, const Colour& colour, std::uint32_t edges,
             double clear_water) {
        Vec3 middle = Vec3::Zero();
        for (const Vec3& corner : corners) middle += corner / static_cast<double>(corners.size());
        if (normal.dot(projection_.to_eye(middle)) <= 0) return;
        Face face{.corners = {}, .colour = lit(colour, normal), .edges = edges};
        bool inside = false;
        const double margin = 0.1 * size_.maxCoeff();
        for (const Vec3& corner : corners) {
            if (!projection_.before(corner)) return;
            const Vec3 at = projection_.seen(corner);
            inside |=
                at.x() > -margin && at.y() > -margin && at.x() < size_.x() + margin && at.y() < size_.y() + margin;
            face.corners.push_back(at);
        }
        if (!inside) return;
        if (projection_.to_eye(middle).y() > 0) face.colour = through_water(face.colour, -middle.y(), clear_water);
        faces_.push_back(std::move(face));
    }

    /// A prism of ice, as thick as its box: bit k of `exposed` is its edge k. Sides without lines are drawn all the
    /// same: they close the gaps between elements.
    void add(const Box& box, const Outline& outline, std::uint32_t exposed, const Colour& colour, double clear_water) {
        const auto at = [&](const Corner& corner, double y) {
            return Vec3(box.centre + box.rotation * Vec3(corner.x, y * box.half.y(), corner.z));
        };
        std::vector<Vec3> upper;
        std::vector<Vec3> lower;
        for (std::size_t k = 0; k < outline.size(); ++k) {
            const Corner& from = outline[k];
            const Corner& to = after(outline, k);
            upper.push_back(at(from, 1));
            lower.push_back(at(from, -1));
            const Corner out = outward(outline, k);
            const std::array<Vec3, 4> side{at(from, 1), at(to, 1), at(to, -1), at(from, -1)};
            add(side, box.rotation * Vec3(out.x, 0, out.z), colour, (exposed >> k & 1u) != 0 ? all_edges : 0,
                clear_water);
        }
        add(lower, -box.rotation.col(1), colour, exposed, clear_water);
        add(upper, box.rotation.col(1), colour, exposed, clear_water);
    }

    std::vector<Face> found() && { return std::move(faces_); }

  private:
    const Projection& projection_;
    Vec2 size_;
    std::vector<Face> faces_;
};

/// A face that reaches behind the eye is left out, so none may be long.
std::vector<SheetPart> in_parts(const std::vector<IceSheet>& sheets, double longest) {
    std::vector<SheetPart> parts;
    for (const IceSheet& sheet : sheets) {
        const auto count = [&](double half) { return std::max(1, static_cast<int>(std::lround(2 * half / longest))); };
        const int along = count(sheet.half_extents.x());
        const int across = count(sheet.half_extents.z());
        for (int n = 0; n < along * across; ++n) {
            const int i = n % along;
            const int k = n / along;
            IceSheet box = sheet;
            box.half_extents.x() /= along;
            box.half_extents.z() /= across;
            box.centre.x() += (2 * i + 1 - along) * box.half_extents.x();
            box.centre.z() += (2 * k + 1 - across) * box.half_extents.z();
            const int exposed = (i == 0 ? edge_minus_x : 0) | (i == along - 1 ? edge_plus_x : 0) |
                                (k == 0 ? edge_minus_z : 0) | (k == across - 1 ? edge_plus_z : 0);
            parts.push_back({box, static_cast<std::uint8_t>(exposed)});
        }
    }
    return parts;
}

/// For each element the edges without a joint at that time: bit k for edge k.
std::vector<std::uint32_t> exposed_sides(const IceLayout& layout, const std::vector<bool>& failed) {
    const std::vector<IceLayout::LaidJoint>& joints = layout.joints;
    std::vector<std::uint32_t> exposed;
    for (const IceLayout::LaidElement& one : layout.elements) exposed.push_back((1u << one.corners.size()) - 1);
    for (std::size_t k = 0; k < joints.size(); ++k) {
        if (failed[k]) continue;
        exposed[static_cast<std::size_t>(joints[k].a)] &= ~joints[k].edge_a;
        exposed[static_cast<std::size_t>(joints[k].b)] &= ~joints[k].edge_b;
    }
    return exposed;
}

/// A face that reaches behind the eye is left out, so walls are cut into strips no longer than `longest`, m.
void add_structure(Faces& faces, const Shape& shape, const StructurePose& pose, double longest, double clear_water) {
    const SurfaceMesh surface = shape.mesh(directions);
    const Mat3 turn = pose.orientation().toRotationMatrix();
    for (const std::vector<int>& polygon : surface.polygons) {
        std::vector<Vec3> corners;
        for (const int index : polygon)
            corners.push_back(pose.position + turn * surface.points[static_cast<std::size_t>(index)]);
        const Vec3 normal = turn * surface.normal(polygon);
        if (corners.size() != 4) {
            faces.add(corners, normal, structure_yellow, 0, clear_water);
            continue;
        }
        const Vec3 first = corners[1] - corners[0];
        const Vec3 last = corners[2] - corners[3];
        const int parts = std::max(1, static_cast<int>(std::ceil(std::max(first.norm(), last.norm()) / longest)));
        for (int part = 0; part < parts; ++part) {
            const double from = static_cast<double>(part) / parts;
            const double to = static_cast<double>(part + 1) / parts;
            faces.add(std::array<Vec3, 4>{corners[0] + from * first, corners[0] + to * first, corners[3] + to * last,
                                          corners[3] + from * last},
                      normal, structure_yellow, 0, clear_water);
        }
    }
}

double largest_load_of(const LoadHistory& history) {
    double largest = 0;
    for (std::size_t k = 0; k < history.surge.size(); ++k)
        largest = std::max(largest, Vec3(history.surge[k], history.sway[k], history.heave[k]).norm());
    return largest;
}

}  // namespace

Stage::Stage(RecordingSubject subject, RecordingOutcome outcome)
    : subject_(std::move(subject)),
      outcome_(std::move(outcome)),
      largest_load_(largest_load_of(outcome_.history)),
      layout_(subject_.floes),
      sheets_(in_parts(subject_.channel().sheets, subject_.scenario.floe.length)) {}

int Stage::broken_floes(double time) const {
    const std::vector<std::uint8_t> broken = floes::broken_floes(outcome_.breaks, layout_.floes(), time);
    return static_cast<int>(std::ranges::count(broken, 1));
}

std::vector<Face> Stage::faces(const Frame& frame, const Projection& projection, const Vec2& size,
                               Colouring colouring) const {
    const Scenario& scenario = subject_.scenario;
    const double clear = scenario.structure.shape.draught();
    const std::vector<std::uint8_t> broken = floes::broken_floes(outcome_.breaks, layout_.floes(), frame.time);
    std::vector<bool> failed(layout_.joints.size(), false);
    for (const BreakEvent& event : outcome_.breaks) {
        if (event.time > frame.time) break;
        failed[layout_.joint(event.floe, event.joint)] = true;
    }
    const auto colour = [&](std::size_t k) {
        switch (colouring) {
            case Colouring::piece:
                return piece_colour(frame.pieces[k]);
            case Colouring::speed:
                return scale_colour(frame.elements[k].velocity.norm() / scenario.structure.speed);
            case Colouring::utilisation:
                return frame.utilisation[k] > 1 ? crack_colour : scale_colour(frame.utilisation[k]);
            case Colouring::ice:
                break;
        }
        return broken[static_cast<std::size_t>(layout_.elements[frame.id(k)].floe)] != 0 ? broken_ice : white_ice;
    };
    Faces faces(projection, size);
    for (const auto& [box, exposed] : sheets_)
        faces.add(Box{box.centre, Mat3::Identity(), box.half_extents},
                  corners_of(box.half_extents.x(), box.half_extents.z()), exposed, sheet_ice, clear);
    const std::vector<std::uint32_t> exposed = exposed_sides(layout_, failed);
    for (std::size_t k = 0; k < frame.elements.size(); ++k) {
        const IceLayout::LaidElement& one = layout_.elements[frame.id(k)];
        const Box box{frame.elements[k].position, frame.elements[k].rotation, one.half_extents};
        faces.add(box, one.corners, exposed[frame.id(k)], colour(k), clear);
    }
    add_structure(faces, scenario.structure.shape, frame.structure, scenario.floe.element / 2, clear);
    return std::move(faces).found();
}

}  // namespace floes
