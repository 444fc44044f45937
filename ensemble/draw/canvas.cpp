#include "draw/canvas.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include <cairo-svg.h>
#include <cairo.h>
#include <fmt/format.h>

#include "core/error.hpp"

namespace floes {

namespace {

void check(cairo_status_t status, const std::string& about) {
    if (status != CAIRO_STATUS_SUCCESS)
        throw RunError(fmt::format("{} cannot be drawn ({}); does the folder exist, and has it free space?", about,
                                   cairo_status_to_string(status)));
}

}  // namespace

class Canvas::Surface {
  public:
    Surface(cairo_surface_t* made, std::string about, int width, int height)
        : surface(made), context(cairo_create(made)), name(std::move(about)), wide(width), high(height) {
        check(cairo_surface_status(surface), name);
        check(cairo_status(context), name);
        cairo_set_line_join(context, CAIRO_LINE_JOIN_ROUND);
        cairo_set_line_cap(context, CAIRO_LINE_CAP_ROUND);
    }
    Surface(const Surface&) = delete;
    Surface& operator=(const Surface&) = delete;
    ~Surface() {
        cairo_destroy(context);
        cairo_surface_destroy(surface);
    }

    void use(const Colour& colour) const {
        cairo_set_source_rgba(context, colour.red, colour.green, colour.blue, colour.opacity);
    }
    void trace(std::span<const Vec2> points) const {
        cairo_new_path(context);
        for (const Vec2& point : points) cairo_line_to(context, point.x(), point.y());
    }

