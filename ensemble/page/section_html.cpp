#include "page/section_html.hpp"

#include <algorithm>
#include <cmath>
#include <ranges>
#include <sstream>
#include <utility>

#include <fmt/ranges.h>

#include "core/contract.hpp"
#include "findings/design_points.hpp"
#include "tables/table.hpp"

namespace floes {

namespace {

constexpr std::size_t most_open_rows = 40;

std::string warning_html(const std::string& text) {
    return fmt::format("<p class=\"warning\">{}</p>\n", markup_escaped(text));
}

/// A paragraph for each block of lines, and one for each warning.
std::string paragraphs(const std::string& text) {
    constexpr std::string_view warns = "! ";
    std::istringstream lines(text);
    std::string html;
    std::vector<std::string> block;
    const auto end_block = [&] {
        if (!block.empty()) html += fmt::format("<p>{}</p>\n", fmt::join(std::exchange(block, {}), "<br>\n"));
    };
    for (std::string line; std::getline(lines, line);) {
        const bool warning = line.starts_with(warns);
        if (line.empty() || warning) end_block();
        if (warning)
            html += warning_html(line.substr(warns.size()));
        else if (!line.empty())
            block.push_back(markup_escaped(line));
    }
    end_block();
    return html;
}

std::string closed_table(const std::string& title, const Table& table) {
    return fmt::format("<details><summary>{}</summary>{}</details>\n", markup_escaped(title), html_table(table));
}

std::string open_table(const Table& table) {
    if (table.empty()) return "";
    return table.size() > most_open_rows ? closed_table(fmt::format("{} rows", table.size() - 1), table)
                                         : html_table(table);
}

/// One column of estimates to scale: the least and the largest that it shows, with 0 and its limit.
struct StripScale {
    double low = 0;
    double high = 0;

    StripScale(const Results& results, std::size_t column) {
        const auto reach = [&](double value) {
            if (!std::isfinite(value)) return;
            low = std::min(low, value);
            high = std::max(high, value);
        };
        reach(results.columns[column].limit);
        for (const std::vector<Datum>& row : results.rows)
            if (const Estimate* one = column < row.size() ? std::get_if<Estimate>(&row[column].get()) : nullptr) {
                reach(one->value);
                if (one->said) {
                    reach(one->low);
                    reach(one->high);
                }
            }
    }

    bool any() const { return high > low; }
    double at(double value) const {
        constexpr double air = 5;  // for half a dot at either end
        return air + (strip_width - 2 * air) * (value - low) / (high - low);
    }

