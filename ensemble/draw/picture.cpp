#include "draw/picture.hpp"

#include <algorithm>
#include <bitset>
#include <cmath>

#include <fmt/format.h>

#include "draw/canvas.hpp"
#include "draw/encoder.hpp"
#include "draw/scene.hpp"
#include "tables/units.hpp"

namespace floes {

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

void write_film(const std::filesystem::path& path, const Recording& recording, const PictureStyle& style, int rate,
                const std::function<void(double)>& progress) {
    const Stage stage(recording.subject(), recording.outcome());
    const int height = picture_height(style, recording.subject());
    const std::unique_ptr<Encoder> film = make_encoder(path, {style.width, height, recording.frames(), rate});
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
