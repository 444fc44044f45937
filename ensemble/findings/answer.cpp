#include "findings/answer.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <iterator>
#include <optional>
#include <tuple>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "core/text.hpp"
#include "core/units.hpp"
#include "findings/cases.hpp"
#include "findings/conditions.hpp"
#include "findings/moored.hpp"
#include "findings/pairs.hpp"
#include "findings/points.hpp"
#include "findings/steady.hpp"
#include "inference/interval.hpp"
#include "statistics/load_statistics.hpp"

namespace floes {

namespace {

constexpr double unsteady_level = 0.05;  // p of a trend below which a member is not steady

struct Counts : MemberCounts {
    int untouched = 0;                   ///< done, without any load in the window
    int rising = 0, falling = 0;         ///< done and not steady
    std::vector<std::size_t> bare = {};  ///< cases of which no member met ice

    Counts(const Sample& sample, const Summary& summary) : MemberCounts(summary.counts()) {
        for (std::size_t k = 0; k < summary.cases.size(); ++k) {
            int none = 0;
            for (const std::size_t member : sample.done(k)) {
                const auto value = [&](const char* key) { return sample.value(member, *find_quantity(key)); };
                none += value("maximum_load") == 0 && value("mean_load") == 0 ? 1 : 0;
                if (!sample.steady(member)) ++(value("trend") < 0 ? falling : rising);
            }
            untouched += none;
            if (none > 0 && none == summary.cases[k].done) bare.push_back(k);
        }
    }
};

std::string untouched_text(const Counts& found, const Summary& summary) {
    std::string text = fmt::format("Ice never touched the structure in {} of {}: their loads are 0", found.untouched,
                                   counted(found.done, "member"));
    if (!found.bare.empty() && found.bare.size() < summary.cases.size())
        text += " (all of " + label_list(summary, found.bare) + ")";
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

/// ", or --window auto" where that can be.
std::string or_automatically(const Summary& summary) {
    const auto can = [](const CaseSummary& one) { return one.about.can_be_measured_later(); };
    return std::ranges::any_of(summary.cases, can) ? ", or --window auto" : "";
}

std::string unsteady_text(const Counts& found, const Summary& summary) {
    const int all = found.rising + found.falling;
    const char* how = found.falling == 0 ? "still rises" : found.rising == 0 ? "still falls" : "still has a trend";
    return fmt::format("{} of {} not steady: the load {} in the measured window. A later analysis.steady_start_s{}.",
                       all, counted(found.done, "member"), how, or_automatically(summary));
}

constexpr std::size_t most_named = 3;  // cases in a sentence

/// A line on each case whose trend `which` is true of: "…; and 2 cases more". Empty of none.
std::string trend_lines(const Summary& summary, const auto& which, const auto& line) {
    std::vector<std::string> lines;
    for (std::size_t k = 0; k < summary.cases.size(); ++k)
        if (const JointTrend& trend = summary.cases[k].trend; std::invoke(which, trend))
            lines.push_back(fmt::format("{}: {}", summary.label_of(k), line(trend)));
    const std::size_t all = lines.size();
    lines.resize(std::min(all, most_named));
    if (all > most_named)
        lines.push_back(fmt::format("and {} more", counted(static_cast<int>(all - most_named), "case")));
    return fmt::format("{}", fmt::join(lines, "; "));
}

/// Sentences on loads that rise or fall, and on those of which that is not known.
std::vector<std::string> trend_sentences(const Summary& summary, const Counts& found) {
    const auto judged = [](const JointTrend& trend) { return std::isfinite(trend.load.low); };
    const auto open = [&](const JointTrend& trend) {
        return judged(trend) && trend.steadiness == Steadiness::not_known;
    };
    std::vector<std::string> sentences;
    if (const std::string lines = trend_lines(summary, &JointTrend::seen, change_words); !lines.empty())
        sentences.push_back(fmt::format("Not steady, change through the window: {}. Measure later{}.", lines,
                                        or_automatically(summary)));
    if (const std::string lines = trend_lines(summary, open, change_words); !lines.empty())
        sentences.push_back(fmt::format("Too few arrangements to call it steady within {:g} %: {}.",
                                        steady_change / unit::percent, lines));
    // Of one or two members nothing else is known.
    if (std::ranges::none_of(summary.cases, judged, &CaseSummary::trend) &&
        more_than_chance(found.rising + found.falling, found.done))
        sentences.push_back(unsteady_text(found, summary));
    return sentences;
}

/// Cases in which most steps end before contacts are solved: in ice that jams loads are then too low
/// (docs/fracture.md).
std::string unsolved_text(const Sample& sample, const Summary& summary) {
    constexpr double nearly_all = 0.9;
    std::vector<std::string> lines;
    int most = 0;
    for (std::size_t k = 0; k < summary.cases.size(); ++k) {
        const int allowed = sample.cases[k].most_sweeps;
        const double mean = mean_of(sample.values(sample.done(k), quantity("mean_sweeps")));
        if (allowed == 0 || !(mean > nearly_all * allowed)) continue;
        lines.push_back(fmt::format("{}, {:.3g} of at most {}", summary.label_of(k), mean, allowed));
        most = std::max(most, allowed);
    }
    if (lines.empty()) return "";
    return fmt::format(
        "Contacts are not solved in most steps (sweeps a step: {}): where ice jams, loads are too low, on a wall by "
        "half and more. Try general.iterations = {}.",
        fmt::join(lines, "; "), 10 * most);
}

/// Cases of which --window auto found no later window.
std::string no_later_text(const Summary& summary) {
    std::vector<std::size_t> cases;
    for (std::size_t k = 0; k < summary.cases.size(); ++k)
        if (summary.cases[k].about.window == CaseRow::Window::none_steady) cases.push_back(k);
    if (cases.empty()) return "";
    return fmt::format("--window auto found no steady part of a segment or more in {}: measured in the window given.",
                       label_list(summary, cases));
}

/// Members whose mean load is far above the others'.
std::string standing_out_text(const Sample& sample, const Summary& summary) {
    std::vector<std::string> lines;
    for (std::size_t k = 0; k < summary.cases.size(); ++k) {
        const Members& members = sample.done(k);
        std::vector<std::size_t> numbers;
        for (const std::size_t row : apart(sample.values(members, quantity("mean_load")), Sides::above).above)
            numbers.push_back(members[row]);
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
    std::vector<std::size_t> few;
    int least = fewest_for_interval;
    int most = 0;
    int needed = 0;
    for (std::size_t k = 0; k < summary.cases.size(); ++k) {
        const CaseSummary& one = summary.cases[k];
        if (one.done == 0 || one.done >= fewest_for_interval) continue;
        few.push_back(k);
        least = std::min(least, one.done);
        most = std::max(most, one.done);
        needed = std::max(needed, arrangements_for(one.of(quantity("mean_load")), one.done, 0.2));
    }
    if (few.empty()) return "";
    const std::string where = few.size() == summary.cases.size() ? "" : " (" + label_list(summary, few) + ")";
    const std::string count = least == most ? fmt::format("{}", least) : fmt::format("{} to {}", least, most);
    const std::string remedy = needed > 0
                                   ? fmt::format("about {} arrangements would give the mean load to 20 %", needed)
                                   : std::string{"8 arrangements or more are a beginning"};
    return fmt::format("n = {}{}: no interval worth printing; {}.", count, where, remedy);
}

/// Rad, by which a hull turns before the edge of its deck is in the water, about the axis across the tow (0) and along
/// it (1).
std::array<double, 2> turns_to_deck(const Shape& shape) {
    constexpr int sides = 48;
    std::array<double, 2> reach{};
    for (const Vec3& point : shape.mesh(sides).points) {
        if (point.y() < shape.top() - 1e-9) continue;
        reach[0] = std::max(reach[0], std::abs(point.x()));
        reach[1] = std::max(reach[1], std::abs(point.z()));
    }
    return {std::atan2(shape.top(), reach[0]), std::atan2(shape.top(), reach[1])};
}

/// Cases in which a hull turned further than holds what it is computed by (docs/moorings.md).
std::string heel_text(const Sample& sample, const Summary& summary) {
    constexpr double small_turn = 5 * unit::degree;
    std::vector<std::string> far;
    std::vector<std::string> wet;
    for (std::size_t k = 0; k < summary.cases.size(); ++k) {
        std::optional<std::array<double, 2>> to_deck;
        for (const auto& [which, key, words] :
             {std::tuple{0U, "largest_pitch", "pitch"}, std::tuple{1U, "largest_roll", "roll"}}) {
            double largest = 0;  // of members that float: others have no such number
            for (const double turn : sample.values(sample.done(k), *find_quantity(key)))
                largest = std::max(largest, std::abs(turn));
            if (!(largest > small_turn)) continue;
            if (!to_deck) to_deck = turns_to_deck(summary.cases[k].about.shape);
            const std::string turn =
                fmt::format("{}: {} of {:.1f}°", summary.label_of(k), words, largest / unit::degree);
            far.push_back(turn);
            if (largest > to_deck->at(which))
                wet.push_back(fmt::format("{}, wet from {:.1f}°", turn, to_deck->at(which) / unit::degree));
        }
    }
    if (far.empty()) return "";
    std::string told = fmt::format(
        "The hull turns by more than 5° ({}): righting moments, buoyancy and moorings are those of small turns, and "
        "the wall meets ice at another angle than the hull at rest.",
        fmt::join(far, "; "));
    if (!wet.empty())
        told += fmt::format(
            " The edge of its deck is in the water ({}): it rights itself less than is computed, and ice can come on "
            "deck.",
            fmt::join(wet, "; "));
    return told;
}

std::string failed_text(const Counts& found, const Summary& summary) {
    std::string text = fmt::format("{} of {} failed and {} in no figure. Member {}: {}", found.failed_members,
                                   counted(found.members, "member"), found.failed_members == 1 ? "counts" : "count",
                                   summary.failed.front().member, summary.failed.front().reason);
    if (!text.ends_with('.')) text += '.';
    if (found.failed_members > 1) text += " floes status has the others.";
    return text;
}

}  // namespace

std::vector<std::string> warnings_of(const Sample& sample, const Summary& summary) {
    const Counts found(sample, summary);
    std::vector<std::string> sentences;
    if (found.failed_members > 0) sentences.push_back(failed_text(found, summary));
    if (found.missing_members > 0)
        sentences.push_back(
            fmt::format("{} of {} {} no result yet{}", found.missing_members, counted(found.members, "member"),
                        found.missing_members == 1 ? "has" : "have",
                        found.done > 0 ? ". Short runs finish first, so the figures lean towards them." : "."));
    if (found.untouched > 0) sentences.push_back(untouched_text(found, summary));
    std::ranges::move(trend_sentences(summary, found), std::back_inserter(sentences));
    for (std::string text : {no_later_text(summary), unsolved_text(sample, summary), heel_text(sample, summary),
                             standing_out_text(sample, summary), few_text(summary)})
        if (!text.empty()) sentences.push_back(std::move(text));
    return sentences;
}

std::string warning_lines(const std::vector<std::string>& warnings) {
    std::string lines;
    for (const std::string& one : warnings) lines += "! " + one + "\n";
    return lines;
}

namespace {

constexpr std::size_t most_changes = 3;

std::vector<std::string> basis_sentences(const Evidence& evidence, const DesignLoads& designs) {
    std::vector<std::string> sentences;
    Summary stated = evidence.summary;
    if (const std::optional<std::size_t> base = base_case(evidence.campaign)) {
        stated.cases = {stated.cases[*base]};
        stated.labels.clear();
    } else {
        std::ranges::move(variation_lines(evidence.campaign, evidence.summary), std::back_inserter(sentences));
    }
    std::ranges::move(condition_lines(stated), std::back_inserter(sentences));
    const auto cases_that = [&](Steadiness steadiness) {
        return std::ranges::count(evidence.summary.cases, steadiness,
                                  [](const CaseSummary& row) { return row.trend.steadiness; });
    };
    sentences.push_back(fmt::format(
        "{}, one for each case and arrangement; through the window the load is steady in {}, rises in {}, falls in {}; "
        "of {} it is not known.",
        counted(evidence.summary.counts().done, "simulation"), counted(cases_that(Steadiness::steady), "case"),
        cases_that(Steadiness::rises), cases_that(Steadiness::falls), cases_that(Steadiness::not_known)));
    double times = 0;
    for (const CaseDesignLoad& one : designs.of_cases)
        if (one.load.valid()) times = std::max(times, designs.asked.model_exposure() / one.load.time_run);
    if (times > 0)
        sentences.push_back(fmt::format(
            "The largest load is extrapolated to {:.2g} times the time that was run, by two tails of declustered peaks "
            "weighted by their likelihoods; floes design has every method.",
            times));
    return sentences;
}

std::vector<std::string> changes(Evidence& evidence) {
    if (evidence.campaign.design.active())
        return change_sentences(sensitivity_of(evidence), evidence.units, most_changes);
    std::vector<std::string> sentences;
    if (std::string told = width_sentence(find_model_width(evidence), evidence.units); !told.empty())
        sentences.push_back(std::move(told));
    return sentences;
}

}  // namespace

CampaignAnswer find_answer(Evidence& evidence) {
    const DesignLoads designs = evidence.campaign.design.active() ? DesignLoads{} : designs_of(evidence);
    return {warnings_of(evidence.sample, evidence.summary), basis_sentences(evidence, designs), changes(evidence)};
}

}  // namespace floes
