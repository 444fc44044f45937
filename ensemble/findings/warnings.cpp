#include "findings/warnings.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "core/text.hpp"
#include "findings/steady.hpp"
#include "findings/summary.hpp"
#include "inference/interval.hpp"

namespace floes {
namespace {

constexpr double unsteady_level = 0.05;  // p of a trend below which a member is not steady

struct Counts {
    int members = 0, done = 0, failed = 0, missing = 0;
    int untouched = 0;                   ///< done, without any load in the window
    int rising = 0, falling = 0;         ///< done and not steady
    std::vector<std::string> bare = {};  ///< cases of which no member met ice

    Counts(const CampaignTable& table, const Summary& summary) {
        std::vector<int> of_case(summary.cases.size());
        for (const MemberRow& row : table.members) {
            if (!row.done()) continue;
            const bool none = row.load.maximum == 0 && row.load.mean == 0;
            untouched += none ? 1 : 0;
            of_case[static_cast<std::size_t>(row.case_index)] += none ? 1 : 0;
            if (!row.load.steady) ++(row.load.trend < 0 ? falling : rising);
        }
        for (std::size_t k = 0; k < summary.cases.size(); ++k) {
            const CaseSummary& one = summary.cases[k];
            members += one.members;
            done += one.done;
            failed += one.failed_members;
            missing += one.missing_members;
            if (one.done > 0 && of_case[k] == one.done) bare.push_back(summary.label_of(k));
        }
    }
};

std::string untouched_text(const Counts& found, std::size_t cases) {
    std::string text = fmt::format("Ice never touched the structure in {} of {}: their loads are 0", found.untouched,
                                   counted(found.done, "member"));
    if (!found.bare.empty() && found.bare.size() < cases) text += " (all of " + name_list(found.bare) + ")";
    return text + ". The field may be too open, or the measured window too early.";
}

/// One in twenty steady members looks unsteady by chance, so a few are no news.
bool more_than_chance(int found, int done) {
    if (found == 0) return false;
    double exactly = std::pow(1 - unsteady_level, done);  // the probability of that many by chance
    double fewer = 0;
    for (int count = 0; count < found; ++count) {
        fewer += exactly;
        exactly *= (done - count) * unsteady_level / ((count + 1) * (1 - unsteady_level));
    }
    return 1 - fewer < unsteady_level;
}

std::string unsteady_text(const Counts& found) {
    const int all = found.rising + found.falling;
    const char* how = found.falling == 0 ? "still rises" : found.rising == 0 ? "still falls" : "still has a trend";
    return fmt::format(
        "{} of {} not steady: the load {} in the measured window. A later analysis.steady_start_s, or --window auto.",
        all, counted(found.done, "member"), how);
}

/// Cases whose load has a trend over all their members: a sentence for all.
std::string joint_text(const CampaignTable& table, const Summary& summary) {
    std::vector<std::string> lines;
    for (const JointTrend& trend : joint_trends(table))
        if (trend.seen) lines.push_back(fmt::format("{}: {}", summary.label_of(trend.case_index), trend_text(trend)));
    if (lines.empty()) return "";
    constexpr std::size_t most = 3;
    const std::size_t all = lines.size();
    lines.resize(std::min(all, most));
    return fmt::format("Not steady: {}{}. A later analysis.steady_start_s, or --window auto.", fmt::join(lines, "; "),
                       all > most ? fmt::format("; and {} more", counted(static_cast<int>(all - most), "case")) : "");
}

/// Cases in which most steps end before contacts are solved: in ice that jams loads are then too low
/// (docs/fracture.md).
std::string unsolved_text(const CampaignTable& table, const Summary& summary) {
    constexpr double nearly_all = 0.9;
    std::vector<std::string> lines;
    int most = 0;
    for (std::size_t k = 0; k < summary.cases.size(); ++k) {
        const std::vector<const MemberRow*> members = done_members(table, k);
        const int allowed = table.cases[k].most_sweeps;
        double sum = 0;
        for (const MemberRow* row : members) sum += row->mean_sweeps;
        const double mean = sum / static_cast<double>(members.size());
        if (members.empty() || allowed == 0 || !(mean > nearly_all * allowed)) continue;
        lines.push_back(fmt::format("{}, {:.3g} of at most {}", summary.label_of(k), mean, allowed));
        most = std::max(most, allowed);
    }
    if (lines.empty()) return "";
    return fmt::format(
        "Contacts are not solved in most steps (sweeps a step: {}): where ice jams, loads are too low, on a wall by "
        "half "
        "and more. Try general.iterations = {}.",
        fmt::join(lines, "; "), 10 * most);
}

/// Members whose mean load is far above the others'.
std::string standing_out_text(const CampaignTable& table, const Summary& summary) {
    std::vector<std::string> lines;
    for (std::size_t k = 0; k < summary.cases.size(); ++k) {
        std::vector<double> loads;
        const std::vector<const MemberRow*> members = done_members(table, k);
        for (const MemberRow* row : members) loads.push_back(row->load.mean);
        std::vector<std::string> numbers;
        for (const std::size_t row : apart(loads, Sides::above).above)
            numbers.push_back(fmt::format("{}", members[row] - table.members.data()));
        if (!numbers.empty())
            lines.push_back(fmt::format("{} of {} of {} ({})", numbers.size(), members.size(), summary.label_of(k),
                                        fmt::join(numbers, ", ")));
    }
    if (lines.empty()) return "";
    return fmt::format(
        "Members whose mean load is far above the others': {}. Look at them (floes replay). Intervals count them as "
        "a kind of their own, whose share is uncertain; five or more of it are a beginning.",
        fmt::join(lines, "; "));
}

/// Cases with too few arrangements for any interval.
std::string few_text(const Summary& summary) {
    std::vector<std::string> names;
    int least = fewest_for_interval;
    int most = 0;
    int needed = 0;
    for (std::size_t k = 0; k < summary.cases.size(); ++k) {
        const CaseSummary& one = summary.cases[k];
        if (one.done == 0 || one.done >= fewest_for_interval) continue;
        names.push_back(summary.label_of(k));
        least = std::min(least, one.done);
        most = std::max(most, one.done);
        needed = std::max(needed, arrangements_for(one.of(quantity("mean_load")), one.done, 0.2));
    }
    if (names.empty()) return "";
    const std::string where = names.size() == summary.cases.size() ? "" : " (" + name_list(names) + ")";
    const std::string count = least == most ? fmt::format("{}", least) : fmt::format("{} to {}", least, most);
    const std::string remedy = needed > 0
                                   ? fmt::format("about {} arrangements would give the mean load to 20 %", needed)
                                   : std::string{"8 arrangements or more are a beginning"};
    return fmt::format("n = {}{}: no interval worth printing; {}.", count, where, remedy);
}

std::string failed_text(const Counts& found, const Summary& summary) {
    std::string text = fmt::format("{} of {} failed and {} in no figure. Member {}: {}", found.failed,
                                   counted(found.members, "member"), found.failed == 1 ? "counts" : "count",
                                   summary.failed.front().member, summary.failed.front().reason);
    if (!text.ends_with('.')) text += '.';
    if (found.failed > 1) text += " floes status has the others.";
    return text;
}

}  // namespace

std::vector<std::string> warnings_of(const CampaignTable& table, const Summary& summary) {
    const Counts found(table, summary);
    std::vector<std::string> sentences;
    if (found.failed > 0) sentences.push_back(failed_text(found, summary));
    if (found.missing > 0)
        sentences.push_back(
            fmt::format("{} of {} {} no result yet{}", found.missing, counted(found.members, "member"),
                        found.missing == 1 ? "has" : "have",
                        found.done > 0 ? ". Short runs finish first, so the figures lean towards them." : "."));
    if (found.untouched > 0) sentences.push_back(untouched_text(found, summary.cases.size()));
    if (std::string joint = joint_text(table, summary); !joint.empty())
        sentences.push_back(std::move(joint));
    else if (more_than_chance(found.rising + found.falling, found.done))
        sentences.push_back(unsteady_text(found));
    if (std::string unsolved = unsolved_text(table, summary); !unsolved.empty())
        sentences.push_back(std::move(unsolved));
    if (std::string out = standing_out_text(table, summary); !out.empty()) sentences.push_back(std::move(out));
    if (std::string few = few_text(summary); !few.empty()) sentences.push_back(std::move(few));
    return sentences;
}

std::string warning_lines(const std::vector<std::string>& warnings) {
    std::string lines;
    for (const std::string& one : warnings) lines += "! " + one + "\n";
    return lines;
}

}  // namespace floes
