// floes summarize: what a campaign file says, as a table, JSON or CSV. Works on incomplete campaigns too.

#include <cstdio>
#include <memory>
#include <string>

#include "cli/commands.hpp"
#include "cli/terminal.hpp"
#include "report/formats.hpp"

namespace floes {

namespace {

struct SummarizeOptions {
    std::string file;
    std::string format = "table";
    std::string reference;
};

std::string summary_text(const SummarizeOptions& options) {
    const Summary summary = summarise(read_campaign_file(options.file));
    const Reference reference =
        options.reference.empty() ? Reference{} : Reference{case_index(summary, options.reference)};
    if (options.format == "json") return summary_json(summary, reference);
    if (options.format == "csv") return summary_csv(summary, reference);
    return summary_table(summary, terminal_width(), reference);
}

}  // namespace

void add_summarize(CLI::App& program, int& exit_status) {
    auto options = std::make_shared<SummarizeOptions>();
    CLI::App* verb = program.add_subcommand("summarize", "Mean and maximum load and failure ratio of every case");
    verb->add_option("campaign", options->file, "The campaign file (CAMPAIGN.h5)")->required();
    verb->add_option("--format", options->format, "table, json or csv")
        ->check(CLI::IsMember({"table", "json", "csv"}))
        ->capture_default_str();
    verb->add_option("--reference", options->reference, "Case that the others are compared with, in percent");
    verb->callback([options, &exit_status] {
        std::fputs(summary_text(*options).c_str(), stdout);
        exit_status = 0;
    });
}

}  // namespace floes
