#include "tables/figure_text.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <ranges>
#include <string_view>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "core/text.hpp"
#include "tables/table.hpp"

namespace floes {

namespace {

enum class Ground : std::uint8_t { open, ice, hull, sheet };

// The signs of one set of letters; braille stands for ice and what has no sign of its own.
struct Signs {
    std::string_view hull, sheet, ice, way, way_measured, line, dot, cross, bar, bar_end;
};
constexpr Signs in_unicode{"█", "░", "⣿", "─", "━", "·", "●", "×", "─", "┴"};
constexpr Signs in_ascii{"#", "%", "o", "-", "=", ".", "@", "x", "-", "|"};

bool has_word(std::string_view style, std::string_view word) {
    return std::ranges::any_of(std::views::split(style, ' '),
                               [&](const auto& one) { return std::ranges::equal(one, word); });
}

/// Dots, two by four to a character, and signs over them.
class Screen {
  public:
    Screen(const Figure& figure, int columns, int rows, Letters letters)
        : figure_(figure), letters_(letters), signs_(letters == Letters::unicode ? in_unicode : in_ascii) {
        const double width = figure.x.high - figure.x.low;
        const double height = figure.y.high - figure.y.low;
        metres_ = std::max(width / (dots_across * columns), height / (dots_up * rows));
        columns_ = std::max(1, static_cast<int>(std::ceil(width / metres_ / dots_across - 1e-9)));
        rows_ = std::max(1, static_cast<int>(std::ceil(height / metres_ / dots_up - 1e-9)));
        grounds_.resize(static_cast<std::size_t>(dots_across * columns_ * dots_up * rows_), {0, Ground::open});
        over_.resize(static_cast<std::size_t>(columns_ * rows_));
        for (const Figure::Mark& mark : figure.marks) std::visit(*this, mark);
    }

    void operator()(const Figure::Area& mark) {
        ++areas_;
        if (has_word(mark.style, "ice")) return fill(mark.outline, Ground::ice);
        if (has_word(mark.style, "structure")) return fill(mark.outline, Ground::hull);
        if (has_word(mark.style, "sheet")) fill(mark.outline, Ground::sheet);
    }
    void operator()(const Figure::Line& mark) {
        const bool way = has_word(mark.style, "c0");
        const bool measured = has_word(mark.style, "c1");
        if (!way && !measured && !has_word(mark.style, "c3")) return;  // no room for the finer ones
        const std::string_view sign = measured ? signs_.way_measured : way ? signs_.way : signs_.line;
        for (std::size_t k = 0; k + 1 < mark.points.size(); ++k) draw(mark.points[k], mark.points[k + 1], sign);
    }
    void operator()(const Figure::Dot& mark) {
        put(at_x(mark.x), at_y(mark.y), mark.cross ? signs_.cross : signs_.dot);
    }
    void operator()(const Figure::Cell&) {}
    void operator()(const Figure::Words&) {}

    std::string text() const {
        std::string all;
        for (int row = 0; row < rows_; ++row) {
            std::string line;
            for (int column = 0; column < columns_; ++column) line += cell(column, row);
            while (line.ends_with(' ')) line.pop_back();
            all += line + "\n";
        }
        return all + bar();
    }

    /// What the signs mean that are to be seen.
    std::string key() const {
        const auto drawn = [&](Ground ground) {
            return std::ranges::any_of(grounds_, [&](const auto& one) { return one.second == ground; });
        };
        std::string words;
        const auto say = [&](bool seen, std::string_view sign, std::string_view what) {
            if (seen) words += fmt::format("{}{} {}", words.empty() ? "" : "  ", sign, what);
        };
        say(drawn(Ground::hull), signs_.hull, "hull");
        say(drawn(Ground::ice), signs_.ice, "ice");
        say(drawn(Ground::sheet), signs_.sheet, figure_.y.downwards ? "ice sheet" : "bed");
        say(shows(signs_.way), signs_.way, "way");
        say(shows(signs_.way_measured), signs_.way_measured, "measured");
        say(shows(signs_.line), signs_.line, "mooring line");
        say(shows(signs_.cross), signs_.cross, "anchor");
        return words.empty() ? "" : words + "\n";
    }

  private:
    static constexpr int dots_across = 2;
    static constexpr int dots_up = 4;

    int at_x(double x) const { return static_cast<int>(std::floor((x - figure_.x.low) / metres_)); }
    int at_y(double y) const {
        return static_cast<int>(std::floor((figure_.y.downwards ? y - figure_.y.low : figure_.y.high - y) / metres_));
    }
    double x_of(int dot) const { return figure_.x.low + (dot + 0.5) * metres_; }
    double y_of(int dot) const {
        return figure_.y.downwards ? figure_.y.low + (dot + 0.5) * metres_ : figure_.y.high - (dot + 0.5) * metres_;
    }
    std::size_t index(int x, int y) const {
        return static_cast<std::size_t>(y) * static_cast<std::size_t>(dots_across * columns_) +
               static_cast<std::size_t>(x);
    }
    bool shows(std::string_view sign) const { return std::ranges::find(over_, sign) != over_.end(); }

