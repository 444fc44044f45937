#include "driver/status_words.hpp"

#include <fmt/format.h>

#include <cmath>

#include "core/units.hpp"
#include "core/wording.hpp"
#include "driver/progress.hpp"
#include "inference/precision_stop.hpp"

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

}  // namespace floes
