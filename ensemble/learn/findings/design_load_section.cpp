#include "findings/design_load_section.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <span>

#include "core/units.hpp"
#include "findings/conditions.hpp"
#include "findings/design_load_pairs.hpp"
#include "findings/design_load_records.hpp"
#include "findings/printable.hpp"
#include "findings/stationary.hpp"
#include "tables/number_text.hpp"

namespace floes {
namespace {

/// The methods that hold for such members.
std::span<const DesignLoadEstimate> shown(const CaseDesignLoad& one) {
    const std::span<const DesignLoadEstimate> all = one.load.estimates;
    return one.of_one_kind() ? all : all.first(std::min<std::size_t>(1, all.size()));
}

LoadUnit unit_for(const std::vector<CaseDesignLoad>& designs, const DesignLoadRequest& request) {
    double largest = 0;
    for (const CaseDesignLoad& one : designs)
        for (const DesignLoadEstimate& made : shown(one))
            for (const DesignLoadFigure& figure : made.quantiles)
                if (figure.value > largest) largest = figure.value;
    largest *= request.force_factor();
    const LoadUnit unit = load_unit(largest);
    return {unit.name, unit.factor * request.force_factor()};
}

Cell load_cell(const DesignLoadFigure& figure, double factor, std::size_t arrangements) {
    return range_cell(figure, factor, says_something(figure.value, figure.interval, static_cast<int>(arrangements)));
}

/// Three digits, "–" where undefined.
std::string three(double value) {
    return std::isfinite(value) ? fmt::format("{:.3g}", value) : "–";
}

/// Sentences about loads that rise and members that stand out, before any figure.
std::string doubt_lines(const Summary& summary, const std::vector<CaseDesignLoad>& designs) {
    std::string lines;
    for (const CaseDesignLoad& one : designs)
        if (one.trend.rises() && !one.refused)
            lines += fmt::format("! {}: {}: a longer exposure may see higher loads than these.\n",
                                 summary.label_of(one.case_index), trend_text(one.trend));
    for (const CaseDesignLoad& one : designs)
        if (const std::string text = standing_out_text(one); !text.empty())
            lines += fmt::format("! {}: {}\n", summary.label_of(one.case_index), text);
    return lines;
}

/// Of a rise or fall that is sure, but too small to matter; empty if there is none.
std::string negligible_text(const std::string& name, const JointTrend& trend) {
    if (!trend.negligible()) return "";
    return fmt::format("{}: {}; surely less than {:g} %, it is taken as steady.", name, trend_text(trend),
                       negligible_change / unit::percent);
}

/// "E30: too few peaks (3 of 20) to fit; about 27 arrangements would do."
std::string none_text(const std::string& name, const CaseDesignLoad& one, const CaseRow& about) {
    if (one.refused)
        return fmt::format(
            "{}: {}, so it is not known how high it gets later. Measure later (--window auto, or run with a later "
            "analysis.steady_start_s); --rising extrapolates as if it stayed as in the window.{}",
            name, trend_text(one.trend), end_text(about));
    const DesignLoad& load = one.load;
    if (load.arrangements < fewest_members)
        return fmt::format("{}: {} of the {} arrangements that a design load needs; 8 or more are a beginning.", name,
                           load.arrangements, fewest_members);
    const double more =
        load.peaks > 0
            ? std::ceil(static_cast<double>(fewest_peaks * load.arrangements) / static_cast<double>(load.peaks))
            : 0;
    return fmt::format("{}: too few peaks ({} of {}) to fit; {}.", name, load.peaks, fewest_peaks,
                       more > static_cast<double>(load.arrangements)
                           ? fmt::format("about {:.0f} arrangements would do", more)
                           : std::string{"run more arrangements"});
}

std::string percent(double share) {
    return fmt::format("{:.3g} %", share / unit::percent);
}

/// Of whole percent.
std::string percent_of(double share) {
    return fixed(share / unit::percent, 0) + " %";
}

std::string scale_words(const DesignLoadRequest& request) {
    if (request.scale == 1) return "";
    return fmt::format(
        "\nFull scale by Froude, 1 : {0:g}: lengths x {0:g}, times x {1:.3g}, loads x {2:.3g}. The strength of the ice "
        "and "
        "its modulus are then {0:g} times those of the campaign.\n",
        request.scale, std::sqrt(request.scale), request.force_factor());
}

std::string design_title(const DesignLoadRequest& request) {
    if (request.force == DesignLoadRequest::Force::k_x)
        return fmt::format("Design mooring force: the largest k x in {:g} h", request.exposure / unit::hour);
    if (request.force == DesignLoadRequest::Force::moorings)
        return fmt::format("Design mooring force: the largest force of springs and lines along the tow in {:g} h",
                           request.exposure / unit::hour);
    return fmt::format("Design load: the largest load averaged over {:g} s in {:g} h", request.averaging,
                       request.exposure / unit::hour);
}

/// Beside the figure that it is about; empty where the methods agree.
std::string doubt_text(const CaseDesignLoad& one) {
    if (!one.of_one_kind()) return "";
    const double apart = disagreement(one.load);
    return apart > much_disagreement ? fmt::format(" (methods differ by {:.0f} %)", apart / unit::percent) : "";
}

Section loads_section(const Summary& summary, const std::vector<CaseDesignLoad>& designs,
                      const DesignLoadRequest& request, const LoadUnit& unit) {
    Table table{{"case", {fmt::format("expected, {}", unit.name), ""}}};
    for (const double p : request.quantiles)
        table.front().push_back({fmt::format("exceeded with {}, {}", percent(1 - p), unit.name), ""});
    std::vector<std::string> too_few;
    std::vector<std::string> steadiness;
    for (const CaseDesignLoad& one : designs) {
        const std::string& name = summary.label_of(one.case_index);
        const CaseRow& about = summary.cases[one.case_index].about;
        if (std::string small = negligible_text(name, one.trend); !small.empty())
            steadiness.push_back(std::move(small));
        if (!one.load.valid()) {
            too_few.push_back(none_text(name, one, about));
            continue;
        }
        if (std::string steady = stationary_text(name, one.trend, about); !steady.empty())
            steadiness.push_back(std::move(steady));
        for (const DesignLoadEstimate& made : shown(one)) {
            std::vector<Cell>& line = table.emplace_back();
            const bool first = made.method == LargestBy::both_tails;
            line.emplace_back(first ? fmt::format("{}, {}{}", name, name_of(made.method), doubt_text(one))
                                    : fmt::format("  {}", name_of(made.method)));
            line.push_back(load_cell(made.expected, unit.factor, one.load.arrangements));
            for (const DesignLoadFigure& figure : made.quantiles)
                line.push_back(load_cell(figure, unit.factor, one.load.arrangements));
        }
    }
    if (too_few.size() == designs.size())
        return {.title = design_title(request), .before = fmt::format("{}\n", fmt::join(too_few, "\n"))};
    std::vector<std::string> notes = std::move(too_few);
    notes.insert(notes.end(), steadiness.begin(), steadiness.end());
    return {
        .title = design_title(request),
        .table = std::move(table),
        .after =
            "\nBrackets: 95 %. Both tails: Pareto and Weibull tail of members that may differ, above several "
            "thresholds; "
            "its interval includes which of these it is. The others, by bootstrap over arrangements, take members as "
            "alike; Gumbel and GEV: of the segment maxima. docs/design_load.md\n" +
            scale_words(request),
        .notes = std::move(notes)};
}

Section basis_section(const Summary& summary, const std::vector<CaseDesignLoad>& designs,
                      const DesignLoadRequest& request, const LoadUnit& unit) {
    if (std::ranges::none_of(designs, [](const CaseDesignLoad& one) { return one.load.valid(); })) return {};
    Table table{{"what it rests on"}};
    const auto row = [&](std::string label, auto cell) {
        std::vector<Cell>& line = table.emplace_back();
        line.emplace_back(std::move(label));
        for (const CaseDesignLoad& one : designs) line.push_back(one.load.valid() ? Cell{cell(one)} : Cell{"–"});
    };
    // A single tail through two kinds of member is that of neither.
    const auto of_one_kind = [](auto cell) {
        return [cell](const CaseDesignLoad& one) { return one.of_one_kind() ? cell(one) : std::string{"–"}; };
    };
    for (const CaseDesignLoad& one : designs) table.front().emplace_back(summary.label_of(one.case_index));
    row("arrangements", [](const CaseDesignLoad& one) { return fmt::format("{}", one.load.arrangements); });
    row("time run, h",
        [&](const CaseDesignLoad& one) { return three(one.load.time_run * std::sqrt(request.scale) / unit::hour); });
    row("exposure / time run",
        [&](const CaseDesignLoad& one) { return fmt::format("{:.2g}", request.model_exposure() / one.load.time_run); });
    row("members that stand out",
        [](const CaseDesignLoad& one) { return fmt::format("{}", one.load.unlike.out.size()); });
    row("a kind of member may be unseen, up to",
        [](const CaseDesignLoad& one) { return percent_of(unseen_share(one.load.arrangements)); });
    row("the others' scales differ by (SD)", [](const CaseDesignLoad& one) { return percent_of(one.load.scatter); });
    row("peaks above the threshold a member, variance / mean",
        [](const CaseDesignLoad& one) { return fixed(one.load.unlike.dispersion, 2); });
    row("  p, if members are alike", [](const CaseDesignLoad& one) { return three(one.load.unlike.dispersion_p); });
    row("not steady",
        [&](const CaseDesignLoad& one) { return fmt::format("{}", summary.cases[one.case_index].not_steady); });
    row("peaks at least apart, s",
        [&](const CaseDesignLoad& one) { return three(one.separation * std::sqrt(request.scale)); });
    row(fmt::format("threshold, {}", unit.name),
        [&](const CaseDesignLoad& one) { return three(unit.factor * one.load.threshold); });
    row("peaks above", [](const CaseDesignLoad& one) { return fmt::format("{}", one.load.peaks); });
    row("ξ of the Pareto tail", of_one_kind([](const CaseDesignLoad& one) { return fixed(one.load.pareto.shape, 2); }));
    row("c of the Weibull tail",
        of_one_kind([](const CaseDesignLoad& one) { return fixed(one.load.weibull.shape, 2); }));
    row("weight of the Weibull tail", [](const CaseDesignLoad& one) { return fixed(one.load.weibull_weight, 2); });
    for (std::size_t k = 0; k < std::size(threshold_shares); ++k)
        row(fmt::format("with the highest {} of the peaks, {}", percent(threshold_shares[k]), unit.name),
            of_one_kind([&, k](const CaseDesignLoad& one) { return three(unit.factor * one.over_shares[k]); }));
    row("methods differ by", of_one_kind([](const CaseDesignLoad& one) { return percent_of(disagreement(one.load)); }));
    row("resamples without a fit",
        [](const CaseDesignLoad& one) { return fmt::format("{} of {}", one.load.dropped, one.load.draws.size()); });
    row("more arrangements for half the interval",
        [](const CaseDesignLoad& one) { return fmt::format("{}", 3 * one.load.arrangements); });
    return {
        .table = std::move(table),
        .after = fmt::format(
            "\nEach tail is fitted to the highest {} of the peaks; both tails average over more and fewer. A kind "
            "of member as rare as \"unseen, up to\" is missing from one sample of this size in twenty, and then from "
            "the loads. ξ below 0: the load is bounded; above "
            "0: its tail is heavy. c: 1 exponential, 2 Gaussian. The load with other shares of the "
            "peaks, and the methods' difference, are of the load exceeded with {}.\n",
            percent(request.share), percent(1 - request.quantiles.front()))};
}

}  // namespace

std::vector<Section> design_load_sections(const Summary& summary, const std::vector<CaseDesignLoad>& designs,
                                          const DesignLoadRequest& request) {
    const LoadUnit unit = unit_for(designs, request);
    const std::string conditions = fmt::format("{}", fmt::join(condition_lines(summary), "\n"));
    Section loads = loads_section(summary, designs, request, unit);
    loads.records = {load_records(summary, designs, request), basis_records(summary, designs, request),
                     rate_records(summary, designs)};
    return {{.before = fmt::format("{}Campaign {}.\n{}\n", doubt_lines(summary, designs), summary.title, conditions)},
            std::move(loads),
            basis_section(summary, designs, request, unit),
            design_pairs_section(summary, designs, request, unit)};
}

}  // namespace floes
