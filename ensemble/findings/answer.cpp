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
#include "findings/steady.hpp"
#include "inference/interval.hpp"
#include "statistics/load_statistics.hpp"

namespace floes {

namespace {

constexpr double unsteady_level = 0.05;  // p of a trend below which a member is not steady

struct Counts : MemberCounts {
    int untouched = 0;                   ///< done, without any load in the window
    int rising = 0, falling = 0;         ///< done and not steady
    std::vector<std::string> bare = {};  ///< cases of which no member met ice

    Counts(const Sample& sample, const Summary& summary) : MemberCounts(summary.counts()) {
        for (std::size_t k = 0; k < summary.cases.size(); ++k) {
            int none = 0;
            for (const std::size_t member : sample.done(k)) {
                const auto value = [&](const char* key) { return sample.value(member, *find_quantity(key)); };
                none += value("maximum_load") == 0 && value("mean_load") == 0 ? 1 : 0;
                if (!sample.steady(member)) ++(value("trend") < 0 ? falling : rising);
            }
            untouched += none;
            if (none > 0 && none == summary.cases[k].done) bare.push_back(summary.label_of(k));
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
        sentences.push_back(
            fmt::format("Not steady, change through the window: {}. Measure later, or --window auto.", lines));
    if (const std::string lines = trend_lines(summary, open, change_words); !lines.empty())
        sentences.push_back(fmt::format("Too few arrangements to call it steady within {:g} %: {}.",
                                        steady_change / unit::percent, lines));
    // Of one or two members nothing else is known.
    if (std::ranges::none_of(summary.cases, judged, &CaseSummary::trend) &&
        more_than_chance(found.rising + found.falling, found.done))
        sentences.push_back(unsteady_text(found));
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
        "half "
        "and more. Try general.iterations = {}.",
        fmt::join(lines, "; "), 10 * most);
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
        "the "
        "wall meets ice at another angle than the hull at rest.",
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
    if (found.untouched > 0) sentences.push_back(untouched_text(found, summary.cases.size()));
    std::ranges::move(trend_sentences(summary, found), std::back_inserter(sentences));
    for (std::string text : {unsolved_text(sample, summary), heel_text(sample, summary),
                             standing_out_text(sample, summary), few_text(summary)})
        if (!text.empty()) sentences.push_back(std::move(text));
    return sentences;
}

std::string warning_lines(const std::vector<std::string>& warnings) {
    std::string lines;
    for (const std::string& one : warnings) lines += "! " + one + "\n";
    return lines;
}

std::vector<std::pair<std::string, std::size_t>> extreme_points(const Summary& summary) {
    const auto mean = [&](std::size_t k) { return summary.cases[k].of(quantity("mean_load")).estimate; };
    std::vector<std::size_t> done;
    for (std::size_t k = 0; k < summary.cases.size(); ++k)
        if (std::isfinite(mean(k))) done.push_back(k);
    if (done.empty()) return {};
    const auto [least, most] = std::ranges::minmax_element(done, {}, mean);
    return {{"least mean", *least}, {"largest mean", *most}};
}

namespace {

constexpr std::size_t most_changes = 3;        // of an answer
constexpr std::size_t most_changes_shown = 6;  // on the screen
constexpr std::string_view apart_words =
    "Cases begin from other floes: differences are of means (Welch), not by arrangement.";

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

/// "Thickness from 0.02 to 0.04 m changes the mean load by +5.4 N (2.1 to 8.7).", the strongest first.
std::vector<std::string> change_sentences(const Sensitivity& found, const Units& units, std::size_t most) {
    struct Change {
        std::string told;
        double size;
    };
    std::vector<Change> changes;
    for (const SensitivityRow& row : found.rows) {
        if (row.quantity.key.view() != "mean_load" || !row.fit) continue;
        for (std::size_t axis = 0; axis < found.axes.size(); ++axis) {
            changes.push_back({change_sentence(found, row, axis, units), std::abs(row.fit->slopes[axis].estimate)});
        }
    }
    std::ranges::stable_sort(changes, std::ranges::greater{}, &Change::size);
    std::vector<std::string> sentences;
    for (std::size_t k = 0; k < std::min(changes.size(), most); ++k) sentences.push_back(changes[k].told);
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

namespace {

std::string heading(const Evidence& evidence) {
    const Summary& summary = evidence.summary;
    const bool equal = std::ranges::all_of(
        summary.cases, [&](const CaseSummary& row) { return row.members == summary.cases.front().members; });
    std::string text = fmt::format("Campaign {}: {}", summary.title, counted(summary.counts().members, "member"));
    if (!equal) return text + fmt::format(" in {}.\n", counted(std::ssize(summary.cases), "case"));
    return text + fmt::format(", {} x {}.\n", counted(std::ssize(summary.cases), "case"),
                              counted(summary.cases.front().members, "arrangement"));
}

/// Behind the columns that a row begins with: how many arrangements are done, and the loads.
void add_columns(const std::vector<LoadColumn>& loads, Results& table) {
    table.columns.push_back({.words = "n"});
    for (const LoadColumn& load : loads) table.columns.push_back(load.column());
}

void add_loads(const std::vector<LoadColumn>& loads, const CaseSummary& row, std::vector<Datum>& line) {
    line.emplace_back(row.done == row.members ? Datum(row.done)
                                              : Datum(fmt::format("{} of {}", row.done, row.members)));
    for (const LoadColumn& load : loads) line.emplace_back(estimate_of(row, load.quantity));
}

/// One row a case, with the difference to the reference where there is another case; `apart`: cases that begin from
/// other floes than it.
Results case_rows(const Evidence& evidence, const std::vector<LoadColumn>& loads, const std::vector<ApartRow>& apart) {
    const Summary& summary = evidence.summary;
    const std::size_t reference = evidence.reference.value_or(0);
    const bool compared = summary.cases.size() > 1 && (!evidence.campaign.design.active() || evidence.reference);
    std::vector<PairRow> pairs;
    Results table{.columns = {{.words = "case"}}};
    add_columns(loads, table);
    if (compared) {
        pairs = compare_with(evidence, reference, loads.front().quantity, most_overview_rows);
        ResultColumn difference = loads.front().column();
        difference.words = fmt::format("mean - {}", summary.label_of(reference));
        difference.form = ResultColumn::Form::difference;
        table.columns.push_back(std::move(difference));
    }
    for (std::size_t k = 0; k < std::min(summary.cases.size(), most_overview_rows); ++k) {
        std::vector<Datum> line{summary.label_of(k)};
        add_loads(loads, summary.cases[k], line);
        if (compared) {
            const auto pair = std::ranges::find(pairs, k, &PairRow::second);
            const auto means = std::ranges::find(apart, k, &ApartRow::second);
            if (k == reference) {
                line.emplace_back(Absent{});
            } else if (pair != pairs.end()) {
                line.emplace_back(pair->difference());
            } else {
                line.push_back(means != apart.end() ? Datum(means->difference()) : Undefined{});
            }
        }
        table.add(std::move(line));
    }
    return table;
}

/// A row for each point, its values in columns.
Results point_rows(const DesignPoints& points, const Summary& summary, const std::vector<LoadColumn>& loads) {
    const bool bases =
        std::ranges::any_of(points.rows, [&](const PointRow& row) { return row.base != points.rows.front().base; });
    Results table;
    if (bases) table.columns.push_back({.words = "case"});
    for (const KeyWords& words : axis_words(points)) table.columns.push_back({.words = words.heading()});
    add_columns(loads, table);
    for (std::size_t k = 0; k < points.rows.size(); ++k) {
        std::vector<Datum> line;
        if (bases) line.emplace_back(points.rows[k].base);
        for (const auto& value : points.rows[k].values) line.emplace_back(value_text(value));
        add_loads(loads, summary.cases[k], line);
        table.add(std::move(line));
    }
    return table;
}

/// Points with the least and the largest mean load, and in the notes where they lie.
void add_extreme_points(const Summary& summary, const std::vector<LoadColumn>& loads, Section& section) {
    const auto points = extreme_points(summary);
    if (points.empty()) return;
    Results table{.columns = {{.words = "point"}}};
    add_columns(loads, table);
    for (const auto& [words, k] : points) {
        std::vector<Datum> line{words};
        add_loads(loads, summary.cases[k], line);
        table.add(std::move(line));
        section.notes.push_back(fmt::format("The {} is at {}.", words, summary.label_of(k)));
    }
    section.results.push_back(std::move(table));
}

}  // namespace

Section overview_section(const Evidence& evidence, const Sensitivity& sensitivity) {
    const Summary& summary = evidence.summary;
    const std::vector<LoadColumn> loads = load_columns(summary);
    Section section{.before = heading(evidence) + warning_lines(warnings_of(evidence.sample, summary)) + "\n"};
    const bool design = evidence.campaign.design.active();
    const bool many = summary.cases.size() > most_overview_rows;
    std::string compared;  // how, if not arrangement by arrangement
    if (design) {
        if (many) {
            add_extreme_points(summary, loads, section);
        } else {
            section.results.push_back(point_rows(find_points(evidence.campaign), summary, loads));
        }
        std::ranges::move(change_sentences(sensitivity, evidence.units, most_changes_shown),
                          std::back_inserter(section.notes));
    } else if (const std::optional<ModelWidth> width = find_model_width(evidence)) {
        section.results.push_back(variations_table(summary, *width, most_overview_rows));
        section.notes.push_back(width_sentence(width, evidence.units));
        if (const std::size_t all = width->variations.size(); all > most_overview_rows)
            section.notes.push_back(fmt::format("{} smaller changes: --parts model.", all - most_overview_rows));
        section.after = "\n" + load_columns_text(summary) + "\n";
        return section;
    } else {
        const std::vector<ApartRow> apart =
            compare_apart(evidence, evidence.reference.value_or(0), loads.front().quantity, most_overview_rows);
        section.results.push_back(case_rows(evidence, loads, apart));
        if (!apart.empty()) compared = " " + std::string{apart_words};
    }
    section.after = "\n" + load_columns_text(summary) + compared + "\n";
    if (many && !design)
        section.notes.push_back(fmt::format("{} more cases: --full.", summary.cases.size() - most_overview_rows));
    return section;
}

Section next_commands(const Evidence& evidence, const std::string& program) {
    const std::string file = shell_word(evidence.file.string());
    const std::optional<int> worst = most_loaded_member(evidence);
    std::vector<std::pair<std::string, std::string>> commands;
    commands.emplace_back(fmt::format("{} report {}", program, file), "everything on one page");
    const bool moored = std::ranges::any_of(evidence.campaign.cases, [](const Case& one) {
        return one.scenario.moorings.give_way() && one.scenario.analysis.keep_history;
    });
    if (worst)
        commands.emplace_back(fmt::format("{} replay {} --worst -o worst.html", program, file),
                              "the largest load, in a browser");
    if (worst && moored)
        commands.emplace_back(fmt::format("{} replay {} --worst --of mooring_force -o force.png", program, file),
                              "the largest mooring force over 1 s; --of offset, tension");
    if (moored)
        commands.emplace_back(fmt::format("{} design {} --of mooring_force", program, file),
                              "the design force of the moorings; --of offset");
    commands.emplace_back(fmt::format("{} summarize {} --full", program, file), "every figure");
    std::size_t widest = 0;
    for (const auto& [command, what] : commands) widest = std::max(widest, command.size());
    std::string text = fmt::format("In {}. Next:\n", evidence.file.string());
    for (const auto& [command, what] : commands) text += fmt::format("  {:{}}  {}\n", command, widest, what);
    return {.before = text};
}

}  // namespace floes
