// floes vary: the configuration of a study that varies what the model leaves open, one input at a time.

#include <cstdio>
#include <memory>
#include <string>
#include <vector>

#include "campaign/variations.hpp"
#include "cli/commands.hpp"
#include "cli/config_file.hpp"

namespace floes {
namespace {

struct VaryOptions {
    std::string file;
    std::string case_name;
    std::vector<std::string> overrides;
};

int vary(const VaryOptions& options) {
    const Campaign campaign = load_campaign(options.file, options.overrides);
    std::fputs(variations_text(campaign, chosen_case(campaign, options.case_name)).c_str(), stdout);
    return 0;
}

}  // namespace

void add_vary(CommandLine& line) {
    auto options = std::make_shared<VaryOptions>();
    Verb verb = line.verb("vary", "Write a study of what the model leaves open: friction, strength, water, channel");
    verb.option("config", options->file, "The configuration (CONFIG.toml)").required();
    verb.option("--case", options->case_name, "The case to vary, if there are several");
    verb.option("--set", options->overrides, "key=value: override a key of the file; may be repeated");
    verb.footer(
        "The study goes to standard output. It has the case as it is and some fifteen others, each with one input\n"
        "changed as far as it is usually unknown; edit it as you know better. Eight arrangements and more say "
        "something.\n\n"
        "  floes vary my.toml --set campaign.arrangements=12 > varied.toml\n"
        "  floes run varied.toml\n"
        "  floes summarize varied.h5 --parts model");
    verb.runs([options] { return vary(*options); });
}

}  // namespace floes
