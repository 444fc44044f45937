// floes merge: one campaign file from those of separate runs with --part.

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "campaign_file/read.hpp"
#include "cli/commands.hpp"
#include "cli/files.hpp"
#include "cli/terminal.hpp"
#include "cli/verify.hpp"
#include "core/text.hpp"
#include "findings/cases.hpp"
#include "run/merge.hpp"

namespace floes {

namespace {

struct MergeOptions {
    std::vector<std::string> parts;
    std::string output;
    bool overwrite = false;
};

/// A merge leaves out damaged records; their members count as missing.
void tell_damage(const Parts& parts) {
    for (const Parts::Part& part : parts.all()) {
        const FileVerdict verdict = judge_journal(part.journal, part.contents);
        if (verdict.state != FileState::damaged) continue;
        for (const std::string& fault : verdict.faults) fmt::print(stderr, "floes: {}: {}\n", verdict.file, fault);
    }
}

int merge(const MergeOptions& options) {
    expect_no_other_file(options.output);
    const std::vector<std::filesystem::path> files(options.parts.begin(), options.parts.end());
    const Parts parts = merge_campaigns(files, options.output, options.overwrite);
    tell_damage(parts);
    tell_parts(parts);
    const CampaignTable table = read_campaign_file(CampaignFile(options.output));
    const auto done = std::ranges::count(table.members, RowStatus::done, &MemberRow::status);
    const auto missing = std::ranges::count(table.members, RowStatus::missing, &MemberRow::status);
    const auto failed = std::ssize(table.members) - done - missing;
    fmt::print(stderr, "floes: {} of {} done, {} failed, {} missing from all parts, into {}\n", done,
               counted(std::ssize(table.members), "member"), failed, missing, options.output);
    if (missing > 0)
        fmt::print(stderr,
                   "floes: the same command adds what the parts compute from now on; floes run CONFIG.toml -o {} "
                   "--resume computes the missing members\n",
                   options.output);
    std::fputs(written({summary_section(summarise(table))}, "table").c_str(), stdout);
    return failed + missing > 0 ? 1 : 0;
}

}  // namespace

void add_merge(CommandLine& line) {
    auto options = std::make_shared<MergeOptions>();
    Verb verb = line.verb("merge", "Merge the parts computed by floes run --part into one campaign");
    verb.option("parts", options->parts, "Campaign files of the parts; their journals are read from the same folders")
        .required();
    verb.option("-o,--output", options->output, "The merged campaign file; one that exists is added to").required();
    verb.flag("--overwrite", options->overwrite, "Replace what the merged campaign file has, instead of adding to it");
    verb.runs([options] { return merge(*options); });
}

}  // namespace floes
