#include "page/page.hpp"

#include <span>
#include <sstream>

#include "core/bytes.hpp"
#include "findings/answer.hpp"
#include "page/section_html.hpp"

namespace floes {
namespace {

std::string embedded(const MomentPicture& picture) {
    std::ostringstream text;
    write_base64(text, std::as_bytes(std::span(picture.png)));
    const std::string caption = html_escaped(picture.caption);
    return fmt::format(
        "<figure><img alt=\"{0}\" src=\"data:image/png;base64,{1}\"><figcaption>{0}</figcaption></figure>\n", caption,
        text.str());
}

/// Pictures and commands; nothing without moments.
std::string worst_moments(const ReportData& data) {
    std::string body;
    for (const Moment& moment : data.moments) {
        const MemberRow& row = data.evidence.table.members[static_cast<std::size_t>(moment.member)];
        body += fmt::format("<h3>{}: {} in a single step of member {}</h3>\n",
                            html_escaped(data.evidence.summary.name_of(static_cast<std::size_t>(row.case_index))),
                            data.evidence.units.text(row.load.maximum, "N", 4), moment.member);
        for (const MomentPicture& picture : moment.pictures) body += embedded(picture);
        if (!moment.differences.empty())
            body += note("The member computed for these pictures is not to the bit the one in the file: " +
                         moment.differences.front());
        body += fmt::format("<p>To watch it: <code>{}</code></p>\n",
                            html_escaped(replay_command(data.evidence, moment.member)));
    }
    if (body.empty()) return "";
    return section(data.moments.size() > 1 ? "The worst moments" : "The worst moment", body);
}

/// Neighbours of one page_title share their section; the appendix begins after the loads and what follows them.
std::string findings_html(Evidence& evidence, const std::string& after_loads) {
    std::string parts;
    std::string title;
    std::string body;
    const auto finish = [&] {
        if (!body.empty()) parts += section(title, std::exchange(body, ""));
        if (title == loads_title) parts += after_loads + "<h1 class=\"appendix\">Appendix</h1>\n";
    };
    for (const Finding& finding : findings()) {
        if (finding.page_title.empty() || !finding.on_page(evidence.campaign)) continue;
        if (finding.page_title != title) finish();
        title = finding.page_title;
        for (const Section& one : finding.sections(evidence)) body += section_html(one, title, evidence.units);
    }
    finish();
    return parts;
}

std::string provenance(const ReportData& data) {
    std::string rows;
    for (const auto& [name, value] : data.evidence.origin.facts)
        rows +=
            fmt::format("<tr><td>{}</td><td class=\"words\">{}</td></tr>\n", html_escaped(name), html_escaped(value));
    return section(
        "How it was computed",
        fmt::format("<p>To repeat this campaign, save the configuration below as <code>{}.toml</code> and run</p>\n"
                    "<pre>{}</pre>\n<div class=\"wide\"><table>{}</table></div>\n"
                    "<details><summary>Configuration</summary><pre>{}</pre></details>\n",
                    html_escaped(data.evidence.summary.title), html_escaped(data.command), rows,
                    html_escaped(data.evidence.origin.configuration)));
}

}  // namespace

std::string report_page(ReportData data) {
    const std::string& title = data.evidence.summary.title;
    data.evidence.pictured = !data.moments.empty();
    std::string body = fmt::format("<h1>Loads of managed ice floes: {}</h1>\n", html_escaped(title));
    body += answer_html("The answer", find_answer(data.evidence));
    // In a design the points come first: one of its members is no picture of it.
    const bool design = data.evidence.campaign.design.active();
    if (!design) body += worst_moments(data);
    body += findings_html(data.evidence, design ? worst_moments(data) : "");
    return html_page(title + ": loads of managed ice floes", "", body + provenance(data));
}

}  // namespace floes
