#include "forecast/measured_run.hpp"

#include <limits>
#include <optional>

#include <fmt/format.h>

#include "campaign_file/read_campaign_file.hpp"
#include "campaign_file/read_details.hpp"
#include "core/error.hpp"
#include "journal/journal.hpp"

namespace floes {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

MeasuredRun of_journal(const std::filesystem::path& journal, const std::filesystem::path& campaign_file) {
    const JournalContents contents = read_journal(journal);
    MeasuredRun run{read_stored_campaign(contents, journal), {}, 0};
    for (const std::optional<std::size_t>& record : match_records(run.campaign, contents.members)) {
        const bool done = record && contents.members[*record].done();
        run.wall_time.push_back(done ? contents.members[*record].wall_time : nan);
    }
    // During a run the file is older than the journal.
    const bool complete = !contents.sessions.empty() && !contents.sessions.back().ended.empty();
    if (complete && std::filesystem::exists(campaign_file)) {
        run.file_per_record_byte = static_cast<double>(std::filesystem::file_size(campaign_file)) /
                                   static_cast<double>(std::filesystem::file_size(journal));
    }
    return run;
}

MeasuredRun of_campaign_file(const std::filesystem::path& path) {
    const CampaignFile file(path);
    const CampaignTable table = read_campaign_file(file);
    MeasuredRun run{file.campaign(), read_wall_times(file), 0};
    for (std::size_t k = 0; k < run.wall_time.size(); ++k)
        if (table.members.at(k).status != RowStatus::done) run.wall_time[k] = nan;
    return run;
}

}  // namespace

MeasuredRun read_measured_run(const std::filesystem::path& campaign_file) {
    const std::filesystem::path journal = journal_path(campaign_file);
    if (std::filesystem::exists(journal)) return of_journal(journal, campaign_file);
    if (std::filesystem::exists(campaign_file)) return of_campaign_file(campaign_file);
    throw InputError(fmt::format("there is neither {} nor its journal {}. Give the output file of floes run.",
                                 campaign_file.string(), journal.string()));
}

}  // namespace floes
