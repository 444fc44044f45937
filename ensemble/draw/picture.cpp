#include "draw/picture.hpp"

#include <algorithm>
#include <array>
#include <bitset>
#include <cmath>
#include <limits>

#include <fmt/format.h>

#include "core/contract.hpp"
#include "core/units.hpp"
#include "tables/figure.hpp"
#include "tables/units.hpp"

namespace floes {

namespace {

constexpr double least_shown = 0.004;  // of the largest load: smaller contact forces are not drawn
constexpr double contact_stretch = 2;  // arrows of contacts are so much longer than those of the load

/// How far an arrow goes from there along `way` before it leaves the picture, in lengths of `way`, at most 1; 0 where
/// it begins outside.
double reach(const Projection& projection, const Vec2& size, const Vec3& from, const Vec3& way) {
    const double margin = 0.03 * size.y();
    const auto inside = [&](double share) {
        const Vec3 tip = from + share * way;
        if (!projection.before(tip)) return false;
        const Vec2 at = projection.at(tip);
        return at.x() > margin && at.y() > margin && at.x() < size.x() - margin && at.y() < size.y() - margin;
    };
    if (!inside(0)) return 0;
    if (inside(1)) return 1;
    double in = 0;
    double out = 1;
    while (out - in > 1e-3) {
        const double middle = (in + out) / 2;
        (inside(middle) ? in : out) = middle;
    }
    return in;
}

/// Where arrows of the load begin.
Vec3 middle_of(const Stage& stage, const Frame& frame) {
    return frame.structure.position + Vec3(0, stage.subject().scenario.structure.shape.top(), 0);
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

/// Between two corners.
void draw_box(Canvas& canvas, const Vec2& from, const Vec2& to, const Colour& colour) {
    canvas.fill(std::array<Vec2, 4>{from, Vec2(to.x(), from.y()), to, Vec2(from.x(), to.y())}, colour);
}

/// A dark ground for words.
void draw_ground(Canvas& canvas, const Vec2& from, const Vec2& to) {
    draw_box(canvas, from, to, {0.04, 0.10, 0.16, 0.62});
}

}  // namespace

double metres_a_newton(const Stage& stage, const Frame& frame, const Projection& projection, const Vec2& size) {
    const double largest = stage.largest_load();
    if (!(largest > 0)) return 0;
    const double metres = 2.2 * stage.subject().scenario.structure.shape.largest_radius() / largest;
    double share = 1;
    for (int corner = 0; corner < 8; ++corner) {
        const Vec3 load = stage.loads().corner(static_cast<Eigen::AlignedBox3d::CornerType>(corner));
        share = std::min(share, reach(projection, size, middle_of(stage, frame), metres * load));
    }
    return share * metres;
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

namespace {

/// Mooring lines from their fairleads to their anchors, as far as the picture goes: what hangs lies behind ice and hull
/// and fades with the depth of the water. `unit`: pixels that a line is thick, as below.
void draw_lines(DepthBuffer& drawn, const Stage& stage, const Frame& frame, const Projection& projection, double unit) {
    const Scenario& scenario = stage.subject().scenario;
    const double clear = 8 * scenario.structure.shape.draught();
    constexpr double most_faded = 0.55;
    for (const FrameLine& line : frame.lines) {
        std::vector<Vec3> points =
            course(scenario.moorings, static_cast<std::size_t>(line.line), line.fairlead, line.anchor);
        const bool hangs = static_cast<std::size_t>(line.line) >= scenario.moorings.lines.size();
        if (!hangs)  // level lines are at the height of the water, where ice would hide what holds the hull
            for (Vec3& point : points) point.y() += scenario.floe.thickness;
        for (std::size_t k = 0; k + 1 < points.size(); ++k) {
            if (!projection.before(points[k]) || !projection.before(points[k + 1])) continue;
            const double depth = std::max(0.0, -0.5 * (points[k].y() + points[k + 1].y()));
            const Colour colour = between(line_violet, sea, most_faded * (1 - std::exp(-depth / clear)));
            drawn.line(projection.seen(points[k]), projection.seen(points[k + 1]), colour, 1.6 * unit);
        }
    }
}

/// An arrow ahead of the structure, as far as the picture goes.
void draw_tow(Canvas& canvas, const Stage& stage, const Frame& frame, const Projection& projection, const Vec2& size,
              double unit) {
    if (stage.subject().scenario.path.any()) return;  // it goes elsewhere than along +x
    const Structure& structure = stage.subject().scenario.structure;
    const double ahead = structure.speed < 0 ? -1 : 1;
    const double radius = structure.shape.largest_radius();
    const Vec3 from = frame.structure.position + Vec3(1.08 * ahead * radius, structure.shape.top(), 0);
    const Vec3 way(0.75 * ahead * radius, 0, 0);
    const double share = reach(projection, size, from, way);
    if (share > 0) canvas.arrow(projection.at(from), projection.at(from + share * way), tow_orange, 5 * unit);
}

/// Forces as lines of Fig. 5: the load in the middle of the structure, normal and friction forces where floes touch.
void draw_forces(Canvas& canvas, const Stage& stage, const Frame& frame, const Projection& projection, double metres,
                 double unit) {
    const double largest = stage.largest_load();
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
    const Vec3 middle = middle_of(stage, frame);
    draw(middle, frame.load, ink.faded(0.55), 7 * unit, true);
    draw(middle, frame.load, sum_white, 4 * unit, true);
    const Mat3 axes(frame.structure.orientation());
    const Vec3 own = frame.structure.in_own_axes(frame.load);
    draw(middle, own.x() * axes.col(0), surge_red, 4 * unit, true);
    draw(middle, own.y() * axes.col(1), heave_green, 4 * unit, true);
    draw(middle, own.z() * axes.col(2), sway_blue, 4 * unit, true);
}

/// Bars for a length and, with `metres` a newton above 0, a force, both as at the structure, and which line is which,
/// in the lower right of a picture of this size.
void draw_scales(Canvas& canvas, const Stage& stage, const Frame& frame, const Projection& projection, const Vec2& size,
                 double unit, double metres_each) {
    const double newton = metres_each * projection.scale();  // pixels
    const bool both = newton > 0;
    const bool lines = !frame.lines.empty();
    const double width = ((both ? 480 : 400) + (lines ? 130 : 0)) * unit;
    const double height = (both ? 60 : 36) * unit;
    const Vec2 corner(size.x() - width, size.y() - height);
    draw_ground(canvas, corner, size);
    const double left = corner.x() + 14 * unit;
    // A bar is at most two and a half times as long: two and their words fit. What is there but for rounding counts.
    const double least = 45 * unit * (1 - 1e-9);
    const double metres = round_above(least / projection.scale());
    const double next = draw_bar(canvas, {left, corner.y() + 18 * unit}, metres * projection.scale(),
                                 fmt::format("{:g} m", metres), unit);
    const std::string through = fmt::format("through ice, {:.4g} m/s", stage.drift());
    const double second = corner.y() + (both ? 46 : 23) * unit;
    if (!both) {
        const double x = draw_sample(canvas, {left + 165 * unit, second}, tow_orange, through, unit);
        if (lines) draw_sample(canvas, {x, second}, line_violet, "mooring line", unit);
        return;
    }
    const double force = round_above(least / newton);
    const Units::Shown newtons = Units(10 * force).of("N");  // the shorter number
    draw_bar(canvas, {next, corner.y() + 18 * unit}, force * newton,
             fmt::format("{:g} {unit}; on floes {:g} {unit}", force * newtons.factor,
                         force * newtons.factor / contact_stretch, fmt::arg("unit", newtons.name)),
             unit);
    double x = draw_sample(canvas, {left, second}, tow_orange, through, unit);
    x = draw_sample(canvas, {x, second}, normal_magenta, "normal", unit);
    x = draw_sample(canvas, {x, second}, friction_teal, "friction on floes", unit);
    if (lines) draw_sample(canvas, {x, second}, line_violet, "mooring line", unit);
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

Eigen::AlignedBox3d box_of(const LoadHistory& history) {
    Eigen::AlignedBox3d box(Vec3::Zero(), Vec3::Zero());
    for (std::size_t k = 0; k < history.surge.size(); ++k)
        box.extend(Vec3(-history.surge[k], history.heave[k], history.sway[k]));
    return box;
}

std::vector<double> scaled(std::vector<double> values, double factor) {
    for (double& value : values) value *= factor;
    return values;
}

HistoryStrip force_strip(std::string words, std::vector<double> values) {
    const double largest = values.empty() ? 0 : std::ranges::max(values);
    const Units::Shown newtons = Units(largest).of("N");
    return {.words = std::move(words), .unit = newtons.name, .values = scaled(std::move(values), newtons.factor)};
}

HistoryStrip offset_strip(std::vector<double> values) {
    return {.words = "offset", .unit = "m", .values = std::move(values), .decimals = 2};
}

HistoryStrip asked_strip(const RecordingSubject& subject, const RecordingOutcome& outcome) {
    const Asked& asked = subject.asked;
    std::vector<double> values =
        asked_history(asked, outcome.history, outcome.hull, subject.scenario.general.time_step);
    if (asked.of == AskedOf::offset) return offset_strip(std::move(values));
    return force_strip(asked == Asked{}               ? "surge load"
                       : asked.of == AskedOf::load    ? "surge " + asked.words()
                       : asked.of == AskedOf::tension ? "largest line tension"
                                                      : asked.words(),
                       std::move(values));
}

}  // namespace

std::vector<HistoryStrip> strips_of(const RecordingSubject& subject, const RecordingOutcome& outcome) {
    std::vector<HistoryStrip> strips{asked_strip(subject, outcome)};
    const Moorings& moorings = subject.scenario.moorings;
    if (!moorings.give_way()) return strips;
    if (subject.asked.of != AskedOf::offset) strips.push_back(offset_strip(outcome.hull.offset));
    if (subject.asked.of != AskedOf::tension && moorings.line_count() > 0) {
        strips.push_back(force_strip("line tension", outcome.hull.tension));
        strips.back().from_zero = false;  // it swings about that without an offset
    }
    strips.push_back({.words = "heading",
                      .unit = "°",
                      .values = scaled(outcome.hull.yaw, 1 / unit::degree),
                      .from_zero = false,
                      .decimals = 1});
    return strips;
}

Stage::Stage(RecordingSubject subject, RecordingOutcome outcome)
    : subject_(std::move(subject)),
      outcome_(std::move(outcome)),
      drift_(subject_.scenario.drift()),
      largest_load_(largest_load_of(outcome_.history)),
      loads_(box_of(outcome_.history)),
      asked_(asked_history(subject_.asked, outcome_.history, outcome_.hull, subject_.scenario.general.time_step)),
      strips_(strips_of(subject_, outcome_)),
      layout_(subject_.floes),
      sheets_(in_parts(subject_.channel().sheets, subject_.scenario.floe.length)) {
    const Scenario& scenario = subject_.scenario;
    if (scenario.path.any()) way_ = places_of(scenario.path, scenario.general.time_step, scenario.step_count());
}

std::string Stage::ice_words(double time) const {
    if (way_.empty()) return "";
    const auto step = static_cast<std::size_t>(std::lround(time / subject_.scenario.general.time_step));
    const Vec2& velocity = way_[std::min(step, way_.size() - 1)].velocity;
    if (velocity.norm() == 0) return "ice at rest";
    const double from = std::atan2(velocity.y(), velocity.x()) / unit::degree;
    return fmt::format("ice from {:.0f}° at {:.2g} m/s", from, velocity.norm());
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
    const int sheet = is_level() ? largest_piece(frame) : -1;
    const auto colour = [&](std::size_t k) {
        switch (colouring) {
            case Colouring::piece:
                return piece_colour(frame.pieces[k]);
            case Colouring::speed:
                return scale_colour(frame.elements[k].velocity.norm() / drift_);
            case Colouring::utilisation:
                return frame.utilisation[k] > 1 ? crack_colour : scale_colour(frame.utilisation[k]);
            case Colouring::ice:
                break;
        }
        const bool is_broken = is_level() ? frame.pieces[k] != sheet
                                          : broken[static_cast<std::size_t>(layout_.elements[frame.id(k)].floe)] != 0;
        return is_broken ? broken_ice : white_ice;
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

constexpr double strip_share = 0.17;        // of the height, for what is asked over time
constexpr double more_strip_share = 0.075;  // for each other strip

/// Of all strips.
double strip_height(const PictureStyle& style, const RecordingSubject& subject) {
    const double share = strip_share + more_strip_share * static_cast<double>(strips_of(subject, {}).size() - 1);
    return std::round(share * (style.view == View::plan ? 0.6 * style.width : style.height));
}

/// Sizes of lines and letters go by the picture's width.
double unit_of(const PictureStyle& style) {
    return style.width / 1280.0;
}

void draw_faces(DepthBuffer& drawn, const std::vector<Face>& faces, double unit) {
    for (const Face& face : faces) {
        drawn.fill(face.corners, face.colour);
        const Colour dark = between(face.colour, ink, 0.55);
        const std::bitset<32> edges(face.edges);  // the structure's faces have more corners, and no lines
        for (std::size_t k = 0; k < std::min(face.corners.size(), edges.size()); ++k) {
            if (!edges[k]) continue;
            drawn.line(face.corners[k], face.corners[(k + 1) % face.corners.size()], dark, unit);
        }
    }
}

void draw_words(Canvas& canvas, const Stage& stage, const Frame& frame, const PictureStyle& style) {
    const double unit = unit_of(style);
    const RecordingSubject& subject = stage.subject();
    const double left = 16 * unit;
    const std::string moment = moment_words(stage, frame, style);
    draw_ground(canvas, {0, 0}, {440 * unit, (moment.empty() ? 84 : 105) * unit});
    const double next =
        left + 14 * unit +
        canvas.text({left, 28 * unit}, fmt::format("t = {:.2f} s", frame.time), bright, 20 * unit, Align::left, true);
    canvas.text({next, 28 * unit}, stage.ice_words(frame.time), bright, 14 * unit);
    canvas.text({left, 51 * unit},
                fmt::format("{}, case {}, arrangement {} (member {})", subject.campaign, subject.case_name,
                            subject.arrangement, subject.member),
                bright, 14 * unit);
    const FloeCounts floes = stage.floes(frame);
    canvas.text({left, 72 * unit},
                stage.is_level()
                    ? fmt::format("pieces broken off: {}", floes.broken)
                    : fmt::format("broken floes{}: {} of {}", subject.scenario.field.endless() ? " here" : "",
                                  floes.broken, floes.all),
                bright, 14 * unit);
    if (!moment.empty()) canvas.text({left, 93 * unit}, moment, bright, 14 * unit, Align::left, true);
    if (style.view == View::plan) return;
    const double right = style.width - 16 * unit;
    draw_ground(canvas, {style.width - 290 * unit, 0}, {style.width, 100 * unit});
    const Units::Shown newtons = Units(frame.load.norm()).of("N");
    struct Line {
        const char* name;
        double value;
        Colour colour;
    };
    const Vec3 own = frame.structure.in_own_axes(frame.load);
    const std::array<Line, 4> lines{{{"surge", -own.x(), between(surge_red, bright, 0.35)},
                                     {"sway", own.z(), between(sway_blue, bright, 0.35)},
                                     {"heave", own.y(), between(heave_green, bright, 0.35)},
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
void draw_legend(Canvas& canvas, const Stage& stage, const PictureStyle& style, double bottom) {
    if (style.colouring == Colouring::piece) return;
    const double unit = unit_of(style);
    const double left = 16 * unit;
    const double size = 14 * unit;
    const auto box = [&](double x, double width, const Colour& colour) {
        draw_box(canvas, {x, bottom - 24 * unit}, {x + width, bottom - 10 * unit}, colour);
    };
    draw_ground(canvas, {0, bottom - 36 * unit}, {440 * unit, bottom});
    const auto word = [&](double x, const std::string& text) {
        return x + canvas.text({x, bottom - 12 * unit}, text, bright, size);
    };
    if (style.colouring == Colouring::ice) {
        box(left, 22 * unit, white_ice);
        const double next = word(left + 28 * unit, stage.is_level() ? "level ice" : "whole floe") + 22 * unit;
        box(next, 22 * unit, broken_ice);
        word(next + 28 * unit, stage.is_level() ? "broken off" : "broken floe");
        return;
    }
    const bool moves = style.colouring == Colouring::speed;
    const double begin = word(left, moves ? "speed  0" : "utilisation of the worst joint  0") + 8 * unit;
    constexpr int steps = 40;
    const double width = 110 * unit / steps;
    for (int k = 0; k < steps; ++k) box(begin + k * width, width + unit, scale_colour((k + 0.5) / steps));
    const double end =
        word(begin + 118 * unit, moves ? fmt::format("{:.3g} m/s (hull through ice)", stage.drift()) : "1");
    if (moves) return;
    box(end + 14 * unit, 22 * unit, crack_colour);
    word(end + 42 * unit, "crack");
}

/// Where a strip is drawn, pixels, and over which time, s.
struct StripPlace {
    double left = 0;
    double right = 0;
    double ceiling = 0;
    double bottom = 0;
    double from = 0;
    double to = 0;
};

/// The line of a strip, its axis and the moment of the frame.
void draw_strip(Canvas& canvas, const HistoryStrip& strip, const StripPlace& in, double step, double time,
                double unit) {
    const std::vector<double>& values = strip.values;
    if (values.empty()) return;
    const auto columns = static_cast<std::size_t>(in.right - in.left);
    const auto first = std::min(values.size() - 1, static_cast<std::size_t>(std::max(0.0, std::floor(in.from / step))));
    const auto last = std::clamp(static_cast<std::size_t>(std::ceil(in.to / step)), first + 1, values.size());
    const auto [least, most] = std::ranges::minmax(std::span(values).subspan(first, last - first));
    const double low = strip.from_zero ? std::min(0.0, least) : least;
    const double up = most > low ? most : low + 1;
    const auto at = [&](double when, double value) {
        return Vec2(in.left + (in.right - in.left) * (when - in.from) / (in.to - in.from),
                    in.bottom - (in.bottom - in.ceiling) * (value - low) / (up - low));
    };
    std::vector<Vec2> line;
    const std::size_t stride = std::max<std::size_t>(1, (last - first) / columns);
    for (std::size_t k = first; k < last; k += stride) {
        const auto part = std::span(values).subspan(k, std::min(stride, last - k));
        const double end = step * static_cast<double>(k + 1);
        const auto [small, large] = std::ranges::minmax(part);
        line.push_back(at(end, small));
        line.push_back(at(end, large));
    }
    const double base = strip.from_zero ? 0 : low;
    canvas.line(at(in.from, base), at(in.to, base), ink.faded(0.35), unit);
    canvas.path(line, {0.10, 0.35, 0.62}, 1.3 * unit);
    canvas.line(at(time, low), at(time, up), ink, 2 * unit);
    const double size = 13 * unit;
    const auto label = [&](double value) { return fmt::format("{:.{}f} {}", value, strip.decimals, strip.unit); };
    canvas.text({in.left - 8 * unit, in.ceiling + size / 2}, label(up), ink, size, Align::right);
    canvas.text({in.left - 8 * unit, at(in.from, base).y() + size / 3}, strip.from_zero ? "0" : label(base), ink, size,
                Align::right);
}

/// Strips over time in the lowest part of the picture; of several each has its words beside it.
void draw_histories(Canvas& canvas, const Stage& stage, const Frame& frame, const PictureStyle& style) {
    const double unit = unit_of(style);
    const std::vector<HistoryStrip>& strips = stage.strips();
    const double high = strip_height(style, stage.subject());
    const double top = canvas.height() - high;
    const double step = stage.subject().scenario.general.time_step;
    const double width = style.width;
    draw_box(canvas, {0, top}, {width, top + high}, bright);
    const std::vector<double>& surge = stage.outcome().history.surge;
    if (surge.empty()) return;
    const bool whole = !(style.to > style.from);
    const bool many = strips.size() > 1;
    const double bottom = canvas.height() - 30 * unit;
    StripPlace in{.left = (many ? 250 : 64) * unit,
                  .right = width - 20 * unit,
                  .from = whole ? 0 : style.from,
                  .to = whole ? step * static_cast<double>(surge.size()) : style.to};
    const double more = many ? more_strip_share / strip_share : 0;  // of the first one's height
    const double first = (bottom - top) / (1 + more * static_cast<double>(strips.size() - 1));
    double from = top;
    for (const HistoryStrip& strip : strips) {
        in.ceiling = from + 14 * unit;
        in.bottom = from += &strip == &strips.front() ? first : more * first;
        if (many) canvas.text({16 * unit, (in.ceiling + in.bottom) / 2 + 4 * unit}, strip.words, ink, 13 * unit);
        draw_strip(canvas, strip, in, step, frame.time, unit);
    }
    const double size = 13 * unit;
    const auto [first_time, last_time] = ends_of_axis(in.from, in.to);
    canvas.text({in.left, bottom + 18 * unit}, first_time, ink, size);
    canvas.text({in.right, bottom + 18 * unit}, last_time, ink, size, Align::right);
    if (many) return;
    const bool load = stage.subject().asked.of == AskedOf::load;
    canvas.text({(in.left + in.right) / 2, bottom + 18 * unit},
                strips.front().words + (load ? ", positive against the tow" : ""), ink, size, Align::middle);
}

}  // namespace

std::pair<std::string, std::string> ends_of_axis(double from, double to) {
    double grain = 1;  // s
    while (grain > 1e-6 && to - from < 10 * grain) grain /= 10;
    const auto words = [grain](double time) { return fmt::format("{:.9g} s", std::round(time / grain) * grain); };
    return {words(from), words(to)};
}

std::string moment_words(const Stage& stage, const Frame& frame, const PictureStyle& style) {
    const double step = stage.subject().scenario.general.time_step;
    const std::vector<double>& asked = stage.asked();
    const bool whole = !(style.to > style.from);
    double time = 0;
    double largest = -std::numeric_limits<double>::infinity();
    for (std::size_t k = 0; k < asked.size(); ++k) {
        const double end = step * static_cast<double>(k + 1);
        if (!whole && (end < style.from - step / 2 || end > style.to + step / 2)) continue;
        if (!(asked[k] > largest)) continue;
        largest = asked[k];
        time = end;
    }
    if (!(largest > 0) || std::abs(frame.time - time) > step / 2) return "";
    const Asked& asked_of = stage.subject().asked;
    return fmt::format("largest {}: {}", asked_of.words(), Units(largest).text(largest, asked_of.unit()));
}

int picture_height(const PictureStyle& style, const RecordingSubject& subject) {
    if (style.view != View::plan) return style.height + style.height % 2;
    const Vec2 x = plan_of(subject, 0);
    const double share = 2 * subject.channel().outer_edge / (x.y() - x.x());
    return 2 * static_cast<int>(std::lround((share * style.width + strip_height(style, subject)) / 2));
}

void draw_picture(Canvas& canvas, const Stage& stage, const Frame& frame, const PictureStyle& style) {
    FLOES_EXPECTS(canvas.width() > 0 && canvas.height() > 0);
    const double unit = unit_of(style);
    const Vec2 size(canvas.width(), canvas.height() - strip_height(style, stage.subject()));
    const Projection projection(
        camera(style.view, stage.subject(), frame.structure.position.x(), frame.structure.position.z()), size.x(),
        size.y());
    DepthBuffer drawn(static_cast<int>(size.x()), static_cast<int>(size.y()), sea);
    draw_faces(drawn, stage.faces(frame, projection, size, style.colouring), unit);
    draw_lines(drawn, stage, frame, projection, unit);
    canvas.image(Vec2::Zero(), drawn.width(), drawn.height(), drawn.pixels());
    const double metres = style.view == View::plan ? 0 : metres_a_newton(stage, frame, projection, size);
    draw_tow(canvas, stage, frame, projection, size, unit);
    draw_forces(canvas, stage, frame, projection, metres, unit);
    draw_words(canvas, stage, frame, style);
    draw_legend(canvas, stage, style, size.y());
    draw_scales(canvas, stage, frame, projection, size, unit, metres);
    draw_histories(canvas, stage, frame, style);
}

}  // namespace floes
