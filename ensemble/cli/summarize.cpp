// floes summarize: the findings of a campaign file as a table, JSON or CSV. Works on incomplete campaigns too.

#include <algorithm>
#include <cstdio>
#include <memory>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "cli/commands.hpp"
#include "cli/given_file.hpp"
#include "cli/terminal.hpp"
#include "core/error.hpp"
#include "core/units.hpp"
#include "findings/catalogue.hpp"

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

/// What is shown unless parts are named: the parts suited to the campaign as table or JSON, and the cases as CSV.
bool is_wanted(const Finding& finding, const SummarizeOptions& options, const Campaign& campaign) {
    if (!options.parts.empty()) return std::ranges::find(options.parts, finding.name) != options.parts.end();
    return options.format == "csv" ? finding.name == findings().front().name : finding.unasked(campaign);
}

std::vector<Section> find(const SummarizeOptions& options, Evidence& evidence) {
    std::vector<Section> sections;
    for (const Finding& finding : findings()) {
        const bool wanted = is_wanted(finding, options, evidence.campaign);
        if (wanted && finding.for_csv_alone && options.format != "csv")
            throw InputError(
                fmt::format("--parts {0} has a line for each member and needs --format csv.", finding.name));
        const bool always = options.format == "json" && finding.name == findings().front().name;
        if (!wanted && !always) continue;
        for (Section& section : finding.sections(evidence)) {
            if (wanted && options.format != "table" && !section.missing.empty())
                std::fputs(fmt::format("floes: {}", section.missing).c_str(), stderr);
            sections.push_back(std::move(section));
        }
    }
    return sections;
}

std::string answer(const SummarizeOptions& options) {
    expect_campaign_file(options.file);
    Evidence evidence = read_evidence(CampaignFile(options.file), options.window == "auto", options.reference);
    evidence.resolve = options.resolve_percent * unit::percent;
    return written(find(options, evidence), options.format);
}

std::vector<std::string> part_names() {
    std::vector<std::string> names;
    for (const Finding& finding : findings())
        if (!finding.name.empty()) names.emplace_back(finding.name);
    return names;
}

}  // namespace

void add_summarize(CommandLine& line) {
    auto options = std::make_shared<SummarizeOptions>();
    Verb verb = line.verb("summarize", "Statistics of a campaign: cases, pairs of cases, extremes");
    verb.option("campaign", options->file, "The campaign file (CAMPAIGN.h5)").required();
    add_format(verb, options->format);
    verb.option("--reference", options->reference, "Reference case: the others are compared with it, in percent");
    verb.option("--parts", options->parts,
                "Parts to show, comma-separated: cases, points and sensitivity (of a design), pairs, extremes, "
                "exceedance, steady, control, design, members (CSV only)")
        .comma_separated()
        .one_of(part_names());
    verb.option("--resolve", options->resolve_percent,
                "Report the number of arrangements needed to resolve this difference of a pair, in percent of the "
                "first case")
        .positive()
        .shows_default();
    add_window(verb, options->window);
    verb.runs([options] {
        std::fputs(answer(*options).c_str(), stdout);
        return 0;
    });
}

}  // namespace floes
