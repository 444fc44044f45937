#include "draw/picture.hpp"

#include <sys/socket.h>
#include <sys/time.h>
#include <unistd.h>
#include <zlib.h>

#include <algorithm>
#include <array>
#include <bitset>
#include <cerrno>
#include <cmath>
#include <cstring>
#include <fstream>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "core/descriptor.hpp"
#include "core/error.hpp"
#include "core/started_program.hpp"
#include "core/text.hpp"
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

/// A dark ground for words, between two corners.
void draw_ground(Canvas& canvas, const Vec2& from, const Vec2& to) {
    canvas.fill(std::array<Vec2, 4>{from, Vec2(to.x(), from.y()), to, Vec2(from.x(), to.y())},
                {0.04, 0.10, 0.16, 0.62});
}

}  // namespace

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

namespace {

/// Mooring lines, at most as far as three radii of the structure. `unit`: pixels that a line is thick, as below.
void draw_lines(Canvas& canvas, const Stage& stage, const Frame& frame, const Projection& projection, double unit) {
    const double most = 3 * stage.subject().scenario.structure.shape.largest_radius();
    for (const FrameLine& line : frame.lines) {
        const std::vector<Vec3> points = beginning_of(stage.subject().scenario.moorings, line, most);
        for (std::size_t k = 0; k + 1 < points.size(); ++k)
            if (projection.before(points[k]) && projection.before(points[k + 1]))
                canvas.line(projection.at(points[k]), projection.at(points[k + 1]), ink, 2.5 * unit);
    }
}

/// An arrow ahead of the structure, as far as the picture goes.
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

/// Forces as lines of Fig. 5: the load in the middle of the structure, normal and friction forces where floes touch.
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

/// Bars for a length and, with `forces`, a force, both as at the structure, and which line is which, in the lower right
/// of a picture of this size.
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

namespace {

constexpr double strip_share = 0.17;  // of the height, for the load over time

double strip_height(const PictureStyle& style) {
    return std::round(strip_share * (style.view == View::plan ? 0.6 * style.width : style.height));
}

/// Sizes of lines and letters go by the picture's width.
double unit_of(const PictureStyle& style) {
    return style.width / 1280.0;
}

void draw_faces(Canvas& canvas, const std::vector<Face>& faces, const Vec2& size, double unit) {
    DepthBuffer drawn(static_cast<int>(size.x()), static_cast<int>(size.y()), sea);
    for (const Face& face : faces) {
        drawn.fill(face.corners, face.colour);
        const Colour dark = between(face.colour, ink, 0.55);
        const std::bitset<32> edges(face.edges);  // the structure's faces have more corners, and no lines
        for (std::size_t k = 0; k < std::min(face.corners.size(), edges.size()); ++k) {
            if (!edges[k]) continue;
            drawn.line(face.corners[k], face.corners[(k + 1) % face.corners.size()], dark, unit);
        }
    }
    canvas.image(Vec2::Zero(), drawn.width(), drawn.height(), drawn.pixels());
}

void draw_words(Canvas& canvas, const Stage& stage, const Frame& frame, const PictureStyle& style) {
    const double unit = unit_of(style);
    const RecordingSubject& subject = stage.subject();
    const double left = 16 * unit;
    draw_ground(canvas, {0, 0}, {440 * unit, 84 * unit});
    canvas.text({left, 28 * unit}, fmt::format("t = {:.2f} s", frame.time), bright, 20 * unit, Align::left, true);
    canvas.text({left, 51 * unit},
                fmt::format("{}, case {}, arrangement {} (member {})", subject.campaign, subject.case_name,
                            subject.arrangement, subject.member),
                bright, 14 * unit);
    canvas.text({left, 72 * unit},
                fmt::format("broken floes: {} of {}", stage.broken_floes(frame.time), subject.floes.size()), bright,
                14 * unit);
    if (style.view == View::plan) return;
    const double right = style.width - 16 * unit;
    draw_ground(canvas, {style.width - 290 * unit, 0}, {style.width, 100 * unit});
    const Units::Shown newtons = Units(frame.load.norm()).of("N");
    struct Line {
        const char* name;
        double value;
        Colour colour;
    };
    const std::array<Line, 4> lines{{{"surge", -frame.load.x(), between(surge_red, bright, 0.35)},
                                     {"sway", frame.load.z(), between(sway_blue, bright, 0.35)},
                                     {"heave", frame.load.y(), between(heave_green, bright, 0.35)},
                                     {"sum", frame.load.norm(), sum_white}}};
    const auto height = [&](std::size_t k) { return (28 + 21 * static_cast<double>(k)) * unit; };
    double widest = 68 * unit;
    for (std::size_t k = 0; k < lines.size(); ++k)
        widest = std::max(widest, canvas.text({right, height(k)},
                                              fmt::format("{:.1f} {}", lines[k].value * newtons.factor, newtons.name),
                                              bright, 16 * unit, Align::right));
    for (std::size_t k = 0; k < lines.size(); ++k)
        canvas.text({right - widest - 16 * unit, height(k)}, lines[k].name, lines[k].colour, 16 * unit, Align::right,
                    true);
}

/// What the colours of the floes say.
void draw_legend(Canvas& canvas, const PictureStyle& style, double bottom, double speed) {
    if (style.colouring == Colouring::piece) return;
    const double unit = unit_of(style);
    const double left = 16 * unit;
    const double size = 14 * unit;
    const auto box = [&](double x, double width, const Colour& colour) {
        canvas.fill(std::array<Vec2, 4>{Vec2(x, bottom - 24 * unit), Vec2(x + width, bottom - 24 * unit),
                                        Vec2(x + width, bottom - 10 * unit), Vec2(x, bottom - 10 * unit)},
                    colour);
    };
    draw_ground(canvas, {0, bottom - 36 * unit}, {440 * unit, bottom});
    const auto word = [&](double x, const std::string& text) {
        return x + canvas.text({x, bottom - 12 * unit}, text, bright, size);
    };
    if (style.colouring == Colouring::ice) {
        box(left, 22 * unit, white_ice);
        const double next = word(left + 28 * unit, "whole floe") + 22 * unit;
        box(next, 22 * unit, broken_ice);
        word(next + 28 * unit, "broken floe");
        return;
    }
    const bool moves = style.colouring == Colouring::speed;
    const double begin = word(left, moves ? "speed  0" : "utilisation of the worst joint  0") + 8 * unit;
    constexpr int steps = 40;
    const double width = 110 * unit / steps;
    for (int k = 0; k < steps; ++k) box(begin + k * width, width + unit, scale_colour((k + 0.5) / steps));
    const double end = word(begin + 118 * unit, moves ? fmt::format("{:.3g} m/s (hull through ice)", speed) : "1");
    if (moves) return;
    box(end + 14 * unit, 22 * unit, crack_colour);
    word(end + 42 * unit, "crack");
}

/// The load over time in the lowest part of the picture.
void draw_history(Canvas& canvas, const Stage& stage, const Frame& frame, const PictureStyle& style) {
    const double unit = unit_of(style);
    const std::vector<double>& surge = stage.outcome().history.surge;
    const double high = strip_height(style);
    const double top = canvas.height() - high;
    const double step = stage.subject().scenario.general.time_step;
    const double width = style.width;
    const std::array<Vec2, 4> strip{Vec2(0, top), Vec2(width, top), Vec2(width, top + high), Vec2(0, top + high)};
    canvas.fill(strip, bright);
    if (surge.empty()) return;
    const bool whole = !(style.to > style.from);
    const double from = whole ? 0 : style.from;
    const double to = whole ? step * static_cast<double>(surge.size()) : style.to;
    const double left = 64 * unit;
    const double right = width - 20 * unit;
    const double bottom = canvas.height() - 30 * unit;
    const double ceiling = top + 14 * unit;
    const auto columns = static_cast<std::size_t>(right - left);
    const auto first = std::min(surge.size() - 1, static_cast<std::size_t>(std::max(0.0, std::floor(from / step))));
    const auto last = std::clamp(static_cast<std::size_t>(std::ceil(to / step)), first + 1, surge.size());
    const auto [least, most] = std::ranges::minmax(std::span(surge).subspan(first, last - first));
    const double low = std::min(0.0, least);
    const double up = most > low ? most : low + 1;
    const auto at = [&](double time, double load) {
        return Vec2(left + (right - left) * (time - from) / (to - from),
                    bottom - (bottom - ceiling) * (load - low) / (up - low));
    };
    std::vector<Vec2> line;
    const std::size_t stride = std::max<std::size_t>(1, (last - first) / columns);
    for (std::size_t k = first; k < last; k += stride) {
        const auto part = std::span(surge).subspan(k, std::min(stride, last - k));
        const double time = step * static_cast<double>(k + 1);
        const auto [small, large] = std::ranges::minmax(part);
        line.push_back(at(time, small));
        line.push_back(at(time, large));
    }
    canvas.line(at(from, 0), at(to, 0), ink.faded(0.35), unit);
    canvas.path(line, {0.10, 0.35, 0.62}, 1.3 * unit);
    canvas.line(at(frame.time, low), at(frame.time, up), ink, 2 * unit);
    const double size = 13 * unit;
    const Units::Shown newtons = Units(up).of("N");
    canvas.text({left - 8 * unit, ceiling + size / 2}, fmt::format("{:.0f} {}", up * newtons.factor, newtons.name), ink,
                size, Align::right);
    canvas.text({left - 8 * unit, at(from, 0).y() + size / 3}, "0", ink, size, Align::right);
    const auto [first_time, last_time] = ends_of_axis(from, to);
    canvas.text({left, bottom + 18 * unit}, first_time, ink, size);
    canvas.text({right, bottom + 18 * unit}, last_time, ink, size, Align::right);
    canvas.text({(left + right) / 2, bottom + 18 * unit}, "surge load, positive against the tow", ink, size,
                Align::middle);
}

}  // namespace

std::pair<std::string, std::string> ends_of_axis(double from, double to) {
    double grain = 1;  // s
    while (grain > 1e-6 && to - from < 10 * grain) grain /= 10;
    const auto words = [grain](double time) { return fmt::format("{:.9g} s", std::round(time / grain) * grain); };
    return {words(from), words(to)};
}

int picture_height(const PictureStyle& style, const RecordingSubject& subject) {
    if (style.view != View::plan) return style.height + style.height % 2;
    const Vec2 x = plan_of(subject, 0);
    const double share = 2 * subject.channel().outer_edge / (x.y() - x.x());
    return 2 * static_cast<int>(std::lround((share * style.width + strip_height(style)) / 2));
}

void draw_picture(Canvas& canvas, const Stage& stage, const Frame& frame, const PictureStyle& style) {
    const Vec2 size(canvas.width(), canvas.height() - strip_height(style));
    const Projection projection(
        camera(style.view, stage.subject(), frame.structure.position.x(), frame.structure.position.z()), size.x(),
        size.y());
    draw_faces(canvas, stage.faces(frame, projection, size, style.colouring), size, unit_of(style));
    const bool forces = style.view != View::plan;
    draw_lines(canvas, stage, frame, projection, unit_of(style));
    draw_tow(canvas, stage, frame, projection, unit_of(style));
    if (forces) draw_forces(canvas, stage, frame, projection, unit_of(style));
    draw_words(canvas, stage, frame, style);
    draw_legend(canvas, style, size.y(), stage.subject().scenario.structure.speed);
    draw_scales(canvas, stage, frame, projection, size, unit_of(style), forces);
    draw_history(canvas, stage, frame, style);
}

namespace {

// Pictures one after another into a film file.

class Encoder {
  public:
    virtual ~Encoder() = default;
    /// All pictures have the same size.
    virtual void add(const Canvas& picture) = 0;
    /// Completes the file. Throws RunError when that fails.
    virtual void finish() = 0;
};

/// What comes in.
struct FilmShape {
    int width = 0;     ///< pixels
    int height = 0;    ///< pixels
    int pictures = 0;  ///< how many
    int rate = 0;      ///< pictures a second
};

/// What ffmpeg is told for each ending. 4:2:0 is what players take.
std::vector<std::string> codec_of(const std::string& ending) {
    if (ending == ".mp4")
        return {"-c:v", "libx264", "-pix_fmt", "yuv420p", "-crf", "23", "-movflags", "+faststart", "-f", "mp4"};
    if (ending == ".webm")
        return {"-c:v", "libvpx-vp9", "-pix_fmt", "yuv420p", "-crf", "34", "-b:v", "0", "-row-mt", "1", "-f", "webm"};
    if (ending == ".webp") return {"-c:v", "libwebp_anim", "-q:v", "40", "-loop", "0", "-f", "webp"};
    if (ending == ".gif")
        return {"-vf", "split[a][b];[a]palettegen=max_colors=128[p];[b][p]paletteuse=dither=none", "-f", "gif"};
    return {};
}

InputError no_ffmpeg(const std::filesystem::path& path, const std::string& why) {
    return InputError(
        fmt::format("{} is made by ffmpeg, which cannot be started ({}); install the package ffmpeg, or give the film "
                    "the ending .apng, which needs nothing else.",
                    path.string(), why));
}

/// Pictures through a socket to ffmpeg.
class Ffmpeg final : public Encoder {
  public:
    Ffmpeg(std::filesystem::path path, const FilmShape& shape, Seconds longest_picture)
        : path_(std::move(path)), longest_picture_(longest_picture), pictures_(shape.pictures) {
        std::array<int, 2> ends{};  // a socket, which tells of a reader that is gone by an error and not by a signal
        if (::socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends.data()) != 0)
            throw RunError(fmt::format("A socket to ffmpeg cannot be made ({}).", std::strerror(errno)));
        Descriptor read_end(ends[0]);
        write_end_ = Descriptor(ends[1]);
        std::vector<std::string> words{"ffmpeg",    "-y",
                                       "-loglevel", "error",
                                       "-f",        "rawvideo",
                                       "-pix_fmt",  "bgr0",
                                       "-s",        fmt::format("{}x{}", shape.width, shape.height),
                                       "-r",        std::to_string(shape.rate),
                                       "-i",        "-"};
        for (std::string& word : codec_of(path_.extension().string())) words.push_back(std::move(word));
        words.push_back(path_.string());
        const auto microseconds = std::chrono::duration_cast<std::chrono::microseconds>(longest_picture).count();
        const timeval limit{microseconds / 1'000'000, microseconds % 1'000'000};
        ::setsockopt(write_end_.get(), SOL_SOCKET, SO_SNDTIMEO, &limit, sizeof limit);
        process_.emplace(std::move(words), StartedProgram::Streams{.in = read_end.get(), .errors = STDERR_FILENO});
        if (!process_->fault().empty()) throw no_ffmpeg(path_, process_->fault());
    }

