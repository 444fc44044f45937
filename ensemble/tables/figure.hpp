#pragma once
// A figure as data: axes with units, what stands between them, a legend and a caption. Whoever shows it draws it.

#include <span>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace floes {

/// One axis: its label, its range (low < high; logarithmic: 0 < low), and the unit, which whoever draws it adds.
struct Axis {
    std::string label;
    double low = 0;
    double high = 1;
    bool logarithmic = false;
    std::vector<std::string> names = {};  ///< on a vertical axis, instead of numbers: name i is at i + 0.5
    double step = 0;                      ///< from tick to tick; 0: a round one
    std::string unit = {};                ///< SI, of the positions, as Units takes it; empty: the label says it
    bool downwards = false;               ///< values grow down the page, as +z does from above
};

/// The next larger, and the next smaller, of 1, 2 and 5 times a power of ten; of a value above 0.
double round_above(double value);
double round_below(double value);

/// An axis with a margin around the finite `values`; `with_zero`: the range includes 0.
Axis axis_around(std::string label, std::span<const double> values, bool with_zero, std::string unit = {});

/// Positions are in the units of the axes; what is not finite is left out. A style is words: a colour (ink, or c0 to c5
/// of the cases), how strong (thin, thick, dashed, dotted, faint, veil), or what is meant (ice, water, heat, …).
struct Figure {
    using Points = std::vector<std::pair<double, double>>;

    struct Line {
        Points points;
        std::string style;
    };
    struct Area {
        Points outline;
        std::string style;
    };
    struct Dot {
        double x, y;
        std::string style;
        double radius;  ///< on the screen
        bool cross;     ///< drawn as a cross
    };
    /// Filled by `share`, 0 to 1: 0 is not drawn.
    struct Cell {
        double x, y, width, height, share;  ///< (x, y): its lower left corner
        std::string style;
    };
    struct Words {
        double x, y;
        std::string words;
        std::string anchor;  ///< start, middle or end of the words
        std::string style;
    };
    using Mark = std::variant<Line, Area, Dot, Cell, Words>;

    struct Size {
        double width = 720;
        double height = 320;
    };

    std::string description = {};  ///< for readers who do not see it
    Axis x = {};
    Axis y = {};
    Size size = {};
    std::vector<Mark> marks = {};                                  ///< later ones cover earlier ones
    std::vector<std::pair<std::string, std::string>> legend = {};  ///< style and name
    std::string heat_scale = {};  ///< in place of the legend: the shades of "heat" from 0 to 1, and these words
    std::string caption = {};     ///< empty: the next figure stands beside it, and its caption is for both

    void line(Points points, std::string style) { marks.emplace_back(Line{std::move(points), std::move(style)}); }
    void area(Points outline, std::string style) { marks.emplace_back(Area{std::move(outline), std::move(style)}); }
    void dot(double x_value, double y_value, std::string style, double radius = 3.5) {
        marks.emplace_back(Dot{x_value, y_value, std::move(style), radius, false});
    }
    void cross(double x_value, double y_value, std::string style, double radius = 4) {
        marks.emplace_back(Dot{x_value, y_value, std::move(style), radius, true});
    }
    void cell(double left, double low, double width, double height, double share, std::string style) {
        marks.emplace_back(Cell{left, low, width, height, share, std::move(style)});
    }
    void text(double x_value, double y_value, std::string words, std::string anchor, std::string style = {}) {
        marks.emplace_back(Words{x_value, y_value, std::move(words), std::move(anchor), std::move(style)});
    }
    /// A vertical line over the whole figure.
    void upright(double x_value, std::string style) { line({{x_value, y.low}, {x_value, y.high}}, std::move(style)); }
    /// A horizontal one.
    void level(double y_value, std::string style) { line({{x.low, y_value}, {x.high, y_value}}, std::move(style)); }
    /// The area from `low` to `high`, which have the same x values.
    void band(Points low, const Points& high, std::string style);
};

/// A size with the same scale along both axes for `width` by `height` of their units, at most `widest` wide.
Figure::Size to_scale(double width, double height, double widest);

/// The colour of a case or series, the same in every figure of a page.
std::string colour(std::size_t number);

}  // namespace floes
