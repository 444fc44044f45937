#include "page/section_html.hpp"

#include <ranges>
#include <sstream>
#include <utility>

#include <fmt/ranges.h>

#include "page/plot.hpp"

namespace floes {

namespace {

constexpr std::size_t most_open_rows = 40;

std::string warning_html(const std::string& text) {
    return fmt::format("<p class=\"warning\">{}</p>\n", html_escaped(text));
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
            block.push_back(html_escaped(line));
    }
    end_block();
    return html;
}

std::string closed_table(const std::string& title, const Table& table) {
    return fmt::format("<details><summary>{}</summary>{}</details>\n", html_escaped(title), html_table(table));
}

std::string open_table(const Table& table) {
    if (table.empty()) return "";
    return table.size() > most_open_rows ? closed_table(fmt::format("{} rows", table.size() - 1), table)
                                         : html_table(table);
}

/// The results, and below them the rows that are closed at first.
std::string results_html(const Results& results, const Units& units) {
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
    if (!heading.starts_with(told.title)) html = fmt::format("<h3>{}</h3>\n", html_escaped(told.title));
    html += paragraphs(told.before);
    for (const Results& one : told.results) html += results_html(one, units);
    if (!told.after.empty()) html += note(told.after);
    if (!told.notes.empty()) html += listed(told.notes);
    return html + paragraphs(told.missing) + figures_html(told.figures, units);
}

std::string answer_html(const std::string& heading, const CampaignAnswer& answer) {
    std::string body;
    for (const std::string& one : answer.warnings) body += warning_html(one);
    const std::size_t before = body.size();
    for (const std::string& one : answer.loads) body += fmt::format("<p class=\"answer\">{}</p>\n", html_escaped(one));
    if (body.size() == before) body += paragraph("No member is done yet.");
    return section(heading, body + "<h3>What it rests on</h3>\n" + listed(answer.basis) +
                                "<h3>What would change it</h3>\n" + listed(answer.changes));
}

std::string sections_page(const std::string& title, std::span<const Section> sections, const std::string& command,
                          const Units& units) {
    std::string body = fmt::format("<h1>{}</h1>\n", html_escaped(title));
    for (const Section& one : sections) body += section_html(one, title, units);
    body += section("How it was computed", fmt::format("<pre>{}</pre>\n", html_escaped(command)));
    return html_page(title, "", body);
}

namespace {

/// The style of a picture by itself: many programs that show SVG know no names of colours.
std::string style_with_colours() {
    std::string style{picture_style};
    for (const auto part : std::views::split(light_colours, ';')) {
        const std::string_view colour(part.begin(), part.end());
        const std::string name = fmt::format("var({})", colour.substr(0, colour.find(':')));
        for (std::size_t at = 0; (at = style.find(name, at)) != std::string::npos;)
            style.replace(at, name.size(), colour.substr(colour.find(':') + 1));
    }
    return style;
}

}  // namespace

std::string figure_file(const Figure& figure, const Units& units) {
    std::string drawn = svg(figure, units);
    const std::size_t end = drawn.find('>') + 1;
    drawn.insert(end, fmt::format("<style>{}</style><rect width=\"100%\" height=\"100%\" fill=\"#fff\"/>",
                                  style_with_colours()));
    drawn.insert(drawn.find(' '), " xmlns=\"http://www.w3.org/2000/svg\"");
    return drawn;
}

}  // namespace floes
