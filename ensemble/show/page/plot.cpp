#include "page/plot.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "tables/table.hpp"

namespace floes {
namespace {

constexpr double right = 16;
constexpr double top = 28;  // height of the legend's row
constexpr double bottom = 46;
constexpr double letter = 7;  // approximate width of one

double width_of(std::string_view text) {
    return letter * static_cast<double>(text_width(text));
}

std::string tick_text(double value) {
    return fmt::format("{:.6g}", std::abs(value) < 1e-12 ? 0.0 : value);
}

}  // namespace

Axis axis_around(std::string label, std::span<const double> values, bool with_zero) {
    double low = std::numeric_limits<double>::infinity();
    double high = -low;
    for (const double value : values) {
        if (!std::isfinite(value)) continue;
        low = std::min(low, value);
        high = std::max(high, value);
    }
    if (low > high) low = high = 0;
    if (with_zero) {
        low = std::min(low, 0.0);
        high = std::max(high, 0.0);
    }
    if (low == high) high = low + 1;
    const double air = 0.05 * (high - low);
    return {std::move(label), with_zero && low == 0 ? 0 : low - air, with_zero && high == 0 ? 0 : high + air};
}

std::vector<double> ticks(const Axis& axis, int most) {
    std::vector<double> found;
    if (axis.logarithmic) {
        const double first = std::ceil(std::log10(axis.low) - 1e-9);
        const double last = std::floor(std::log10(axis.high) + 1e-9);
        const double step = std::max(1.0, std::ceil((last - first) / most));
        for (double decade = first; decade <= last; decade += step) found.push_back(std::pow(10.0, decade));
        return found;
    }
    const double rough = (axis.high - axis.low) / most;
    const double power = std::pow(10.0, std::floor(std::log10(rough)));
    double step = 10 * power;
    for (const double digit : {1.0, 2.0, 5.0}) {
        if (digit * power >= rough) {
            step = digit * power;
            break;
        }
    }
    if (axis.step > 0) step = axis.step;
    const double slack = 1e-9 * (axis.high - axis.low);
    for (double i = std::ceil((axis.low - slack) / step); i * step <= axis.high + slack; ++i) found.push_back(i * step);
    return found;
}

Plot::Plot(std::string description, Axis x, Axis y, Size size)
    : description_(std::move(description)), x_(std::move(x)), y_(std::move(y)), size_(size) {
    for (const std::string& name : y_.names) left_ = std::max(left_, 24 + width_of(name));
    draw_axes();
}

double Plot::at_x(double value) const {
    const double share =
        x_.logarithmic ? std::log(value / x_.low) / std::log(x_.high / x_.low) : (value - x_.low) / (x_.high - x_.low);
    return left_ + share * (size_.width - left_ - right);
}

double Plot::at_y(double value) const {
    const double share =
        y_.logarithmic ? std::log(value / y_.low) / std::log(y_.high / y_.low) : (value - y_.low) / (y_.high - y_.low);
    return size_.height - bottom - share * (size_.height - top - bottom);
}

void Plot::draw_axes() {
    const double floor = size_.height - bottom;
    const double end = size_.width - right;
    const auto column = [&](double x, const std::string& words) {
        body_ += fmt::format("<path class=\"grid\" d=\"M{:.1f} {:.1f}V{:.1f}\"/>", at_x(x), floor, top);
        body_ += fmt::format("<text x=\"{:.1f}\" y=\"{:.1f}\" text-anchor=\"middle\">{}</text>", at_x(x), floor + 16,
                             html_escaped(words));
    };
    const auto row = [&](double y, const std::string& words, bool grid) {
        if (grid) body_ += fmt::format("<path class=\"grid\" d=\"M{:.1f} {:.1f}H{:.1f}\"/>", left_, at_y(y), end);
        body_ += fmt::format("<text x=\"{:.1f}\" y=\"{:.1f}\" text-anchor=\"end\">{}</text>", left_ - 6, at_y(y) + 4,
                             html_escaped(words));
    };
    for (std::size_t i = 0; i < y_.names.size(); ++i) row(static_cast<double>(i) + 0.5, y_.names[i], false);
    for (const double x : ticks(x_, std::max(2, static_cast<int>(size_.width / 90)))) column(x, tick_text(x));
    if (y_.names.empty())
        for (const double y : ticks(y_, std::max(2, static_cast<int>(size_.height / 50)))) row(y, tick_text(y), true);
    body_ += fmt::format("<path class=\"frame\" d=\"M{:.1f} {:.1f}V{:.1f}H{:.1f}\"/>", left_, top, floor, end);
    body_ += fmt::format("<text class=\"label\" x=\"{:.1f}\" y=\"{:.1f}\" text-anchor=\"middle\">{}</text>",
                         (left_ + end) / 2, size_.height - 8, html_escaped(x_.label));
    body_ += fmt::format(
        "<text class=\"label\" transform=\"translate(14 {:.1f}) rotate(-90)\" text-anchor=\"middle\">{}</text>",
        (top + floor) / 2, html_escaped(y_.label));
}

std::string Plot::path(const Points& points, bool closed) const {
    std::string d;
    bool pen_down = false;
    for (const auto& [x, y] : points) {
        const double px = at_x(x);
        const double py = at_y(y);
        if (!std::isfinite(px) || !std::isfinite(py)) {
            pen_down = closed && pen_down;
            continue;
        }
        d += fmt::format("{}{:.1f} {:.1f}", pen_down ? "L" : "M", px, py);
        pen_down = true;
    }
    return closed && pen_down ? d + "Z" : d;
}

void Plot::line(const Points& points, std::string_view style) {
    body_ += fmt::format("<path class=\"line {}\" d=\"{}\"/>", style, path(points, false));
}

void Plot::area(const Points& outline, std::string_view style) {
    body_ += fmt::format("<path class=\"area {}\" d=\"{}\"/>", style, path(outline, true));
}

void Plot::dot(double x, double y, std::string_view style, double radius) {
    if (!std::isfinite(at_x(x)) || !std::isfinite(at_y(y))) return;
    body_ += fmt::format("<circle class=\"dot {}\" cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"{:.1f}\"/>", style, at_x(x), at_y(y),
                         radius);
}

void Plot::cross(double x, double y, std::string_view style, double radius) {
    if (!std::isfinite(at_x(x)) || !std::isfinite(at_y(y))) return;
    body_ +=
        fmt::format("<path class=\"line {0}\" d=\"M{1:.1f} {2:.1f}l{3:.1f} {3:.1f}m0 -{3:.1f}l-{3:.1f} {3:.1f}\"/>",
                    style, at_x(x) - radius, at_y(y) - radius, 2 * radius);
}

void Plot::text(double x, double y, std::string_view words, std::string_view anchor, std::string_view style) {
    if (!std::isfinite(at_x(x)) || !std::isfinite(at_y(y))) return;
    body_ += fmt::format("<text class=\"{}\" x=\"{:.1f}\" y=\"{:.1f}\" text-anchor=\"{}\">{}</text>", style, at_x(x),
                         at_y(y), anchor, html_escaped(words));
}

void Plot::cell(double x, double y, double width, double height, double share, std::string_view style) {
    if (!(share > 0)) return;
    body_ += fmt::format(
        "<rect class=\"area {}\" x=\"{:.1f}\" y=\"{:.1f}\" width=\"{:.1f}\" height=\"{:.1f}\" "
        "fill-opacity=\"{:.2f}\"/>",
        style, at_x(x), at_y(y + height), at_x(x + width) - at_x(x), at_y(y) - at_y(y + height), share);
}

void Plot::colour_bar(std::string_view style, std::string_view words) {
    constexpr int steps = 10;
    for (int k = 1; k <= steps; ++k)
        body_ += fmt::format(
            "<rect class=\"area {}\" x=\"{:.1f}\" y=\"6\" width=\"9\" height=\"11\" fill-opacity=\"{:.2f}\"/>", style,
            left_ + 9 * (k - 1), 1.0 * k / steps);
    body_ += fmt::format("<text x=\"{:.1f}\" y=\"16\">{}</text>", left_ + 9 * steps + 6, html_escaped(words));
}

void Plot::upright(double x, std::string_view style) {
    line({{x, y_.low}, {x, y_.high}}, style);
}

void Plot::level(double y, std::string_view style) {
    line({{x_.low, y}, {x_.high, y}}, style);
}

void Plot::legend(const std::vector<std::pair<std::string, std::string>>& style_and_name) {
    double x = left_ + 4;
    for (const auto& [style, name] : style_and_name) {
        body_ += fmt::format("<text class=\"key {}\" x=\"{:.1f}\" y=\"{:.1f}\">{}</text>", style, x, top - 12,
                             html_escaped(name));
        x += width_of(name) + 3 * letter;
    }
}

std::string Plot::svg() const {
    return fmt::format(
        "<svg viewBox=\"0 0 {0:g} {1:g}\" width=\"{0:g}\" height=\"{1:g}\" role=\"img\" aria-label=\"{2}\">{3}</svg>\n",
        size_.width, size_.height, html_escaped(description_), body_);
}

}  // namespace floes