    static constexpr double strip_width = 110;
};

/// Bar from 0 to the value, its interval, a dot, and the column's limit.
std::string strip_svg(const Estimate& one, const StripScale& scale, double limit, const std::string& style) {
    if (!scale.any() || !std::isfinite(one.value)) return "";
    const double zero = scale.at(0);
    const double value = scale.at(one.value);
    std::string body = fmt::format(
        "<rect class=\"area {} veil\" x=\"{:.1f}\" y=\"3\" width=\"{:.1f}\" height=\"8\"/><path class=\"frame\" "
        "d=\"M{:.1f} "
        "1V13\"/>",
        style, std::min(zero, value), std::abs(value - zero), zero);
    if (std::isfinite(limit))
        body += fmt::format("<path class=\"line c1 dashed\" d=\"M{0:.1f} 0V14\"/>", scale.at(limit));
    if (one.said && std::isfinite(one.low))
        body += fmt::format("<path class=\"line {} thick\" d=\"M{:.1f} 7H{:.1f}\"/>", style, scale.at(one.low),
                            scale.at(one.high));
    body += fmt::format("<circle class=\"dot {}\" cx=\"{:.1f}\" cy=\"7\" r=\"3.5\"/>", style, value);
    return fmt::format(
        "<svg class=\"strip\" viewBox=\"0 0 {0:g} 14\" width=\"{0:g}\" height=\"14\" aria-hidden=\"true\">{1}</svg>",
        StripScale::strip_width, body);
}

std::string drawn_cell(const Cell& cell, const std::string& heading, const std::string& strip, bool words) {
    std::string content = markup_escaped(cell.value);
    if (cell.range && *cell.range != "–" && !cell.range->empty())
        content += fmt::format(" <small>{}</small>", markup_escaped(*cell.range));
    return fmt::format("<td{} data-head=\"{}\">{}{}</td>", words ? " class=\"words\"" : "", markup_escaped(heading),
                       content, strip);
}

/// Ends of the scales below their columns.
std::string scales_html(const Results& results, const std::vector<std::size_t>& shown,
                        const std::vector<StripScale>& scales, const Units& units) {
    std::string cells;
    bool any = false;
    for (std::size_t c = 0; c < shown.size(); ++c) {
        const ResultColumn& column = results.columns[shown[c]];
        const bool drawn = column.holds == ResultColumn::Holds::estimates && scales[c].any();
        any = any || drawn;
        cells += drawn ? fmt::format("<td><span class=\"scale\"><i>{}</i><i>{}</i></span></td>",
                                     units.number(scales[c].low, column.unit, 2),
                                     units.number(scales[c].high, column.unit, 2))
                       : "<td></td>";
    }
    return any ? fmt::format("<tr class=\"scales\">{}</tr>\n", cells) : "";
}

/// A table whose estimates are drawn in their cells; its rows are for everybody.
std::string drawn_table(const Results& results, const Units& units) {
    constexpr std::size_t few = 5;  // columns that leave room for pictures beside their numbers
    const Table table = shown_table(results, units);
    const bool of_cases = results.columns.front().key == "case";  // else its columns are, as in a pivot
    std::vector<std::size_t> shown;
    for (std::size_t k = 0; k < results.columns.size(); ++k)
        if (!results.columns[k].words.empty()) shown.push_back(k);
    std::vector<StripScale> scales;
    for (const std::size_t column : shown) scales.emplace_back(results, column);
    std::string rows;
    for (const Cell& cell : table.front()) rows += fmt::format("<th>{}</th>", markup_escaped(cell.value));
    rows = "<tr>" + rows + "</tr>\n";
    for (std::size_t r = 0; r < results.rows.size(); ++r) {
        rows += "<tr>";
        for (std::size_t c = 0; c < shown.size(); ++c) {
            const Datum& value = results.rows[r][shown[c]];
            const ResultColumn& column = results.columns[shown[c]];
            const auto* one = std::get_if<Estimate>(&value.get());
            const auto* none = std::get_if<Undefined>(&value.get());
            rows += drawn_cell(table[r + 1][c], table.front()[c].value,
                               one ? strip_svg(*one, scales[c], column.limit, colour(of_cases ? r : c - 1)) : "",
                               none != nullptr && !none->why.empty());
        }
        rows += "</tr>\n";
    }
    return fmt::format("<div class=\"wide drawn{}\"><table>{}{}</table></div>\n", shown.size() <= few ? " few" : "",
                       rows, scales_html(results, shown, scales, units));
}

/// The results, and below them the rows that are closed at first.
std::string results_html(const Results& results, const Units& units) {
    if (results.view == Results::View::drawn) return drawn_table(results, units);
    Table further;
    for (const Results::For whom : {Results::For::folded, Results::For::on_page}) {
        const Table rows = shown_table(results, units, whom);
        further.insert(further.end(), further.empty() ? rows.begin() : rows.begin() + (rows.empty() ? 0 : 1),
                       rows.end());
    }
    return open_table(shown_table(results, units)) + (further.empty() ? "" : closed_table("Further rows", further));
}

/// Figures without a caption stand beside the next one.
std::string figures_html(const std::vector<Figure>& figures, const Units& units) {
    std::string html;
    std::vector<std::string> beside;
    for (const Figure& one : figures) {
        beside.push_back(svg(one, units));
        if (one.caption.empty() && &one != &figures.back()) continue;
        html += beside.size() == 1 ? figure(beside.front(), one.caption) : panels(beside, one.caption);
        beside.clear();
    }
    return html;
}

}  // namespace

std::string section_html(const Section& told, std::string_view heading, const Units& units) {
    std::string html;
    if (!heading.starts_with(told.title)) html = fmt::format("<h3>{}</h3>\n", markup_escaped(told.title));
    html += paragraphs(told.before);
    for (const Results& one : told.results) html += results_html(one, units);
    if (!told.after.empty()) html += note(told.after);
    if (!told.notes.empty()) html += listed(told.notes);
    return html + paragraphs(told.missing) + figures_html(told.figures, units);
}

std::string page_one_html(const std::string& heading, const PageOne& page, const CampaignAnswer& answer,
                          const Units& units) {
    std::string body;
    for (const std::string& one : answer.warnings) body += warning_html(one);
    if (page.sentence.empty()) return section(heading, body + paragraph("No member is done yet."));
    body += section_html(page.table, heading, units);
    if (page.lines) body += section_html(*page.lines, heading, units);
    body += fmt::format("<p class=\"quote\">{}</p>\n", markup_escaped(page.sentence));
    for (const auto& [what, command] : page.next)
        body += fmt::format("<p>{}: <code>{}</code></p>\n", markup_escaped(capital(what)), markup_escaped(command));
    if (!answer.changes.empty()) body += "<h3>What changes the load</h3>\n" + listed(answer.changes);
    return section(heading, body + "<h3>Conditions</h3>\n<div class=\"two\">" + listed(answer.basis) + "</div>\n");
}

std::string sections_page(const std::string& title, std::span<const Section> sections, const std::string& command,
                          const Units& units) {
    std::string body = fmt::format("<h1>{}</h1>\n", markup_escaped(title));
    for (const Section& one : sections) body += section_html(one, title, units);
    body += section("How it was computed", fmt::format("<pre>{}</pre>\n", markup_escaped(command)));
    return html_page(title, "", body);
}

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

/// Share of the axis that lies below the value.
double share_of(const Axis& axis, double value) {
    const double share = axis.logarithmic ? std::log(value / axis.low) / std::log(axis.high / axis.low)
                                          : (value - axis.low) / (axis.high - axis.low);
    return axis.downwards ? 1 - share : share;
}

/// The axis in units of which `factor` are one of its own.
Axis in_units(Axis axis, double factor) {
    axis.low *= factor;
    axis.high *= factor;
    return axis;
}

/// Draws one mark after the other.
class Drawing {
  public:
    Drawing(const Figure& figure, const Units& units) : figure_(figure), units_(units) {
        for (const std::string& name : figure.y.names) left_ = std::max(left_, 24 + width_of(name));
        draw_axes();
        for (const Figure::Mark& mark : figure.marks) std::visit(*this, mark);
        figure.heat_scale.empty() ? draw_legend() : draw_heat_scale();
    }

