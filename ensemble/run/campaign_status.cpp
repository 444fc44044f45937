#include "run/campaign_status.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <set>

#include <fmt/format.h>

#include "campaign/read.hpp"
#include "campaign_file/filed_campaign.hpp"
#include "campaign_file/read.hpp"
#include "core/error.hpp"
#include "core/text.hpp"
#include "core/units.hpp"
#include "inference/precision_stop.hpp"
#include "member/design_of.hpp"
#include "run/inventory.hpp"
#include "run/parts.hpp"
#include "store/journal.hpp"

namespace floes {

namespace {

constexpr std::size_t most_under_way = 20;

/// ", 4.2 members/min, about 5 min left", as far as it is known. With a stop rule the run may end sooner.
std::string pace_text(const CampaignStatus& status) {
    std::string text = status.rate ? ", " + rate_text(*status.rate) : "";
    if (status.seconds_left)
        text += fmt::format(", {} {} left", status.stop ? "at most" : "about", duration_text(*status.seconds_left));
    return text;
}

/// Of several parts.
std::string work_sentence(const CampaignStatus& status, const PartsAtWork& parts) {
    if (parts.running == 0)
        return total_of(status).missing > 0
                   ? fmt::format("None of {} runs; start those again that are not complete, with --resume.",
                                 counted(parts.parts, "part"))
                   : fmt::format("No part runs; floes merge makes one file of {}.", counted(parts.parts, "part"));
    return fmt::format("Running: {} of {}, {} on {}{}.", parts.running, counted(parts.parts, "part"),
                       counted(parts.threads, "thread"), counted(parts.hosts, "host"), pace_text(status));
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

std::string time_words(const TimedMember& one) {
    return duration_text(one.seconds) + (one.end > 0 ? ", at " + come_text(one.time, one.end) : "");
}

std::string counts_sentence(const CampaignStatus& status) {
    const CaseStatus total = total_of(status);
    return fmt::format("{}: {} of {} done, {} failed, {} to do", status.title, total.done,
                       counted(members_of(total), "member"), total.failed, total.missing);
}

std::string work_sentence(const CampaignStatus& status) {
    const int missing = total_of(status).missing;
    if (status.parts) return work_sentence(status, *status.parts);
    if (status.sessions.empty()) return missing > 0 ? "Continue it with floes run --resume." : "";
    const Session& last = status.sessions.back();
    if (status.at_work)
        return fmt::format("Running: {}, {} from {} since {}{}.", counted(last.ranks, "rank"),
                           counted(last.threads, "thread"), last.host, last.started, pace_text(status));
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
    if (const DesignOf* of = rule.design_of()) {
        const std::string largest = rule.quantile == 0
                                        ? "expected largest"
                                        : fmt::format("{:g} % quantile of the largest", 100 * rule.quantile);
        text = fmt::format("the {} {} in {:g} h{}", largest, of->largest, rule.exposure / unit::hour,
                           of->value == nullptr ? fmt::format(", averaged over {:g} s,", rule.averaging) : "");
    }
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
    return {number, case_of(campaign, number).name, member_key(campaign, number).arrangement, attempt, seconds};
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

/// The members that a heartbeat names and that are not done since: it is some seconds older than the journal. One that
/// failed may be tried again from its first attempt (--retry-failed).
std::vector<TimedMember> under_way(const Campaign& campaign, const Heartbeat& heartbeat, const MemberNotes& notes,
                                   const Matched& records) {
    std::vector<TimedMember> members;
    for (const Heartbeat::UnderWay& one : heartbeat.under_way) {
        if (one.number < 0 || one.number >= std::ssize(records)) continue;
        const auto record = records[static_cast<std::size_t>(one.number)];
        if (record && notes[*record].done()) continue;
        members.push_back(timed(campaign, one.number, one.attempt, one.seconds));
        members.back().time = one.time;
        members.back().end = one.end;
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
        status.seconds_left = time_left(heartbeat->finished_cost, heartbeat->remaining_cost, heartbeat->elapsed);
    }
    if (status.at_work) status.under_way = under_way(campaign, *heartbeat, notes, records);
    status.heartbeat = std::move(heartbeat);
}

/// Several parts: who works on them, and the time left at their common pace.
void add_parts(CampaignStatus& status, const Parts& parts) {
    PartsAtWork at_work{.parts = static_cast<int>(parts.all().size())};
    double cost_rate = 0;
    double rate = 0;
    std::set<std::string> hosts;
    for (const Parts::Part& part : parts.all()) {
        if (!is_at_work(part.journal)) continue;
        ++at_work.running;
        if (!part.contents.sessions.empty()) {
            at_work.threads += part.contents.sessions.back().threads;
            hosts.insert(part.contents.sessions.back().host);
        }
        const std::optional<Heartbeat> heartbeat = read_heartbeat(heartbeat_path(part.journal));
        if (!heartbeat || is_stale(*heartbeat) || heartbeat->elapsed <= 0) continue;
        cost_rate += heartbeat->finished_cost / heartbeat->elapsed;
        rate += heartbeat->finished / heartbeat->elapsed;
        for (TimedMember& one : under_way(parts.campaign(), *heartbeat, parts.notes(), parts.matched()))
            status.under_way.push_back(std::move(one));
    }
    std::ranges::stable_sort(status.under_way, std::greater(), &TimedMember::seconds);
    if (status.under_way.size() > most_under_way) status.under_way.resize(most_under_way);
    at_work.hosts = static_cast<int>(hosts.size());
    status.at_work = at_work.running > 0;
    status.parts = at_work;
    if (rate > 0) status.rate = rate;
    double cost_left = 0;
    for (std::size_t k = 0; k < parts.matched().size(); ++k)
        if (!parts.matched()[k]) cost_left += expected_cost(parts.campaign(), static_cast<int>(k));
    if (cost_rate > 0) status.seconds_left = cost_left / cost_rate;
}

/// Of one journal.
void add_run(CampaignStatus& status, const Parts& parts) {
    const Parts::Part& only = parts.all().front();
    status.at_work = is_being_written(only.journal);
    add_heartbeat(status, parts.campaign(), parts.notes(), parts.matched(),
                  read_heartbeat(heartbeat_path(only.journal)));
    const int threads = status.sessions.empty() ? 0 : status.sessions.back().threads;
    if (!status.seconds_left)
        status.seconds_left = seconds_left(parts.campaign(), status, parts.notes(), parts.matched(), threads);
}

/// What journals say, without the results.
CampaignStatus status_of(const Parts& parts) {
    CampaignStatus status = status_of(parts.campaign(), parts.members(), parts.matched());
    status.stop = stop_status(parts.whole_campaign(), parts.rule());
    status.sessions = parts.sessions();
    status.slowest = slowest(parts.campaign(), parts.notes(), parts.matched());
    status.remarks = parts.remarks();
    if (parts.all().size() == 1) {
        add_run(status, parts);
        return status;
    }
    add_parts(status, parts);
    for (const std::string& sentence : {parts.missing_parts(), parts.missing_members()})
        if (!sentence.empty()) status.remarks.push_back(sentence);
    return status;
}

CampaignSnapshot snapshot_of(const Parts& parts) {
    return {status_of(parts), parts.campaign(), campaign_table(parts.campaign(), parts.members())};
}

CampaignSnapshot snapshot_of_file(const std::filesystem::path& path) {
    CampaignTable table = read_campaign_file(path);
    FiledCampaign filed = read_filed(path);
    Campaign& campaign = filed.campaign;
    CampaignStatus status = status_of(table);
    status.stop = stop_status(campaign, stop_rule_of(campaign, table));
    status.sessions = std::move(filed.sessions);
    status.slowest = slowest(campaign, filed.notes, match_records(campaign, filed.notes));
    return {std::move(status), std::move(campaign), std::move(table)};
}

}  // namespace

CampaignSnapshot read_snapshot(std::span<const std::filesystem::path> campaign_files) {
    const std::filesystem::path& first = campaign_files.front();
    if (campaign_files.size() > 1 || std::filesystem::exists(journal_path(first)))
        return snapshot_of(Parts(campaign_files));
    if (std::filesystem::exists(first)) return snapshot_of_file(first);
    throw InputError(fmt::format("there is neither {} nor its journal {}. Give the output file of floes run.",
                                 first.string(), journal_path(first).string()));
}

CampaignStatus read_status(std::span<const std::filesystem::path> campaign_files) {
    if (campaign_files.size() > 1 || std::filesystem::exists(journal_path(campaign_files.front())))
        return status_of(Parts(campaign_files));
    return read_snapshot(campaign_files).status;
}

}  // namespace floes
