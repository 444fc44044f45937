// floes summarize: what a campaign file says, as a table, JSON or CSV. Works on incomplete campaigns too.

#include <algorithm>
#include <cstdio>
#include <memory>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "campaign_file/read_details.hpp"
#include "cli/commands.hpp"
#include "cli/terminal.hpp"
#include "core/error.hpp"
#include "core/units.hpp"
#include "findings/findings.hpp"
#include "findings/pairs_text.hpp"
#include "findings/steady_text.hpp"

namespace floes {

namespace {

struct SummarizeOptions {
    std::string file;
    std::string format = "table";
    std::string reference;
    std::vector<std::string> parts;
    double resolve_percent = 10;
    std::string window = "given";
};

/// What is shown unless parts are named: what suits the campaign as table and JSON, and the one CSV that most want.
std::vector<std::string> default_parts(const std::string& format, const Campaign& campaign) {
    if (format == "csv") return {"cases"};
    std::vector<std::string> parts{"cases"};
    if (campaign.design.active()) parts.push_back("sensitivity");
    if (in_detail(campaign)) parts.insert(parts.end(), {"pairs", "extremes"});
    return parts;
}

Findings find(const SummarizeOptions& options) {
    Findings findings;
    findings.table = read_campaign_file(options.file);
    const Campaign campaign = campaign_of(read_origin(options.file), options.file);
    const std::vector<std::string> parts =
        options.parts.empty() ? default_parts(options.format, campaign) : options.parts;
    const auto wanted = [&](const char* part) { return std::ranges::find(parts, part) != parts.end(); };
    const bool automatic = options.window == "auto";
    if (automatic || wanted("steady")) findings.steady = find_steady(options.file, findings.table);
    if (automatic) findings.table = with_automatic_window(options.file, findings.table, *findings.steady);
    findings.summary = summarise(findings.table);
    if (!options.reference.empty()) findings.reference = case_index(findings.summary, options.reference);
    findings.show_cases = wanted("cases");
    if (wanted("pairs")) {
        findings.pair_options = {findings.reference, options.resolve_percent * unit::percent};
        findings.pairs = compare_pairs(findings.table, findings.pair_options);
    }
    if (wanted("points")) findings.points = find_points(campaign);
    if (wanted("sensitivity")) findings.sensitivity = find_sensitivity(campaign, findings.table);
    findings.show_extremes = wanted("extremes");
    findings.exceedance = wanted("exceedance");
    if (findings.show_extremes || findings.exceedance) findings.extremes = find_extremes(findings.table);
    if (findings.exceedance) findings.levels = find_levels(findings.table);
    if (!wanted("steady")) findings.steady.reset();
    if (findings.steady && findings.steady->members.empty() && options.format != "table")
        std::fputs(fmt::format("floes: {}", no_histories).c_str(), stderr);
    findings.members = wanted("members");
    if (findings.members && options.format != "csv")
        throw InputError("--parts members, a line for each member, is for --format csv.");
    return findings;
}

/// `parts_chosen`: by us, and not named.
std::string text_of(const Findings& findings, const std::string& format, bool parts_chosen) {
    if (format == "json") return findings_json(findings);
    if (format == "csv") return findings_csv(findings);
    std::string text = findings_table(findings, terminal_width());
    if (!findings.pairs && parts_chosen) text += "\n" + unasked_text(findings.summary) + "\n";
    return text;
}

}  // namespace

void add_summarize(CLI::App& program, int& exit_status) {
    auto options = std::make_shared<SummarizeOptions>();
    CLI::App* verb = program.add_subcommand("summarize", "Statistics of a campaign: cases, pairs of cases, extremes");
    verb->add_option("campaign", options->file, "The campaign file (CAMPAIGN.h5)")->required();
    verb->add_option("--format", options->format, "table, json or csv")
        ->check(CLI::IsMember({"table", "json", "csv"}))
        ->capture_default_str();
    verb->add_option("--reference", options->reference, "Reference case: the others are compared with it, in percent");
    verb->add_option("--parts", options->parts,
                     "Parts to show, comma-separated: cases, points and sensitivity (of a design), pairs, extremes, "
                     "exceedance, steady, members (CSV only)")
        ->delimiter(',')
        ->allow_extra_args(false)
        ->check(
            CLI::IsMember({"cases", "points", "sensitivity", "pairs", "extremes", "exceedance", "steady", "members"}));
    verb->add_option("--resolve", options->resolve_percent,
                     "Report the number of arrangements needed to resolve this difference of a pair, in percent of the "
                     "first case")
        ->check(CLI::PositiveNumber)
        ->capture_default_str();
    verb->add_option("--window", options->window,
                     "Analysis window: given (as configured), or auto (from the start of the steady state, found in "
                     "the histories)")
        ->check(CLI::IsMember({"given", "auto"}))
        ->capture_default_str();
    verb->callback([options, &exit_status] {
        std::fputs(text_of(find(*options), options->format, options->parts.empty()).c_str(), stdout);
        exit_status = 0;
    });
}

}  // namespace floes