    /// Dots whose middles lie within, by the lines of dots that the outline crosses.
    void fill(const Figure::Points& outline, Ground ground) {
        for (int y = 0; y < dots_up * rows_; ++y) {
            std::vector<double> crossed;
            for (std::size_t k = 0; k < outline.size(); ++k) {
                const auto& a = outline[k];
                const auto& b = outline[(k + 1) % outline.size()];
                const double level = y_of(y);
                if ((a.second <= level) == (b.second <= level)) continue;
                crossed.push_back(a.first + (level - a.second) / (b.second - a.second) * (b.first - a.first));
            }
            std::ranges::sort(crossed);
            for (std::size_t k = 0; k + 1 < crossed.size(); k += 2) {
                const int first = std::max(0, static_cast<int>(std::ceil((crossed[k] - x_of(0)) / metres_)));
                const int last = std::min(dots_across * columns_ - 1,
                                          static_cast<int>(std::floor((crossed[k + 1] - x_of(0)) / metres_)));
                for (int x = first; x <= last; ++x) grounds_[index(x, y)] = {areas_, ground};
            }
        }
    }

    void draw(const std::pair<double, double>& from, const std::pair<double, double>& to, std::string_view sign) {
        const double along = to.first - from.first;
        const double up = to.second - from.second;
        if (!std::isfinite(along) || !std::isfinite(up)) return;
        const int parts = std::max(1, static_cast<int>(std::ceil(std::hypot(along, up) / metres_)));
        for (int k = 0; k <= parts; ++k)
            put(at_x(from.first + along * k / parts), at_y(from.second + up * k / parts), sign);
    }

    void put(int x, int y, std::string_view sign) {
        const int column = x / dots_across;
        const int row = y / dots_up;
        if (x < 0 || y < 0 || column >= columns_ || row >= rows_) return;
        over_[static_cast<std::size_t>(row) * static_cast<std::size_t>(columns_) + static_cast<std::size_t>(column)] =
            sign;
    }

    /// Ice is dark where another floe begins to its right or below, so that floes that touch are seen apart.
    bool lit(int x, int y) const {
        const auto& [area, ground] = grounds_[index(x, y)];
        if (ground == Ground::hull) return true;
        if (ground != Ground::ice) return false;
        const auto other = [&](int at_x, int at_y) {
            if (at_x >= dots_across * columns_ || at_y >= dots_up * rows_) return false;
            const auto& beside = grounds_[index(at_x, at_y)];
            return beside.second == Ground::ice && beside.first != area;
        };
        return !other(x + 1, y) && !other(x, y + 1);
    }

    std::string cell(int column, int row) const {
        const std::string_view sign = over_[static_cast<std::size_t>(row) * static_cast<std::size_t>(columns_) +
                                            static_cast<std::size_t>(column)];
        if (!sign.empty()) return std::string(sign);
        int hull = 0;
        int sheet = 0;
        int bright = 0;
        std::uint32_t braille = 0;
        constexpr std::array<std::array<int, 4>, 2> bits{
            {{0, 1, 2, 6}, {3, 4, 5, 7}}};  // of Unicode, by column and row
        for (int x = 0; x < dots_across; ++x)
            for (int y = 0; y < dots_up; ++y) {
                const int at_x = dots_across * column + x;
                const int at_y = dots_up * row + y;
                hull += grounds_[index(at_x, at_y)].second == Ground::hull ? 1 : 0;
                sheet += grounds_[index(at_x, at_y)].second == Ground::sheet ? 1 : 0;
                if (!lit(at_x, at_y)) continue;
                ++bright;
                braille |= 1U << bits.at(static_cast<std::size_t>(x)).at(static_cast<std::size_t>(y));
            }
        constexpr int half = dots_across * dots_up / 2;
        if (hull >= half) return std::string(signs_.hull);
        if (sheet >= half) return std::string(signs_.sheet);
        if (letters_ == Letters::ascii) return bright >= half ? std::string(signs_.ice) : " ";
        if (braille == 0) return " ";
        // U+2800 and what is lit, as UTF-8.
        return {'\xE2', static_cast<char>(0xA0 | braille >> 6), static_cast<char>(0x80 | (braille & 0x3F))};
    }

    /// About a fifth of the width.
    std::string bar() const {
        const double width = columns_ * dots_across * metres_;
        const double length = round_below(width / 5);
        const int letters = std::max(2, static_cast<int>(std::lround(length / metres_ / dots_across)));
        std::string line(signs_.bar_end);
        for (int k = 2; k < letters; ++k) line += signs_.bar;
        return fmt::format("{}{} {:g} m\n", line, signs_.bar_end, length);
    }

    const Figure& figure_;
    Letters letters_;
    Signs signs_;
    double metres_ = 1;  ///< a dot
    int columns_ = 1;
    int rows_ = 1;
    std::uint32_t areas_ = 0;
    std::vector<std::pair<std::uint32_t, Ground>> grounds_;  ///< of each dot: which area, and what it is
    std::vector<std::string_view> over_;                     ///< sign of each character; empty: none
};

}  // namespace

std::string figure_text(const Figure& figure, int columns, int rows, Letters letters) {
    const Screen screen(figure, columns, rows, letters);
    return screen.text() + screen.key();
}

}  // namespace floes
