#include "page/match_page.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include <fmt/format.h>

#include "core/contract.hpp"
#include "core/text.hpp"
#include "core/units.hpp"
#include "page/section_html.hpp"
#include "tables/table.hpp"

namespace floes {

namespace {

int cell_of(double coordinate, int count) {
    return std::clamp(static_cast<int>(std::floor((coordinate + 1) / 2 * count)), 0, count - 1);
}

/// Share of the points in each of `count` places that is not ruled out; NaN without points. `place_of`: a row's.
std::vector<double> shares(const Matching& found, std::size_t count, const auto& place_of) {
    std::vector<int> points(count, 0);
    std::vector<int> left(count, 0);
    for (int row = 0; row < found.sampled; ++row) {
        const std::size_t at = place_of(row);
        ++points[at];
        left[at] += found.implausibility[row] <= ruled_out_above;
    }
    std::vector<double> made;
    for (std::size_t k = 0; k < count; ++k)
        made.push_back(points[k] > 0 ? static_cast<double>(left[k]) / points[k] : undefined);
    return made;
}

}  // namespace

int match_cell_count(const Matching& found) {
    return std::clamp(static_cast<int>(std::sqrt(found.sampled / 8.0)), 4, 16);
}

MatchCells match_cells(const Matching& found, int first_axis, int second_axis, int side) {
    FLOES_EXPECTS(side >= 1 && first_axis >= 0 && second_axis >= 0);
    const auto cells = static_cast<std::size_t>(side * side);
    const auto cell_at = [&](int row) {
        return static_cast<std::size_t>(cell_of(found.points(row, second_axis), side) * side +
                                        cell_of(found.points(row, first_axis), side));
    };
    MatchCells made{side, std::vector<double>(cells, undefined), shares(found, cells, cell_at)};
    for (int row = 0; row < found.sampled; ++row) {
        double& least = made.least[cell_at(row)];
        least = std::fmin(least, found.implausibility[row]);  // fmin ignores the NaN of an empty cell
    }
    return made;
}

std::vector<double> share_along(const Matching& found, int axis, int count) {
    return shares(found, static_cast<std::size_t>(count),
                  [&](int row) { return static_cast<std::size_t>(cell_of(found.points(row, axis), count)); });
}

namespace {

constexpr double whole_width = 800;
constexpr double small_letter = 5.7;  // approximate width of one in small print
constexpr double line_height = 12;
constexpr double gap = 6;
constexpr double key_height = 46;
constexpr double tick_width = 46;

/// A colour of cells with values up to and including `up_to`.
struct Band {
    double up_to;
    const char* style;
    double opacity;
    const char* words;
};

constexpr double no_end = std::numeric_limits<double>::infinity();

// Two hues that meet at 3, where a point is ruled out.
constexpr Band implausibility_bands[]{{1, "cold", 0.95, "up to 1"}, {2, "cold", 0.6, "2"},
                                      {3, "cold", 0.3, "3"},        {5, "heat", 0.3, "5"},
                                      {10, "heat", 0.6, "10"},      {no_end, "heat", 0.95, "more"}};
// A few per cent matter as much as many, since a narrow region of many inputs leaves little in any cell.
constexpr Band depth_bands[]{{0, "void", 1, "0"},        {0.01, "mild", 0.2, "up to 1 %"}, {0.03, "mild", 0.4, "3 %"},
                             {0.1, "mild", 0.6, "10 %"}, {0.3, "mild", 0.8, "30 %"},       {1, "mild", 1, "100 %"}};

std::string fill(const Band& band, const std::string& shape) {
    return fmt::format("<path class=\"{}\" fill-opacity=\"{:g}\" d=\"{}\"/>", band.style, band.opacity, shape);
}

std::string words(double x, double y, const char* anchor, const std::string& text, const char* style = "small") {
    return text.empty() ? "" : svg_text(x, y, text, anchor, style);
}

/// One panel, on the screen: coordinates -1 to 1 from left to right and from the floor up.
struct Panel {
    double left;
    double top;
    double side;

