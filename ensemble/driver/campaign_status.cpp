#include "driver/campaign_status.hpp"

#include <algorithm>
#include <functional>

#include <fmt/format.h>

#include "campaign/read.hpp"
#include "campaign_file/read_campaign_file.hpp"
#include "campaign_file/read_details.hpp"
#include "core/error.hpp"
#include "driver/precision.hpp"
#include "journal/journal.hpp"

namespace floes {
namespace {

CampaignStatus status_of(const CampaignTable& table) {
    CampaignStatus status;
    status.title = table.title;
    for (const CaseRow& row : table.cases) status.cases.push_back({row.name, 0, 0, 0});
    for (std::size_t k = 0; k < table.members.size(); ++k) {
        const MemberRow& row = table.members[k];
        CaseStatus& one = status.cases.at(static_cast<std::size_t>(row.case_index));
        switch (row.status) {
            case RowStatus::done:
                ++one.done;
                break;
            case RowStatus::missing:
                ++one.missing;
                break;
            case RowStatus::failed:
                ++one.failed;
                const int number = static_cast<int>(k);
                status.failures.push_back(
                    {number, one.name, number / static_cast<int>(table.cases.size()), row.reason});
                break;
        }
    }
    return status;
}

std::optional<StopStatus> stop_status(const Campaign& campaign, const CampaignTable& table) {
    const std::optional<PrecisionStop> rule = stop_rule_of(campaign, table);
    if (!rule) return {};
    return StopStatus{campaign.stop, rule->met(), rule->arrangements(), campaign.arrangements, rule->achieved()};
}

/// The arrangements that count. Parts of a merged campaign were run in full, regardless of the stop rule.
Campaign wanted(Campaign campaign, const CampaignTable& table, const std::optional<StopStatus>& stop) {
    const auto missing = [](const MemberRow& row) { return row.status == RowStatus::missing; };
    if (stop && stop->met && std::ranges::any_of(table.members, missing)) campaign.arrangements = stop->arrangements;
    return campaign;
}

// Assumes that members of a case take equally long and that the threads of the session share the remaining work.
std::optional<double> seconds_left(const Campaign& campaign, const CampaignStatus& status,
                                   const std::vector<const MemberRecord*>& records, int threads) {
    double wall_time_per_cost = 0;
    int done = 0;
    double cost_left = 0;
    for (std::size_t k = 0; k < records.size(); ++k) {
        const double cost = expected_cost(campaign, static_cast<int>(k));
        if (records[k] == nullptr) {
            cost_left += cost;
        } else if (records[k]->result.status == MemberStatus::done) {
            wall_time_per_cost += records[k]->result.wall_time / cost;
            ++done;
        }
    }
    if (!status.at_work || done == 0 || threads < 1) return {};
    return cost_left * wall_time_per_cost / done / threads;
}

TimedMember timed(const Campaign& campaign, int number, int attempt, double seconds) {
    const MemberKey key = member_key(campaign, number);
    return {number, campaign.cases[static_cast<std::size_t>(key.case_index)].name, key.arrangement, attempt, seconds};
}

std::vector<TimedMember> slowest(const Campaign& campaign, const std::vector<const MemberRecord*>& records) {
    std::vector<TimedMember> members;
    for (std::size_t k = 0; k < records.size(); ++k)
        if (records[k] != nullptr && records[k]->result.status == MemberStatus::done)
            members.push_back(timed(campaign, static_cast<int>(k), records[k]->attempt, records[k]->result.wall_time));
    std::ranges::stable_sort(members, std::greater(), &TimedMember::seconds);
    if (members.size() > 5) members.resize(5);
    return members;
}

/// The lock on the journal may be invisible from another machine; a fresh heartbeat is not.
void add_heartbeat(CampaignStatus& status, const Campaign& campaign, std::optional<Heartbeat> heartbeat) {
    if (!heartbeat || (status.at_work && is_stale(*heartbeat))) return;  // of an earlier run
    if (!is_stale(*heartbeat)) status.at_work = true;
    if (status.at_work && heartbeat->elapsed > 0 && heartbeat->finished > 0) {
        status.rate = heartbeat->finished / heartbeat->elapsed;
        status.seconds_left = heartbeat->remaining_cost / (heartbeat->finished_cost / heartbeat->elapsed);
    }
    for (const Heartbeat::UnderWay& one : heartbeat->under_way)
        if (status.at_work && one.number >= 0 && one.number < member_count(campaign))
            status.under_way.push_back(timed(campaign, one.number, one.attempt, one.seconds));
    status.heartbeat = std::move(heartbeat);
}

CampaignSnapshot snapshot_of_journal(const std::filesystem::path& path) {
    const JournalContents contents = read_journal(path, Histories::leave);
    const Campaign whole = read_stored_campaign(contents, path);
    CampaignTable table = campaign_table(whole, contents.members);
    const std::optional<StopStatus> stop = stop_status(whole, table);
    Campaign campaign = wanted(whole, table, stop);
    if (campaign.arrangements < whole.arrangements) table = campaign_table(campaign, contents.members);
    CampaignStatus status = status_of(table);
    status.stop = stop;
    status.sessions = contents.sessions;
    const std::vector<const MemberRecord*> records = match_records(campaign, contents.members);
    status.slowest = slowest(campaign, records);
    status.at_work = is_being_written(path);
    const int threads = contents.sessions.empty() ? 0 : contents.sessions.back().threads;
    add_heartbeat(status, campaign, read_heartbeat(heartbeat_path(path)));
    if (!status.seconds_left) status.seconds_left = seconds_left(campaign, status, records, threads);
    return {std::move(status), std::move(campaign), std::move(table)};
}

CampaignSnapshot snapshot_of_file(const std::filesystem::path& path) {
    const CampaignFile file(path);
    CampaignTable table = read_campaign_file(file);
    Campaign campaign = campaign_of(read_origin(file), path);
    CampaignStatus status = status_of(table);
    status.stop = stop_status(campaign, table);
    return {std::move(status), std::move(campaign), std::move(table)};
}

}  // namespace

CampaignSnapshot read_snapshot(const std::filesystem::path& campaign_file) {
    const std::filesystem::path journal = journal_path(campaign_file);
    if (std::filesystem::exists(journal)) return snapshot_of_journal(journal);
    if (std::filesystem::exists(campaign_file)) return snapshot_of_file(campaign_file);
    throw InputError(fmt::format("there is neither {} nor its journal {}. Give the output file of floes run.",
                                 campaign_file.string(), journal.string()));
}

CampaignStatus read_status(const std::filesystem::path& campaign_file) {
    return read_snapshot(campaign_file).status;
}

}  // namespace floes
