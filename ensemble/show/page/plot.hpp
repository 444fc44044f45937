#pragma once
// One diagram as SVG: axes with units, lines, dots, whiskers, bars. Colours are classes of the page's style sheet, so
// that a figure works on light and dark screens and on paper. For this room only.

#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace floes {

/// One axis: its label with the unit, and its range (low < high; logarithmic: 0 < low).
struct Axis {
    std::string label;
    double low = 0;
    double high = 1;
    bool logarithmic = false;
    std::vector<std::string> names = {};  ///< on a vertical axis, instead of numbers: name i is at i + 0.5
    double step = 0;                      ///< from tick to tick; 0: a round one
};

/// An axis with a margin around the finite `values`; `with_zero`: the range includes 0.
Axis axis_around(std::string label, std::span<const double> values, bool with_zero);

/// Multiples of the axis's step, or of 1, 2 or 5 times a power of ten, from low to high, at most about `most` of them;
/// decades on a logarithmic axis.
std::vector<double> ticks(const Axis& axis, int most);

struct Size {
    double width = 720;
    double height = 320;
};

class Plot {
  public:
    using Points = std::vector<std::pair<double, double>>;

    /// `description`: the text for screen readers.
    Plot(std::string description, Axis x, Axis y, Size size = {});

    /// All in the units of the axes; values that are not finite are left out. `style`: classes such as "c0 thin".
    void line(const Points& points, std::string_view style);
    void area(const Points& outline, std::string_view style);
    void dot(double x, double y, std::string_view style, double radius = 3.5);
    void cross(double x, double y, std::string_view style, double radius = 4);
    void text(double x, double y, std::string_view words, std::string_view anchor, std::string_view style = {});
    /// A box from (x, y) on, filled by `share`, 0 to 1: 0 is not drawn.
    void cell(double x, double y, double width, double height, double share, std::string_view style);
    void upright(double x, std::string_view style);  ///< a vertical line over the whole diagram
    void level(double y, std::string_view style);

    /// Coloured names in a row above the diagram.
    void legend(const std::vector<std::pair<std::string, std::string>>& style_and_name);

    /// In place of the legend: the colours of cells from 0 to 1, and words beside them.
    void colour_bar(std::string_view style, std::string_view words);

    std::string svg() const;

  private:
    double at_x(double value) const;
    double at_y(double value) const;
    void draw_axes();
    std::string path(const Points& points, bool closed) const;

    std::string description_;
    Axis x_;
    Axis y_;
    Size size_;
    double left_ = 64;  // wider if names need it
    std::string body_;
};

}  // namespace floes