    void add(const Canvas& picture) override {
        std::span<const std::uint8_t> left = picture.pixels();
        while (!left.empty()) {
            const ssize_t written = ::send(write_end_.get(), left.data(), left.size(), MSG_NOSIGNAL);
            if (written < 0 && errno == EINTR) continue;
            if (written < 0 && (errno == EAGAIN || errno == EWOULDBLOCK))
                throw too_slow("took no picture", longest_picture_);
            if (written < 0) fail();
            left = left.subspan(static_cast<std::size_t>(written));
        }
    }

    void finish() override {
        write_end_.close();
        const Seconds longest = longest_picture_ + Seconds(pictures_);  // a .gif is made when its last picture is known
        if (!process_->wait(longest)) throw too_slow("did not end", longest);
        if (process_->status() != 0) fail();
    }

  private:
    [[noreturn]] void fail() const {
        throw RunError(fmt::format("ffmpeg could not write {}; its messages are above.", path_.string()));
    }

    RunError too_slow(const char* what, Seconds longest) const {
        return RunError(fmt::format(
            "ffmpeg, which makes {}, {} within {} and was ended; give the film the ending .apng, which needs "
            "no other program.",
            path_.string(), what, duration_in_figures(longest.count())));
    }

    std::filesystem::path path_;
    Seconds longest_picture_;
    int pictures_;
    Descriptor write_end_;
    std::optional<StartedProgram> process_;  // the last: it is ended before its socket is closed
};

constexpr std::size_t length_and_type = 8;
constexpr std::size_t signature_bytes = 8;
constexpr std::size_t crc_bytes = 4;

std::string big_endian(std::uint32_t value, int bytes = 4) {
    std::string text;
    for (int k = bytes - 1; k >= 0; --k) text.push_back(static_cast<char>(value >> (8 * k) & 0xff));
    return text;
}

/// An animated PNG: the chunks of one picture after another, numbered (PNG specification, third edition, 11.3).
class AnimatedPng final : public Encoder {
  public:
    AnimatedPng(std::filesystem::path path, const FilmShape& shape)
        : path_(std::move(path)), file_(path_, std::ios::binary), shape_(shape) {}

