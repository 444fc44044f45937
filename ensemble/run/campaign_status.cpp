#include "run/campaign_status.hpp"

#include <algorithm>
#include <cmath>
#include <functional>

#include <fmt/format.h>

#include "campaign/read.hpp"
#include "campaign_file/read.hpp"
#include "core/error.hpp"
#include "core/text.hpp"
#include "core/units.hpp"
#include "inference/precision_stop.hpp"
#include "run/inventory.hpp"
#include "run/progress.hpp"
#include "store/journal.hpp"

namespace floes {

namespace {

/// With a stop rule the run may end sooner.
std::string left_text(const CampaignStatus& status) {
    return fmt::format(", {} {} left", status.stop ? "at most" : "about", duration_text(*status.seconds_left));
}

}  // namespace

CaseStatus total_of(const CampaignStatus& status) {
    CaseStatus total{"all", 0, 0, 0};
    for (const CaseStatus& one : status.cases) {
        total.done += one.done;
        total.failed += one.failed;
        total.missing += one.missing;
    }
    return total;
}

int members_of(const CaseStatus& one) {
    return one.done + one.failed + one.missing;
}

std::string counts_sentence(const CampaignStatus& status) {
    const CaseStatus total = total_of(status);
    return fmt::format("{}: {} of {} done, {} failed, {} to do", status.title, total.done,
                       counted(members_of(total), "member"), total.failed, total.missing);
}

std::string work_sentence(const CampaignStatus& status) {
    const int missing = total_of(status).missing;
    if (status.sessions.empty()) return missing > 0 ? "Continue it with floes run --resume." : "";
    const Session& last = status.sessions.back();
    if (status.at_work)
        return fmt::format("Running: {}, {} from {} since {}{}{}.", counted(last.ranks, "rank"),
                           counted(last.threads, "thread"), last.host, last.started,
                           status.rate ? ", " + rate_text(*status.rate) : "",
                           status.seconds_left ? left_text(status) : "");
    if (missing == 0) return fmt::format("Ended {}.", last.ended.empty() ? "at an unknown time" : last.ended);
    if (last.ended.empty() && status.heartbeat)
        return fmt::format(
            "The run started on {} at {} (process {}) sent its last heartbeat {} ago: it was killed; continue it "
            "with floes run --resume.",
            last.host, last.started, status.heartbeat->process, duration_text(age_of(*status.heartbeat)));
    if (last.ended.empty())
        return fmt::format(
            "The run started on {} at {} was killed or is running on another machine; if it was killed, continue "
            "it with floes run --resume.",
            last.host, last.started);
    return fmt::format("Ended {} ({}); continue it with floes run --resume.", last.ended, last.outcome);
}

std::string what_of(const StopRule& rule) {
    std::string text = rule.of;
    if (rule.of_design_load())
        text = fmt::format("the {} load in {:g} h, averaged over {:g} s,",
                           rule.quantile == 0 ? "expected largest"
                                              : fmt::format("{:g} % quantile of the largest", 100 * rule.quantile),
                           rule.exposure / unit::hour, rule.averaging);
    if (rule.case_name != "none") text += rule.case_name == "all" ? " of every case" : " of case " + rule.case_name;
    if (rule.contrast != "none") {
        text += rule.case_name != "none" ? " and" : "";
        text += rule.contrast == "all" ? " of every difference of two cases" : " of " + rule.contrast;
    }
    return text;
}

std::string stop_sentence(const StopStatus& stop) {
    const std::string most =
        stop.most_arrangements > stop.arrangements ? fmt::format(" of at most {}", stop.most_arrangements) : "";
    const std::string why = stop.obstacle.empty() ? "" : fmt::format(" ({})", stop.obstacle);
    const std::string reached =
        std::isnan(stop.achieved)
            ? fmt::format("not known yet{}, target {:g} %", why, 100 * stop.rule.half_width)
            : fmt::format("{:.1f} %, target {:g} %", 100 * stop.achieved, 100 * stop.rule.half_width);
    if (stop.met)
        return fmt::format("Precise enough after {}{}, no more are needed. Half-width for {}: {}.",
                           counted(stop.arrangements, "arrangement"), most, what_of(stop.rule), reached);
    const std::string early =
        stop.rule.minimum == 0 && stop.arrangements < stop.minimum
            ? fmt::format(" Not before {}: of fewer, a kind of member that is {:g} % of all may be missing.",
                          counted(stop.minimum, "arrangement"), 100 * PrecisionStop::share_seen(stop.rule))
            : std::string{};
    return fmt::format("Half-width for {} after {}{}: {}.{}", what_of(stop.rule),
                       counted(stop.arrangements, "arrangement"), most, reached, early);
}

namespace {

using Matched = std::vector<std::optional<std::size_t>>;  // as match_records() gives it

/// Counts the next member in member order; reason() is asked for of a failed one.
template <class Function>
void count(CampaignStatus& status, int number, RowStatus state, const Function& reason) {
    const int cases = static_cast<int>(status.cases.size());
    CaseStatus& one = status.cases.at(static_cast<std::size_t>(number % cases));
    switch (state) {
        case RowStatus::done:
            ++one.done;
            break;
        case RowStatus::missing:
            ++one.missing;
            break;
        case RowStatus::failed:
            ++one.failed;
            status.failures.push_back({number, one.name, number / cases, reason()});
            break;
    }
}

CampaignStatus status_of(const CampaignTable& table) {
    CampaignStatus status;
    status.title = table.title;
    for (const CaseRow& row : table.cases) status.cases.push_back({row.name, 0, 0, 0});
    for (int number = 0; const MemberRow& row : table.members)
        count(status, number++, row.status, [&] { return row.reason; });
    return status;
}

CampaignStatus status_of(const Campaign& campaign, const StoredMembers& members, const Matched& records) {
    CampaignStatus status;
    status.title = campaign.name;
    for (const Case& one : campaign.cases) status.cases.push_back({one.name, 0, 0, 0});
    for (int number = 0; const auto& record : records) {
        const RowStatus state = !record                           ? RowStatus::missing
                                : members.notes()[*record].done() ? RowStatus::done
                                                                  : RowStatus::failed;
        count(status, number++, state, [&] { return members.read(*record).result.reason; });
    }
    return status;
}

std::optional<StopStatus> stop_status(const Campaign& campaign, const std::optional<PrecisionStop>& rule) {
    if (!rule) return {};
    return StopStatus{.rule = campaign.stop,
                      .met = rule->met(),
                      .arrangements = rule->arrangements(),
                      .most_arrangements = campaign.arrangements,
                      .minimum = rule->minimum(),
                      .achieved = rule->achieved(),
                      .obstacle = rule->obstacle()};
}

/// The rule with every member that has a record.
std::optional<PrecisionStop> told_rule(const Campaign& campaign, const StoredMembers& members, const Matched& records) {
    std::optional<PrecisionStop> rule = stop_rule_of(campaign);
    for (std::size_t k = 0; rule && k < records.size(); ++k)
        if (records[k]) tell(rule, member_key(campaign, static_cast<int>(k)), members.read(*records[k]));
    if (rule) rule->look();
    return rule;
}

// Assumes that members of a case take equally long and that the threads of the session share the remaining work.
std::optional<double> seconds_left(const Campaign& campaign, const CampaignStatus& status, const MemberNotes& notes,
                                   const Matched& records, int threads) {
    double wall_time_per_cost = 0;
    int done = 0;
    double cost_left = 0;
    for (std::size_t k = 0; k < records.size(); ++k) {
        const double cost = expected_cost(campaign, static_cast<int>(k));
        if (!records[k]) {
            cost_left += cost;
        } else if (notes[*records[k]].done()) {
            wall_time_per_cost += notes[*records[k]].wall_time / cost;
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

std::vector<TimedMember> slowest(const Campaign& campaign, const MemberNotes& notes, const Matched& records) {
    std::vector<std::size_t> done;
    for (std::size_t k = 0; k < records.size(); ++k)
        if (records[k] && notes[*records[k]].done()) done.push_back(k);
    std::ranges::stable_sort(done, std::greater(), [&](std::size_t k) { return notes[*records[k]].wall_time; });
    if (done.size() > 5) done.resize(5);
    std::vector<TimedMember> members;
    for (const std::size_t k : done) {
        const MemberNote& note = notes[*records[k]];
        members.push_back(timed(campaign, static_cast<int>(k), note.attempt, note.wall_time));
    }
    return members;
}

/// The members that a heartbeat names and that have not ended since: it is some seconds older than the journal.
std::vector<TimedMember> under_way(const Campaign& campaign, const Heartbeat& heartbeat, const MemberNotes& notes,
                                   const Matched& records) {
    std::vector<TimedMember> members;
    for (const Heartbeat::UnderWay& one : heartbeat.under_way) {
        if (one.number < 0 || one.number >= std::ssize(records)) continue;
        const auto record = records[static_cast<std::size_t>(one.number)];
        if (record && notes[*record].attempt >= one.attempt) continue;
        members.push_back(timed(campaign, one.number, one.attempt, one.seconds));
    }
    return members;
}

/// The lock on the journal may be invisible from another machine; a fresh heartbeat is not.
void add_heartbeat(CampaignStatus& status, const Campaign& campaign, const MemberNotes& notes, const Matched& records,
                   std::optional<Heartbeat> heartbeat) {
    if (!heartbeat || (status.at_work && is_stale(*heartbeat))) return;  // of an earlier run
    if (!is_stale(*heartbeat)) status.at_work = true;
    if (status.at_work && heartbeat->elapsed > 0 && heartbeat->finished > 0) {
        status.rate = heartbeat->finished / heartbeat->elapsed;
        status.seconds_left = heartbeat->remaining_cost / (heartbeat->finished_cost / heartbeat->elapsed);
    }
    if (status.at_work) status.under_way = under_way(campaign, *heartbeat, notes, records);
    status.heartbeat = std::move(heartbeat);
}

/// What a journal says, without the results.
struct JournalStatus {
    JournalContents contents;
    CampaignStatus status;
    Campaign campaign;  ///< as its stop rule wants it
};

JournalStatus status_of_journal(const std::filesystem::path& path) {
    JournalContents contents = read_journal(path);
    Campaign campaign = read_stored_campaign(contents, path);
    const StoredMembers members = stored_members(contents, path);
    Matched records = match_records(campaign, contents.members);
    const std::optional<StopStatus> stop = stop_status(campaign, told_rule(campaign, members, records));
    // Parts of a merged campaign were run in full, regardless of the stop rule.
    if (stop && stop->met && std::ranges::any_of(records, [](const auto& record) { return !record; })) {
        campaign.arrangements = stop->arrangements;
        records.resize(static_cast<std::size_t>(member_count(campaign)));
    }
    CampaignStatus status = status_of(campaign, members, records);
    status.stop = stop;
    status.sessions = contents.sessions;
    status.slowest = slowest(campaign, contents.members, records);
    status.at_work = is_being_written(path);
    const int threads = contents.sessions.empty() ? 0 : contents.sessions.back().threads;
    add_heartbeat(status, campaign, contents.members, records, read_heartbeat(heartbeat_path(path)));
    if (!status.seconds_left) status.seconds_left = seconds_left(campaign, status, contents.members, records, threads);
    return {std::move(contents), std::move(status), std::move(campaign)};
}

CampaignSnapshot snapshot_of_journal(const std::filesystem::path& path) {
    JournalStatus found = status_of_journal(path);
    CampaignTable table = campaign_table(found.campaign, stored_members(found.contents, path));
    return {std::move(found.status), std::move(found.campaign), std::move(table)};
}

CampaignSnapshot snapshot_of_file(const std::filesystem::path& path) {
    const CampaignFile file(path);
    CampaignTable table = read_campaign_file(file);
    Campaign campaign = file.campaign();
    CampaignStatus status = status_of(table);
    status.stop = stop_status(campaign, stop_rule_of(campaign, table));
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
    const std::filesystem::path journal = journal_path(campaign_file);
    return std::filesystem::exists(journal) ? status_of_journal(journal).status : read_snapshot(campaign_file).status;
}

}  // namespace floes
