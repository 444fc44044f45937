#pragma once
// A drawing, in pixels or as vectors: the only door to cairo. x to the right and y down, in pixels from the upper left.

#include <cstdint>
#include <filesystem>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "core/vector.hpp"
#include "view/colours.hpp"

namespace floes {

enum class Align { left, middle, right };

class Canvas {
  public:
    /// In pixels.
    Canvas(int width, int height);
    /// As vectors, in an SVG file that finish() completes. Throws RunError when it cannot be written.
    Canvas(const std::filesystem::path& svg, int width, int height);
    Canvas(Canvas&&) noexcept;
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

}  // namespace floes
