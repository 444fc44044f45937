#include "picture/depth_buffer.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace floes {
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
