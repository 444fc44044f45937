#include "page/section_html.hpp"

#include <sstream>

#include "page/html_parts.hpp"
#include "page/plot.hpp"

namespace floes {
namespace {

constexpr std::size_t most_open_rows = 40;

/// A paragraph for each block of lines.
std::string paragraphs(const std::string& text) {
    std::istringstream lines(text);
    std::string html;
    std::string block;
    for (std::string line; std::getline(lines, line);) {
        if (!line.empty()) {
            block += (block.empty() ? "" : " ") + line;
        } else if (!block.empty()) {
            html += paragraph(std::exchange(block, ""));
        }
    }
    return block.empty() ? html : html + paragraph(block);
}

std::string closed_table(const std::string& title, const Table& table) {
    return fmt::format("<details><summary>{}</summary>{}</details>\n", html_escaped(title), html_table(table));
}

std::string tables_html(const Section& told) {
    std::string html;
    if (told.table.size() > most_open_rows) {
        html = closed_table(fmt::format("{} rows", told.table.size() - 1), told.table);
    } else if (!told.table.empty()) {
        html = html_table(told.table);
    }
    if (told.folded.empty() && told.on_page.empty()) return html;
    Table further{told.table.front()};
    for (const Table* rows : {&told.folded, &told.on_page}) further.insert(further.end(), rows->begin(), rows->end());
    return html + closed_table("Further rows", further);
}

/// Figures without a caption stand beside the next one.
std::string figures_html(const std::vector<Figure>& figures) {
    std::string html;
    std::vector<std::string> beside;
    for (const Figure& one : figures) {
        beside.push_back(svg(one));
        if (one.caption.empty() && &one != &figures.back()) continue;
        html += beside.size() == 1 ? figure(beside.front(), one.caption) : panels(beside, one.caption);
        beside.clear();
    }
    return html;
}

}  // namespace

std::string section_html(const Section& told, std::string_view heading) {
    std::string html;
    if (!heading.starts_with(told.title)) html = fmt::format("<h3>{}</h3>\n", html_escaped(told.title));
    html += paragraphs(told.before) + tables_html(told);
    if (!told.after.empty()) html += note(told.after);
    if (!told.notes.empty()) html += listed(told.notes);
    return html + paragraphs(told.missing) + figures_html(told.figures);
}

std::string answer_html(const std::string& heading, const CampaignAnswer& answer) {
    std::string body;
    for (const std::string& one : answer.warnings)
        body += fmt::format("<p class=\"warning\">{}</p>\n", html_escaped(one));
    const std::size_t before = body.size();
    for (const std::string& one : answer.loads) body += fmt::format("<p class=\"answer\">{}</p>\n", html_escaped(one));
    if (body.size() == before) body += paragraph("No member is done yet.");
    return section(heading, body + "<h3>What it rests on</h3>\n" + listed(answer.basis) +
                                "<h3>What would change it</h3>\n" + listed(answer.changes));
}

}  // namespace floes