    /// Drawn `above()` units lower than the figure's own coordinates say, which begin below the first rows of a legend
    /// of several.
    std::string body() const {
        return above_ == 0 ? body_ : fmt::format("<g transform=\"translate(0 {:g})\">{}</g>", above_, body_);
    }
    double above() const { return above_; }

    void operator()(const Figure::Line& mark) {
        body_ += fmt::format("<path class=\"line {}\" d=\"{}\"/>", mark.style, path(mark.points, false));
    }
    void operator()(const Figure::Area& mark) {
        body_ += fmt::format("<path class=\"area {}\" d=\"{}\"/>", mark.style, path(mark.outline, true));
    }
    void operator()(const Figure::Dot& mark) {
        const double x = at_x(mark.x);
        const double y = at_y(mark.y);
        if (!std::isfinite(x) || !std::isfinite(y)) return;
        body_ += mark.cross ? fmt::format(
                                  "<path class=\"line {0}\" d=\"M{1:.1f} {2:.1f}l{3:.1f} {3:.1f}m0 -{3:.1f}l-{3:.1f} "
                                  "{3:.1f}\"/>",
                                  mark.style, x - mark.radius, y - mark.radius, 2 * mark.radius)
                            : fmt::format("<circle class=\"dot {}\" cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"{:.1f}\"/>",
                                          mark.style, x, y, mark.radius);
    }
    void operator()(const Figure::Cell& mark) {
        if (!(mark.share > 0)) return;
        const double low = at_y(mark.y);
        const double high = at_y(mark.y + mark.height);
        body_ += fmt::format(
            "<rect class=\"area {}\" x=\"{:.1f}\" y=\"{:.1f}\" width=\"{:.1f}\" height=\"{:.1f}\" "
            "fill-opacity=\"{:.2f}\"/>",
            mark.style, at_x(mark.x), high, at_x(mark.x + mark.width) - at_x(mark.x), low - high, mark.share);
    }
    void operator()(const Figure::Words& mark) {
        if (std::isfinite(at_x(mark.x)) && std::isfinite(at_y(mark.y)))
            write(at_x(mark.x), at_y(mark.y), mark.words, mark.anchor, mark.style);
    }

