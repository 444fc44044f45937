// floes status: what of a campaign is done, failed and still to go. Works while a run is going on, and changes nothing.

#include <cstdio>
#include <memory>
#include <string>

#include "cli/commands.hpp"
#include "cli/status_text.hpp"

namespace floes {

namespace {

struct StatusOptions {
    std::string file;
    std::string format = "table";
};

}  // namespace

void add_status(CLI::App& program, int& exit_status) {
    auto options = std::make_shared<StatusOptions>();
    CLI::App* verb = program.add_subcommand("status", "What is done, failed and still to go, also during a run");
    verb->add_option("campaign", options->file, "The campaign file (CAMPAIGN.h5); its journal is found beside it")
        ->required();
    verb->add_option("--format", options->format, "table or json")
        ->check(CLI::IsMember({"table", "json"}))
        ->capture_default_str();
    verb->callback([options, &exit_status] {
        const CampaignStatus status = read_status(options->file);
        std::fputs((options->format == "json" ? status_json(status) : status_table(status)).c_str(), stdout);
        exit_status = 0;
    });
}

}  // namespace floes
