#include "page/page.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <sstream>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "campaign/case_words.hpp"
#include "core/bytes.hpp"
#include "core/text.hpp"
#include "core/units.hpp"
#include "findings/answer.hpp"
#include "findings/design_load.hpp"
#include "findings/page_one.hpp"
#include "findings/summary.hpp"
#include "page/section_html.hpp"

namespace floes {

namespace {

std::string embedded(const MomentPicture& picture) {
    std::ostringstream text;
    write_base64(text, std::as_bytes(std::span(picture.png)));
    const std::string caption = markup_escaped(picture.caption);
    return fmt::format(
        "<figure><img alt=\"{0}\" src=\"data:image/png;base64,{1}\"><figcaption>{0}</figcaption></figure>\n", caption,
        text.str());
}

/// Pictures and commands; nothing without moments.
std::string worst_moments(const ReportData& data) {
    std::string body;
    for (const Moment& moment : data.moments) {
        const MemberRow& row = data.evidence.table.members[static_cast<std::size_t>(moment.member)];
        body += fmt::format("<h3>{}: member {}</h3>\n",
                            markup_escaped(data.evidence.summary.name_of(static_cast<std::size_t>(row.case_index))),
                            moment.member);
        for (const MomentPicture& picture : moment.pictures) body += embedded(picture);
        if (!moment.differences.empty())
            body += note("The member computed for these pictures is not to the bit the one in the file: " +
                         moment.differences.front());
        body += fmt::format("<p>To watch it: <code>{}</code></p>\n",
                            markup_escaped(replay_command(data.evidence, moment.member, moment.of)));
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
        rows += fmt::format("<tr><td>{}</td><td class=\"words\">{}</td></tr>\n", markup_escaped(name),
                            markup_escaped(value));
    return section(
        "How it was computed",
        fmt::format("<p>To repeat this campaign, save the configuration below as <code>{}.toml</code> and run</p>\n"
                    "<pre>{}</pre>\n<div class=\"wide\"><table>{}</table></div>\n"
                    "<details><summary>Configuration</summary><pre>{}</pre></details>\n",
                    markup_escaped(data.evidence.summary.title), markup_escaped(data.command), rows,
                    markup_escaped(data.evidence.origin.configuration)));
}

/// "Moored hull of 31000 t, 150 m x 28 m at the waterline"; of cases that differ, that they do.
std::string hull_words(const Campaign& campaign) {
    const auto words = [](const Case& one) {
        const Scenario& scenario = one.scenario;
        const std::string hull = scenario.moorings.give_way()
                                     ? fmt::format("Moored hull of {:.6g} t", scenario.moorings.mass / unit::tonne)
                                     : std::string{"Hull"};
        const std::string turns = turn_words(scenario.path).text();
        const Vec2 size = waterline_size(scenario.structure.shape);
        const bool round = std::abs(size.x() - size.y()) < 0.01 * size.x();
        return fmt::format("{}, {}{:.4g} m at the waterline{}", hull, round ? "" : fmt::format("{:.4g} m x ", size.x()),
                           size.y(), turns.empty() ? "" : "; " + turns);
    };
    const std::string first = words(campaign.cases.front());
    const bool alike = std::ranges::all_of(campaign.cases, [&](const Case& one) { return words(one) == first; });
    return alike ? first : first + "; other cases have others";
}

/// A fact of where the file comes from; empty where it has none.
std::string fact(const Evidence& evidence, std::string_view name) {
    for (const auto& [key, value] : evidence.origin.facts)
        if (key == name) return value;
    return "";
}

/// Title, hull, and who made it when and with what.
std::string title_block(const ReportData& data) {
    const std::string& campaign = data.evidence.summary.title;
    std::vector<std::string> made;
    if (!data.author.empty()) made.push_back(data.author);
    if (!data.title.empty()) made.push_back("campaign " + campaign);
    if (const std::string date = fact(data.evidence, "date"); !date.empty()) made.push_back(date.substr(0, 10));
    if (const std::string version = fact(data.evidence, "floes"); !version.empty()) made.push_back("floes " + version);
    return fmt::format("<header class=\"title\"><h1>{}</h1>\n<p>{}</p>\n<p class=\"note\">{}</p></header>\n",
                       markup_escaped(data.title.empty() ? "Ice loads: " + campaign : data.title),
                       markup_escaped(hull_words(data.evidence.campaign)),
                       markup_escaped(fmt::format("{}", fmt::join(made, " · "))));
}

}  // namespace

std::string report_page(ReportData data) {
    const std::string& title = data.evidence.summary.title;
    data.evidence.pictured = !data.moments.empty();
    const PageOne first = find_page_one(data.evidence);
    std::string body = fmt::format("<div class=\"first\">\n{}{}</div>\n", title_block(data),
                                   page_one_html("The answer", first, find_answer(data.evidence), data.evidence.units));
    // In a design the points come first: one of its members is no picture of it.
    const bool design = data.evidence.campaign.design.active();
    if (!design) body += worst_moments(data);
    body += findings_html(data.evidence, design ? worst_moments(data) : "");
    return html_page(data.title.empty() ? "Ice loads: " + title : data.title, "", body + provenance(data));
}

namespace {

constexpr std::size_t few_cases = 12;

/// Done members and, behind them, failed ones; in the next cell how much that is.
std::string bar(const CaseStatus& one) {
    const double all = std::max(1, members_of(one));
    return fmt::format(
        "<span class=\"bar\" role=\"img\" aria-label=\"{0:.0f} % done\"><i style=\"width:{0:.1f}%\"></i><i "
        "class=\"bad\" "
        "style=\"width:{1:.1f}%\"></i></span></td><td>{0:.0f} %",
        one.done / all / unit::percent, one.failed / all / unit::percent);
}

std::string counts_of(const std::vector<CaseStatus>& cases) {
    std::string rows =
        "<tr><th>case</th><th></th><th></th><th>done</th><th>failed</th><th>to do</th><th>members</th></tr>\n";
    for (const CaseStatus& one : cases)
        rows += fmt::format("<tr><td>{}</td><td>{}</td><td>{}</td><td>{}</td><td>{}</td><td>{}</td></tr>\n",
                            markup_escaped(one.name), bar(one), one.done, one.failed, one.missing, members_of(one));
    return "<div class=\"wide\"><table>" + rows + "</table></div>\n";
}

/// All together, then each; a table of many cases is closed at first.
std::string counts(const CampaignStatus& status) {
    if (status.cases.size() == 1) return counts_of(status.cases);
    if (status.cases.size() > few_cases)
        return counts_of({total_of(status)}) + fmt::format("<details><summary>All {} cases</summary>{}</details>\n",
                                                           status.cases.size(), counts_of(status.cases));
    std::vector<CaseStatus> rows{total_of(status)};
    rows.insert(rows.end(), status.cases.begin(), status.cases.end());
    return counts_of(rows);
}

std::string precision(const Evidence& evidence, const std::optional<StopStatus>& stop) {
    const Quantity& largest = headline_maximum(evidence.summary.quantities);
    const std::array shown{quantity("mean_load"), largest};
    Results results{.columns = {{"", "case"}, {"", "arrangements"}}};
    for (const Quantity& one : shown) {
        results.columns.push_back({.words = std::string{one.label.view()},
                                   .unit = "N",
                                   .holds = ResultColumn::Holds::estimates,
                                   .form = ResultColumn::Form::plus_minus});
        results.columns.push_back({.words = "half-width", .unit = "share", .decimals = 1});
    }
    for (const CaseSummary& one : evidence.summary.cases) {
        std::vector<Datum> row{one.about.name, one.done};
        for (const Quantity& quantity : shown) {
            const CaseEstimate& found = one.of(quantity);
            const double share = (found.high - found.low) / 2 / std::abs(found.estimate);
            row.emplace_back(Estimate{found.estimate, found.low, found.high});
            row.push_back(std::isfinite(share) ? Datum(share) : Datum("not known yet"));
        }
        results.add(std::move(row));
    }
    return section_html({.results = {std::move(results)}}, "", evidence.units) +
           note("95 % confidence intervals over the arrangements that are done; maxima of the segments.") +
           paragraph(stop ? stop_sentence(*stop)
                          : "No stop rule: the campaign computes all its members (stop.half_width_percent).");
}

std::string run(const CampaignStatus& status) {
    if (status.sessions.empty()) return paragraph("The campaign file alone does not say how it is run.");
    Table table{{"started", "ended", "host", "ranks", "threads", "job", "reused", "computed", "set aside"}};
    for (auto one = status.sessions.rbegin(); one != status.sessions.rend(); ++one) {
        const bool last = one == status.sessions.rbegin();
        const Cell end = one->ended.empty() ? Cell(last && status.at_work ? "running" : "did not end properly")
                                            : Cell(one->ended, one->outcome);
        table.push_back({one->started, end, one->host, fmt::format("{}", one->ranks), fmt::format("{}", one->threads),
                         one->job.empty() ? "none" : one->job, fmt::format("{}", one->reused),
                         fmt::format("{}", one->computed), fmt::format("{}", one->set_aside)});
    }
    return html_table(table);
}

std::string timed(const std::string& title, const std::vector<TimedMember>& members) {
    if (members.empty()) return "";
    Table table{{"member", "case", "arrangement", "attempt", "time"}};
    for (const TimedMember& one : members)
        table.push_back({fmt::format("{}", one.number), one.case_name, fmt::format("{}", one.arrangement),
                         fmt::format("{}", one.attempt), time_words(one)});
    return fmt::format("<h3>{}</h3>\n", title) + html_table(table);
}

std::string failed(const CampaignStatus& status) {
    if (status.failures.empty()) return "";
    std::vector<std::string> sentences;
    for (const FailedMember& one : status.failures)
        sentences.push_back(fmt::format("Member {} (case {}, arrangement {}): {}", one.number, one.case_name,
                                        one.arrangement, one.reason));
    return section("Failed", listed(sentences));
}

/// What to type next; nothing during a run.
std::string next_step(const CampaignStatus& status, const std::string& file) {
    if (status.at_work) return "";
    const std::string word = shell_word(file);
    const std::string command = total_of(status).missing > 0
                                    ? fmt::format("floes run {} -o {} --resume", configuration_word(status.title), word)
                                    : fmt::format("floes report {}", word);
    return fmt::format("<pre>{}</pre>\n", markup_escaped(command));
}

}  // namespace

std::string status_page(const CampaignSnapshot& snapshot, const std::filesystem::path& campaign_file,
                        const std::string& now) {
    const CampaignStatus& status = snapshot.status;
    Evidence evidence = evidence_of(snapshot.campaign, snapshot.table);
    const bool whole = total_of(status).missing == 0;
    // A design load takes milliseconds a member, and this page is made again and again, on a login node perhaps.
    constexpr int most_extrapolated = 200;
    if (total_of(status).done > most_extrapolated) evidence.kept.set(DesignLoads{});
    const std::string when =
        status.at_work ? fmt::format("As of {}; this page loads itself again every {} s while the run is active.", now,
                                     status_page_seconds)
                       : fmt::format("As of {}.", now);
    const std::string refresh =
        status.at_work ? fmt::format("<meta http-equiv=\"refresh\" content=\"{}\">\n", status_page_seconds) : "";
    const std::string drawn = fmt::format("<p>To see what is computed: <code>floes show {}</code></p>\n",
                                          markup_escaped(configuration_word(status.title)));
    return html_page(counts_sentence(status), refresh,
                     fmt::format("<h1>{}</h1>\n<p>{}</p>\n", markup_escaped(counts_sentence(status)),
                                 markup_escaped(work_sentence(status))) +
                         drawn + next_step(status, campaign_file.string()) + counts(status) + note(when) +
                         page_one_html(whole ? "The answer" : "The answer so far", find_page_one(evidence),
                                       find_answer(evidence), evidence.units) +
                         section(whole ? "Precision" : "Precision so far", precision(evidence, status.stop)) +
                         failed(status) +
                         section("The run", run(status) + timed("Running members, longest first", status.under_way) +
                                                timed("Slowest members", status.slowest)));
}

}  // namespace floes
