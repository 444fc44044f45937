#pragma once
// A drawing, in pixels or as vectors: the only door to cairo. x to the right and y down, in pixels from the upper left.

#include <array>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "core/vector.hpp"
#include "replay/view.hpp"

namespace floes {

enum class Align { left, middle, right };

class Canvas {
  public:
    /// In pixels.
    Canvas(int width, int height);
    /// As vectors, in an SVG file that finish() completes. Throws RunError when it cannot be written.
    Canvas(const std::filesystem::path& svg, int width, int height);
    ~Canvas();

    int width() const;
    int height() const;

    /// Pixels with their upper left corner there: rows from above, four bytes each, blue, green, red, 255.
    void image(const Vec2& at, int width, int height, std::vector<std::uint8_t> pixels);
    void fill(std::span<const Vec2> polygon, const Colour& colour);
    void line(const Vec2& from, const Vec2& to, const Colour& colour, double width);
    void path(std::span<const Vec2> points, const Colour& colour, double width);
    void arrow(const Vec2& from, const Vec2& to, const Colour& colour, double width);
    /// `at`: where the base line begins, has its middle or ends. Returns its width.
    double text(const Vec2& at, const std::string& text, const Colour& colour, double size, Align align = Align::left,
                bool bold = false);

    /// Throws RunError when it cannot be written. Not for SVG.
    void write_png(const std::filesystem::path& path) const;
    std::string png() const;
    /// Rows from above, four bytes a pixel: blue, green, red, unused. Not for SVG.
    std::span<const std::uint8_t> pixels() const;
    /// Completes an SVG file. Throws RunError when that fails.
    void finish();

  private:
    class Surface;
    std::unique_ptr<Surface> surface_;
};

// Faces drawn so that the nearer hide the farther, however they lie through and over each other. With two by two
// samples a pixel.

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