    cairo_surface_t* surface;
    cairo_t* context;
    std::string name;
    int wide;
    int high;
};

Canvas::Canvas(int width, int height)
    : surface_(std::make_unique<Surface>(cairo_image_surface_create(CAIRO_FORMAT_RGB24, width, height),
                                         fmt::format("A picture of {} x {} pixels", width, height), width, height)) {}

Canvas::Canvas(const std::filesystem::path& svg, int width, int height)
    : surface_(std::make_unique<Surface>(cairo_svg_surface_create(svg.c_str(), width, height), svg.string(), width,
                                         height)) {
    cairo_svg_surface_set_document_unit(surface_->surface, CAIRO_SVG_UNIT_PX);  // else points, a third more
}

Canvas::~Canvas() = default;

int Canvas::width() const {
    return surface_->wide;
}

int Canvas::height() const {
    return surface_->high;
}

void Canvas::image(const Vec2& at, int width, int height, std::vector<std::uint8_t> pixels) {
    const int stride = cairo_format_stride_for_width(CAIRO_FORMAT_RGB24, width);  // 4 bytes a pixel, without a gap
    cairo_surface_t* picture =
        cairo_image_surface_create_for_data(pixels.data(), CAIRO_FORMAT_RGB24, width, height, stride);
    cairo_set_source_surface(surface_->context, picture, at.x(), at.y());
    cairo_paint(surface_->context);
    cairo_surface_finish(picture);  // an SVG keeps its pixels from here on
    cairo_surface_destroy(picture);
}

void Canvas::fill(std::span<const Vec2> polygon, const Colour& colour) {
    surface_->trace(polygon);
    cairo_close_path(surface_->context);
    surface_->use(colour);
    cairo_fill(surface_->context);
}

void Canvas::line(const Vec2& from, const Vec2& to, const Colour& colour, double width) {
    path(std::array{from, to}, colour, width);
}

void Canvas::path(std::span<const Vec2> points, const Colour& colour, double width) {
    surface_->trace(points);
    surface_->use(colour);
    cairo_set_line_width(surface_->context, width);
    cairo_stroke(surface_->context);
}

void Canvas::arrow(const Vec2& from, const Vec2& to, const Colour& colour, double width) {
    const Vec2 along = to - from;
    const double length = along.norm();
    if (length < 1) return;
    const double head = std::min(4 * width, 0.6 * length);
    const Vec2 unit = along / length;
    const Vec2 aside(-unit.y(), unit.x());
    line(from, to - head * unit, colour, width);
    fill(std::array<Vec2, 3>{to, to - head * unit + 0.45 * head * aside, to - head * unit - 0.45 * head * aside},
         colour);
}

double Canvas::text(const Vec2& at, const std::string& text, const Colour& colour, double size, Align align,
                    bool bold) {
    cairo_t* context = surface_->context;
    cairo_select_font_face(context, "sans-serif", CAIRO_FONT_SLANT_NORMAL,
                           bold ? CAIRO_FONT_WEIGHT_BOLD : CAIRO_FONT_WEIGHT_NORMAL);
    cairo_set_font_size(context, size);
    cairo_text_extents_t extents;
    cairo_text_extents(context, text.c_str(), &extents);
    const double share = align == Align::left ? 0 : align == Align::middle ? 0.5 : 1;
    surface_->use(colour);
    cairo_move_to(context, at.x() - share * extents.x_advance, at.y());
    cairo_show_text(context, text.c_str());
    return extents.x_advance;
}

void Canvas::write_png(const std::filesystem::path& path) const {
    check(cairo_surface_write_to_png(surface_->surface, path.c_str()), path.string());
}

std::string Canvas::png() const {
    std::string bytes;
    const auto append = [](void* to, const unsigned char* data, unsigned length) {
        static_cast<std::string*>(to)->append(reinterpret_cast<const char*>(data), length);
        return CAIRO_STATUS_SUCCESS;
    };
    check(cairo_surface_write_to_png_stream(surface_->surface, append, &bytes), surface_->name);
    return bytes;
}

std::span<const std::uint8_t> Canvas::pixels() const {
    cairo_surface_flush(surface_->surface);
    const auto rows = static_cast<std::size_t>(cairo_image_surface_get_height(surface_->surface));
    const auto stride = static_cast<std::size_t>(cairo_image_surface_get_stride(surface_->surface));
    return {cairo_image_surface_get_data(surface_->surface), rows * stride};
}

void Canvas::finish() {
    cairo_surface_finish(surface_->surface);
    check(cairo_surface_status(surface_->surface), surface_->name);
}

namespace {

std::uint32_t packed(const Colour& colour) {
    const auto byte = [](double part) {
        return static_cast<std::uint32_t>(std::lround(255 * std::clamp(part, 0.0, 1.0)));
    };
    return byte(colour.red) << 16 | byte(colour.green) << 8 | byte(colour.blue);
}

/// Twice the area of the triangle a, b, p on the picture: positive on one side of the line from a to b.
double side_of(const Vec3& a, const Vec3& b, double x, double y) {
    return (b.x() - a.x()) * (y - a.y()) - (b.y() - a.y()) * (x - a.x());
}

}  // namespace

DepthBuffer::DepthBuffer(int width, int height, const Colour& ground)
    : width_(samples * width),
      height_(samples * height),
      nearness_(static_cast<std::size_t>(width_) * static_cast<std::size_t>(height_),
                -std::numeric_limits<float>::infinity()),
      colours_(nearness_.size(), packed(ground)) {}

void DepthBuffer::fill(std::span<const Vec3> corners, const Colour& colour) {
    const std::uint32_t bytes = packed(colour);
    for (std::size_t k = 2; k < corners.size(); ++k) triangle({corners[0], corners[k - 1], corners[k]}, bytes);
}

void DepthBuffer::line(const Vec3& from, const Vec3& to, const Colour& colour, double width) {
    const Vec2 along = (to - from).head<2>();
    const double length = along.norm();
    if (!(length > 0)) return;
    const Vec2 aside = Vec2(-along.y(), along.x()) * (width / (2 * length));
    const auto moved = [&](const Vec3& point, double sign) {
        return Vec3(point.x() + sign * aside.x(), point.y() + sign * aside.y(),
                    point.z() + in_front * std::abs(point.z()));
    };
    fill(std::array<Vec3, 4>{moved(from, 1), moved(to, 1), moved(to, -1), moved(from, -1)}, colour);
}

void DepthBuffer::triangle(const std::array<Vec3, 3>& given, std::uint32_t colour) {
    std::array<Vec3, 3> corners = given;
    for (Vec3& corner : corners) corner.head<2>() *= samples;
    const auto& [a, b, c] = corners;
    const double area = side_of(a, b, c.x(), c.y());
    if (area == 0 || !std::isfinite(area)) return;
    const auto [left, right] = std::minmax({a.x(), b.x(), c.x()});
    const auto [top, bottom] = std::minmax({a.y(), b.y(), c.y()});
    const int first_x = std::max(0, static_cast<int>(std::ceil(std::max(left, -1.0) - 0.5)));
    const int first_y = std::max(0, static_cast<int>(std::ceil(std::max(top, -1.0) - 0.5)));
    const int last_x = std::min(width_ - 1, static_cast<int>(std::floor(std::min<double>(right, width_) - 0.5)));
    const int last_y = std::min(height_ - 1, static_cast<int>(std::floor(std::min<double>(bottom, height_) - 0.5)));
    for (int row = first_y; row <= last_y; ++row) {
        const double y = row + 0.5;
        double in_a = side_of(b, c, first_x + 0.5, y) / area;
        double in_b = side_of(c, a, first_x + 0.5, y) / area;
        const double step_a = -(c.y() - b.y()) / area;
        const double step_b = -(a.y() - c.y()) / area;
        const std::size_t begin = static_cast<std::size_t>(row) * static_cast<std::size_t>(width_);
        for (int column = first_x; column <= last_x; ++column, in_a += step_a, in_b += step_b) {
            const double in_c = 1 - in_a - in_b;
            if (in_a < 0 || in_b < 0 || in_c < 0) continue;
            const auto near = static_cast<float>(in_a * a.z() + in_b * b.z() + in_c * c.z());
            const std::size_t at = begin + static_cast<std::size_t>(column);
            if (near <= nearness_[at]) continue;
            nearness_[at] = near;
            colours_[at] = colour;
        }
    }
}

std::vector<std::uint8_t> DepthBuffer::pixels() const {
    std::vector<std::uint8_t> bytes;
    bytes.reserve(static_cast<std::size_t>(width()) * static_cast<std::size_t>(height()) * 4);
    for (int y = 0; y < height_; y += samples) {
        for (int x = 0; x < width_; x += samples) {
            std::array<std::uint32_t, 3> sums{};
            for (int k = 0; k < samples * samples; ++k) {
                const std::size_t at = static_cast<std::size_t>(y + k / samples) * static_cast<std::size_t>(width_) +
                                       static_cast<std::size_t>(x + k % samples);
                for (unsigned part = 0; part < 3; ++part) sums[part] += colours_[at] >> (8 * part) & 0xff;
            }
            for (const std::uint32_t sum : sums)
                bytes.push_back(static_cast<std::uint8_t>((sum + samples * samples / 2) / (samples * samples)));
            bytes.push_back(255);
        }
    }
    return bytes;
}

}  // namespace floes
