#pragma once
// Faces drawn so that the nearer hide the farther, however they lie through and over each other. With two by two
// samples a pixel.

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "core/vector.hpp"
#include "view/colours.hpp"

namespace floes {

class DepthBuffer {
  public:
    /// In pixels. Empty: all `ground`.
    DepthBuffer(int width, int height, const Colour& ground);

    /// A convex face. Of a corner: x and y in pixels, x to the right and y down, and how near it is, a number that is
    /// linear over the picture (Projection::seen). Opaque.
    void fill(std::span<const Vec3> corners, const Colour& colour);

    /// A line `width` pixels wide, in front of the faces that it lies on.
    void line(const Vec3& from, const Vec3& to, const Colour& colour, double width);

    int width() const { return width_ / samples; }
    int height() const { return height_ / samples; }

    /// Rows from above, four bytes a pixel: blue, green, red, 255.
    std::vector<std::uint8_t> pixels() const;

  private:
    static constexpr int samples = 2;  ///< along each side of a pixel
    static constexpr double in_front = 1e-3;

    void triangle(const std::array<Vec3, 3>& corners, std::uint32_t colour);

    int width_;  ///< samples
    int height_;
    std::vector<float> nearness_;
    std::vector<std::uint32_t> colours_;
};

}  // namespace floes