  private:
    double at_x(double value) const {
        return left_ + share_of(figure_.x, value) * (figure_.size.width - left_ - right);
    }
    double at_y(double value) const {
        return floor_ - share_of(figure_.y, value) * (figure_.size.height - top - bottom);
    }
    void write(double x, double y, std::string_view words, std::string_view anchor, std::string_view style = {}) {
        body_ += svg_text(x, y, words, anchor, style);
    }
    void draw_axes();
    void draw_legend();
    void draw_heat_scale();
    std::string path(const Figure::Points& points, bool closed) const;

    const Figure& figure_;
    const Units& units_;
    double floor_ = figure_.size.height - bottom;
    double end_ = figure_.size.width - right;
    double left_ = 64;  // wider if names need it
    double above_ = 0;  // height of the legend's rows but the last
    std::string body_;
};

void Drawing::draw_axes() {
    const Axis& x = figure_.x;
    const Axis& y = figure_.y;
    const auto row = [&](double value, const std::string& words) { write(left_ - 6, at_y(value) + 4, words, "end"); };
    for (std::size_t i = 0; i < y.names.size(); ++i) row(static_cast<double>(i) + 0.5, y.names[i]);
    // Ticks are round in the units that are shown; marks stand in those that are stored.
    const double of_x = units_.of(x.unit).factor;
    for (const double value : ticks(in_units(x, of_x), std::max(2, static_cast<int>(figure_.size.width / 90)))) {
        const double at = at_x(value / of_x);
        body_ += fmt::format("<path class=\"grid\" d=\"M{:.1f} {:.1f}V{:.1f}\"/>", at, floor_, top);
        write(at, floor_ + 16, tick_text(value), "middle");
    }
    if (y.names.empty()) {
        const double of_y = units_.of(y.unit).factor;
        for (const double value : ticks(in_units(y, of_y), std::max(2, static_cast<int>(figure_.size.height / 50)))) {
            const double at = value / of_y;
            body_ += fmt::format("<path class=\"grid\" d=\"M{:.1f} {:.1f}H{:.1f}\"/>", left_, at_y(at), end_);
            row(at, tick_text(value));
        }
    }
    body_ += fmt::format("<path class=\"frame\" d=\"M{:.1f} {:.1f}V{:.1f}H{:.1f}\"/>", left_, top, floor_, end_);
    write((left_ + end_) / 2, figure_.size.height - 8, units_.heading(x.label, x.unit), "middle", "label");
    body_ += fmt::format(
        "<text class=\"label\" transform=\"translate(14 {:.1f}) rotate(-90)\" text-anchor=\"middle\">{}</text>",
        (top + floor_) / 2, markup_escaped(units_.heading(y.label, y.unit)));
}

std::string Drawing::path(const Figure::Points& points, bool closed) const {
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

void Drawing::draw_legend() {
    constexpr double row = 18;
    double x = left_ + 4;
    std::vector<std::pair<double, double>> places;  // x, and the row
    double rows = 0;
    for (const auto& [style, name] : figure_.legend) {
        if (x > left_ + 4 && x + width_of(name) > figure_.size.width) {
            x = left_ + 4;
            ++rows;
        }
        places.emplace_back(x, rows);
        x += width_of(name) + 3 * letter;
    }
    above_ = rows * row;
    for (std::size_t k = 0; k < places.size(); ++k) {
        const auto& [style, name] = figure_.legend[k];
        write(places[k].first, top - 12 - (rows - places[k].second) * row, name, "start", "key " + style);
    }
}

void Drawing::draw_heat_scale() {
    constexpr int steps = 10;
    for (int k = 1; k <= steps; ++k)
        body_ += fmt::format(
            "<rect class=\"area heat\" x=\"{:.1f}\" y=\"6\" width=\"9\" height=\"11\" fill-opacity=\"{:.2f}\"/>",
            left_ + 9 * (k - 1), 1.0 * k / steps);
    write(left_ + 9 * steps + 6, 16, figure_.heat_scale, "start");
}

}  // namespace

std::vector<double> ticks(const Axis& axis, int most) {
    FLOES_EXPECTS(axis.low < axis.high && most >= 1 && (!axis.logarithmic || axis.low > 0));
    std::vector<double> found;
    if (axis.logarithmic) {
        const double first = std::ceil(std::log10(axis.low) - 1e-9);
        const double last = std::floor(std::log10(axis.high) + 1e-9);
        const double step = std::max(1.0, std::ceil((last - first) / most));
        for (double decade = first; decade <= last; decade += step) found.push_back(std::pow(10.0, decade));
        if (last - first >= 2) return found;
        // Too few decades to read a value: 2 and 5 times each as well.
        for (double decade = first - 1; decade <= last; ++decade)
            for (const double digit : {2.0, 5.0})
                if (const double value = digit * std::pow(10.0, decade); value >= axis.low && value <= axis.high)
                    found.push_back(value);
        std::ranges::sort(found);
        return found;
    }
    const double rough = (axis.high - axis.low) / most;
    double step = round_above(rough);
    if (axis.step > 0) step = axis.step;
    const double slack = 1e-9 * (axis.high - axis.low);
    for (double i = std::ceil((axis.low - slack) / step); i * step <= axis.high + slack; ++i) found.push_back(i * step);
    return found;
}

std::string svg(const Figure& figure, const Units& units) {
    const Drawing drawing(figure, units);
    return fmt::format(
        "<svg viewBox=\"0 0 {0:g} {1:g}\" width=\"{0:g}\" height=\"{1:g}\" role=\"img\" aria-label=\"{2}\">{3}</svg>\n",
        figure.size.width, figure.size.height + drawing.above(), markup_escaped(figure.description), drawing.body());
}

namespace {

/// The style of a picture by itself: many programs that show SVG know no names of colours.
std::string style_with_colours() {
    std::string style{picture_style};
    for (const auto part : std::views::split(light_colours, ';')) {
        const std::string_view colour(part.begin(), part.end());
        const std::string name = fmt::format("var({})", colour.substr(0, colour.find(':')));
        replace_all(style, name, colour.substr(colour.find(':') + 1));
    }
    return style;
}

/// A file of what is drawn within these sizes.
std::string file_of(double width, double height, const std::string& description, const std::string& body) {
    return fmt::format(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {0:g} {1:g}\" width=\"{0:g}\" height=\"{1:g}\" "
        "role=\"img\" aria-label=\"{2}\"><style>{3}</style><rect width=\"100%\" height=\"100%\" "
        "fill=\"#fff\"/>{4}</svg>\n",
        width, height, markup_escaped(description), style_with_colours(), body);
}

}  // namespace

std::string figure_file(const Figure& figure, const Units& units) {
    const Drawing drawing(figure, units);
    return file_of(figure.size.width, figure.size.height + drawing.above(), figure.description, drawing.body());
}

std::string figures_file(const Section& told) {
    constexpr double margin = 14;
    constexpr double line = 17;
    double width = 0;
    for (const Figure& one : told.figures) width = std::max(width, one.size.width);
    double y = margin + line / 2;
    std::string body;
    const auto write = [&](const std::string& words, std::string_view style) {
        std::istringstream lines(wrapped(words, static_cast<int>((width - 2 * margin) / letter)));
        for (std::string one; std::getline(lines, one); y += line)
            body += fmt::format("<text class=\"{}\" x=\"{:g}\" y=\"{:g}\">{}</text>", style, margin, y,
                                markup_escaped(one));
    };
    write(told.title, "key");
    write(told.before, "");
    for (const std::string& one : told.notes) write(one, "c1");
    for (const Figure& one : told.figures) {
        const Drawing drawing(one, {});
        body += fmt::format("<g transform=\"translate(0 {:g})\">{}</g>", y, drawing.body());
        y += one.size.height + drawing.above() + line / 2;
        if (!one.caption.empty()) write(one.caption, "label");
        y += margin;
    }
    return file_of(width, y, told.title, body);
}

}  // namespace floes