    void add(const Canvas& picture) override {
        const std::string png = picture.png();
        const bool first = next_ == 0;
        std::string data;
        for (std::size_t at = signature_bytes; at + length_and_type + crc_bytes <= png.size();) {
            std::uint32_t length = 0;
            for (std::size_t k = 0; k < 4; ++k) length = length << 8 | static_cast<unsigned char>(png[at + k]);
            const std::string type = png.substr(at + 4, 4);
            const std::string payload = png.substr(at + length_and_type, length);
            if (type == "IHDR" && first) {
                file_ << png.substr(0, signature_bytes);
                chunk(type, payload);
                chunk("acTL", big_endian(static_cast<std::uint32_t>(shape_.pictures)) + big_endian(0));
            }
            if (type == "IDAT") data += payload;
            at += length_and_type + length + crc_bytes;
        }
        chunk("fcTL", big_endian(next_++) + big_endian(static_cast<std::uint32_t>(picture.width())) +
                          big_endian(static_cast<std::uint32_t>(picture.height())) + big_endian(0) + big_endian(0) +
                          big_endian(1, 2) + big_endian(static_cast<std::uint32_t>(shape_.rate), 2) +
                          std::string(2, '\0'));
        if (first) {
            chunk("IDAT", data);
        } else {
            chunk("fdAT", big_endian(next_++) + data);
        }
    }