    double x(double coordinate) const { return left + (coordinate + 1) / 2 * side; }
    double y(double coordinate) const { return top + (1 - coordinate) / 2 * side; }
    bool holds(double a, double b) const { return std::abs(a) <= 1 && std::abs(b) <= 1; }
    std::string frame() const {
        return fmt::format("<path class=\"frame\" d=\"M{:.1f} {:.1f}h{:.1f}v{:.1f}h-{:.1f}z\"/>", left, top, side, side,
                           side);
    }
};

/// Cells in the colours of their values; neighbours of one colour are drawn together. Nothing where value(i, k) is NaN.
template <std::size_t N, typename Value>
std::string coloured(const Panel& panel, int count, const Band (&bands)[N], const Value& value) {
    std::vector<std::string> shapes(N);
    const auto band_of = [&](int i, int k) {
        const double shown = value(i, k);
        if (std::isnan(shown)) return N;
        return static_cast<std::size_t>(std::ranges::find_if(bands, [&](const Band& b) { return shown <= b.up_to; }) -
                                        bands);
    };
    const double size = panel.side / count;
    for (int k = 0; k < count; ++k) {
        for (int i = 0; i < count;) {
            const std::size_t band = band_of(i, k);
            const int begin = i;
            while (i < count && band_of(i, k) == band) ++i;
            if (band == N) continue;
            shapes[band] +=
                fmt::format("M{:.1f} {:.1f}h{:.1f}v{:.1f}h-{:.1f}z", panel.left + begin * size,
                            panel.top + (count - 1 - k) * size, (i - begin) * size, size, (i - begin) * size);
        }
    }
    std::string body;
    for (std::size_t b = 0; b < N; ++b)
        if (!shapes[b].empty()) body += fill(bands[b], shapes[b]);
    return body;
}

/// Edges between cells on either side of the level.
std::string level_line(const Panel& panel, const MatchCells& cells) {
    std::string shape;
    const double size = panel.side / cells.side;
    const auto differ = [](double a, double b) {
        return !std::isnan(a) && !std::isnan(b) && (a <= ruled_out_above) != (b <= ruled_out_above);
    };
    for (int k = 0; k < cells.side; ++k) {
        for (int i = 0; i < cells.side; ++i) {
            const double x = panel.left + (i + 1) * size;
            const double y = panel.top + (cells.side - 1 - k) * size;
            if (i + 1 < cells.side && differ(cells.least_at(i, k), cells.least_at(i + 1, k)))
                shape += fmt::format("M{:.1f} {:.1f}v{:.1f}", x, y, size);
            if (k + 1 < cells.side && differ(cells.least_at(i, k), cells.least_at(i, k + 1)))
                shape += fmt::format("M{:.1f} {:.1f}h-{:.1f}", x, y, size);
        }
    }
    return shape.empty() ? "" : fmt::format("<path class=\"line\" d=\"{}\"/>", shape);
}

std::string best_point(const Panel& panel, const Matching& found, int x, int y) {
    return fmt::format("<path class=\"line\" d=\"M{:.1f} {:.1f}l8 8m0 -8l-8 8\"/>", panel.x(found.best[x]) - 4,
                       panel.y(found.best[y]) - 4);
}

std::string pair_panel(const Panel& panel, const MatchData& data, const Matching& found, int x, int y, int count) {
    const MatchCells cells = match_cells(found, x, y, count);
    if (y < x)
        return coloured(panel, count, depth_bands, [&](int i, int k) { return cells.depth_at(i, k); }) +
               best_point(panel, found, x, y) + panel.frame();
    std::string body =
        coloured(panel, count, implausibility_bands, [&](int i, int k) { return cells.least_at(i, k); }) +
        level_line(panel, cells);
    for (const MatchPoint& point : data.points) {
        const double a = point.coordinates[static_cast<std::size_t>(x)];
        const double b = point.coordinates[static_cast<std::size_t>(y)];
        if (panel.holds(a, b))
            body +=
                fmt::format("<circle class=\"dot\" cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"1.5\"/>", panel.x(a), panel.y(b));
    }
    return body + best_point(panel, found, x, y) + panel.frame();
}

/// Bars up to the largest share, which is written above them.
std::string share_panel(const Panel& panel, const Matching& found, int axis, int count) {
    const std::vector<double> shares = share_along(found, axis, count);
    double largest = 0;
    for (const double share : shares) largest = std::fmax(largest, share);
    std::string shape;
    const double size = panel.side / count;
    const double room = panel.side - 18;
    for (std::size_t k = 0; k < shares.size() && largest > 0; ++k) {
        if (!(shares[k] > 0)) continue;
        const double height = shares[k] / largest * room;
        shape += fmt::format("M{:.1f} {:.1f}v-{:.1f}h{:.1f}v{:.1f}z", panel.left + static_cast<double>(k) * size,
                             panel.top + panel.side, height, size, height);
    }
    return (shape.empty() ? "" : fill(depth_bands[5], shape)) + panel.frame() +
           words(panel.left + panel.side / 2, panel.top + 12, "middle",
                 largest > 0 ? fmt::format("up to {:.3g} %", largest / unit::percent) : "nothing left");
}

/// A key on lines of at most `letters`, broken after dots and underscores.
std::vector<std::string> name_lines(const RangedAxis& axis, std::size_t letters) {
    std::vector<std::string> lines{""};
    std::string piece;
    const auto place = [&] {
        if (!lines.back().empty() && lines.back().size() + piece.size() > letters) lines.emplace_back();
        lines.back() += piece;
        piece.clear();
    };
    for (const char c : axis.key) {
        piece += c;
        if (c == '.' || c == '_') place();
    }
    place();
    piece = axis.scale == AxisScale::log ? " (log)" : "";
    place();
    return lines;
}

struct Scale {
    std::string low;
    std::string middle;  ///< empty where there is no room for it
    std::string high;
};

Scale scale_of(const RangedAxis& axis, double room) {
    const auto told = [&](double coordinate) {
        const double value = axis.value(coordinate);
        return std::abs(value) >= 1000 && std::abs(value) < 1e6 ? fmt::format("{:.0f}", value)
                                                                : fmt::format("{:.3g}", value);
    };
    Scale made{told(-1), told(0), told(1)};
    const std::size_t longest = std::max(made.low.size(), made.high.size());
    const double needed = small_letter * static_cast<double>(2 * longest + made.middle.size() + 3);
    if (needed > room) made.middle.clear();
    return made;
}

template <std::size_t N>
std::string key_row(double x, double y, const char* title, const Band (&bands)[N]) {
    std::string body = words(x, y + 10, "start", title);
    x += 150;
    for (const Band& band : bands) {
        body += fill(band, fmt::format("M{:.1f} {:.1f}h14v11h-14z", x, y));
        body += words(x + 18, y + 10, "start", band.words);
        x += 30 + small_letter * static_cast<double>(text_width(band.words));
    }
    return body;
}

/// A square of panels, inputs in the order of the axes from left to right and from top to bottom. Below the diagonal
/// the least implausibility of each cell, a line round what is not ruled out, and the simulated points; above it the
/// optical depth; on it the share left along the input. Scales and names stand at the edges only.
std::string match_grid(const MatchData& data, const Matching& found) {
    const int count = static_cast<int>(data.axes.size());
    const int cells = match_cell_count(found);
    // Names take as many lines as they need, usually three; the panels share the rest.
    const double rough = std::min(210.0, (whole_width - 3 * line_height - tick_width) / count - gap);
    std::vector<std::vector<std::string>> names;
    std::size_t lines = 1;
    for (const RangedAxis& axis : data.axes) {
        names.push_back(name_lines(axis, static_cast<std::size_t>(rough / small_letter)));
        lines = std::max(lines, names.back().size());
    }
    const double name_room = line_height * static_cast<double>(lines);
    const double left = name_room + tick_width + 4;
    const double side = std::min(210.0, (whole_width - left - 2) / count - gap);
    const double pitch = side + gap;
    const double bottom = key_height + count * pitch;
    const double width = std::max(left + count * pitch, 560.0);
    std::string body = key_row(left, 2, "Below: least implausibility", implausibility_bands) +
                       key_row(left, 20, "Above: share not ruled out", depth_bands);
    for (int row = 0; row < count; ++row) {
        for (int column = 0; column < count; ++column) {
            const Panel panel{left + column * pitch, key_height + row * pitch, side};
            body += row == column ? share_panel(panel, found, row, cells)
                                  : pair_panel(panel, data, found, column, row, cells);
        }
    }
    for (int k = 0; k < count; ++k) {
        const auto axis = static_cast<std::size_t>(k);
        const Scale scale = scale_of(data.axes[axis], side);
        const double x = left + k * pitch;
        const double y = key_height + k * pitch;
        body += words(x, bottom + 8, "start", scale.low) + words(x + side / 2, bottom + 8, "middle", scale.middle) +
                words(x + side, bottom + 8, "end", scale.high);
        body += words(left - 4, y + side, "end", scale.low) + words(left - 4, y + side / 2 + 4, "end", scale.middle) +
                words(left - 4, y + 9, "end", scale.high);
        for (std::size_t line = 0; line < names[axis].size(); ++line) {
            const double down = line_height * static_cast<double>(line);
            body += words(x + side / 2, bottom + 24 + down, "middle", names[axis][line], "small label");
            body += fmt::format(
                "<text class=\"small label\" transform=\"translate({:.1f} {:.1f}) rotate(-90)\" "
                "text-anchor=\"middle\">{}</text>",
                10 + down, y + side / 2, markup_escaped(names[axis][line]));
        }
    }
    return fmt::format(
        "<svg viewBox=\"0 0 {0:.0f} {1:.0f}\" width=\"{0:.0f}\" height=\"{1:.0f}\" role=\"img\" "
        "aria-label=\"What is not ruled out, for each pair of inputs\">{2}</svg>\n",
        width, bottom + 20 + name_room, body);
}

std::string titled(const Section& told) {
    return section(told.title, section_html(told, told.title));
}

/// What is left: along the only input, or for each pair of them.
std::string pairs(const MatchPageData& told) {
    if (told.data.axes.size() == 1)
        return titled({.title = "What is left along the input", .figures = {along_figure(told.data, told.found)}});
    return section(
        "What is left, for each pair of inputs",
        figure(match_grid(told.data, told.found),
               fmt::format("Of {} points of the inputs' ranges. Below the diagonal: the smallest implausibility of the "
                           "points in each cell, whatever the other inputs; the line is where it passes {:g}, above "
                           "which a point is ruled out; dots are the points simulated. Above the diagonal: share of "
                           "the points in each cell that is not ruled out. On the diagonal: that share along one "
                           "input. The cross is the best point.",
                           told.found.sampled, ruled_out_above)));
}

std::string trail(const std::vector<MatchTrail>& waves) {
    Results results{.columns = {{"", "up to wave"},
                                {"", "points simulated"},
                                {.words = "not ruled out", .unit = "share", .digits = 3}}};
    for (const MatchTrail& wave : waves) results.add({wave.file, wave.points, wave.share});
    return titled({.title = "Wave by wave", .results = {std::move(results)}});
}

}  // namespace

std::string match_page(const MatchPageData& told) {
    const std::vector<Section> sections = match_sections(told.data, told.targets, told.found);
    std::string body = "<h1>What the measured loads leave possible</h1>\n" + titled(sections.at(0)) +
                       titled(sections.at(1)) + pairs(told);
    for (std::size_t k = 2; k < sections.size(); ++k) body += titled(sections[k]);
    for (const Section& one : told.predictions) body += titled(one);
    body += titled(check_section(told.targets));
    if (told.trail.size() > 1) body += trail(told.trail);
    body += section("How it was computed", fmt::format("<pre>{}</pre>\n", markup_escaped(told.command)));
    return html_page("What the measured loads leave possible", "", body);
}

}  // namespace floes