    void finish() override {
        chunk("IEND", {});
        file_.close();
        if (!file_)
            throw RunError(fmt::format("{} cannot be written ({}); does the folder exist, and has it free space?",
                                       path_.string(), std::strerror(errno)));
    }

  private:
    void chunk(const std::string& type, const std::string& payload) {
        const std::string body = type + payload;
        const auto* bytes = reinterpret_cast<const unsigned char*>(body.data());
        file_ << big_endian(static_cast<std::uint32_t>(payload.size())) << body
              << big_endian(static_cast<std::uint32_t>(::crc32_z(0, bytes, body.size())));
    }

    std::filesystem::path path_;
    std::ofstream file_;
    FilmShape shape_;
    std::uint32_t next_ = 0;  ///< number of the next chunk of a frame
};

/// By the ending of `path`, as write_film().
std::unique_ptr<Encoder> make_encoder(const std::filesystem::path& path, const FilmShape& shape,
                                      Seconds longest_picture) {
    const std::string ending = path.extension().string();
    if (ending == ".apng") return std::make_unique<AnimatedPng>(path, shape);
    if (codec_of(ending).empty())
        throw InputError(
            fmt::format("{} has no ending of a film; give .mp4, .webm, .webp, .gif or .apng.", path.string()));
    return std::make_unique<Ffmpeg>(path, shape, longest_picture);
}

}  // namespace

void expect_encoder(const std::filesystem::path& path) {
    if (!codec_of(path.extension().string()).empty() && !is_program("ffmpeg"))
        throw no_ffmpeg(path, "it is not in the PATH");
}

void write_film(const std::filesystem::path& path, const Recording& recording, const PictureStyle& style, int rate,
                const std::function<void(double)>& progress, Seconds longest_picture) {
    const Stage stage(recording.subject(), recording.outcome());
    const int height = picture_height(style, recording.subject());
    const std::unique_ptr<Encoder> film =
        make_encoder(path, {style.width, height, recording.frames(), rate}, longest_picture);
    Canvas picture(style.width, height);
    Frame frame;
    for (int k = 0; k < recording.frames(); ++k) {
        recording.read(k, frame);
        draw_picture(picture, stage, frame, style);
        film->add(picture);
        progress(static_cast<double>(k + 1) / recording.frames());
    }
    film->finish();
}

}  // namespace floes
