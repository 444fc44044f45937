#include "findings/design_load_pairs.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/units.hpp"
#include "findings/printable.hpp"
#include "statistics/distributions.hpp"

namespace floes {
namespace {

/// The difference of the first quantile between two cases over the same arrangements.
struct Paired {
    const CaseDesignLoad* first;
    const CaseDesignLoad* second;
    DesignLoadFigure difference;  ///< second - first
};

/// The interval of resampled differences about the estimate, wider by Student's t of the arrangements over that of very
/// many: resamples of few scatter too little.
DesignLoadFigure widened(double estimate, std::vector<double> resampled, double arrangements) {
    if (resampled.empty()) return {estimate, {std::nan(""), std::nan("")}};
    std::ranges::sort(resampled);
    const double middle = quantile_of_sorted(resampled, 0.5);
    const Limits limits = percentile_interval(std::move(resampled));
    const double wider =
        student_t(arrangements - 1, 0.025) / student_t(1e6, 0.025) * std::sqrt(arrangements / (arrangements - 1));
    return {estimate, {estimate + wider * (limits.low - middle), estimate + wider * (limits.high - middle)}};
}

std::vector<Paired> pairs_of(const std::vector<CaseDesignLoad>& designs) {
    std::vector<Paired> pairs;
    for (std::size_t a = 0; a < designs.size(); ++a) {
        for (std::size_t b = a + 1; b < designs.size(); ++b) {
            const CaseDesignLoad& one = designs[a];
            const CaseDesignLoad& other = designs[b];
            if (!one.load.valid() || !other.load.valid() || !one.of_one_kind() || !other.of_one_kind() ||
                one.arrangements != other.arrangements)
                continue;
            std::vector<double> differences;
            for (std::size_t k = 0; k < std::min(one.load.draws.size(), other.load.draws.size()); ++k)
                differences.push_back(other.load.draws[k].front() - one.load.draws[k].front());
            std::erase_if(differences, [](double difference) { return !std::isfinite(difference); });
            const auto value = [](const CaseDesignLoad& of) {
                return of.load.estimates.front().quantiles.front().value;
            };
            pairs.push_back({&one, &other,
                             widened(value(other) - value(one), std::move(differences),
                                     static_cast<double>(one.arrangements.size()))});
        }
    }
    return pairs;
}

}  // namespace

Cell range_cell(const DesignLoadFigure& figure, double factor, bool said) {
    const int decimals = std::abs(factor * figure.value) < 100 ? 1 : 0;
    return {fixed(factor * figure.value, decimals),
            said ? bracket(factor * figure.interval.low, factor * figure.interval.high, decimals) : "–"};
}

Section design_pairs_section(const Summary& summary, const std::vector<CaseDesignLoad>& designs,
                             const DesignLoadRequest& request, const LoadUnit& unit) {
    const std::vector<Paired> pairs = pairs_of(designs);
    if (pairs.empty()) return {};
    Table table{{"pair", {fmt::format("difference, {}", unit.name), ""}}};
    for (const Paired& one : pairs)
        table.push_back(
            {fmt::format("{} - {}", summary.label_of(one.second->case_index), summary.label_of(one.first->case_index)),
             range_cell(one.difference, unit.factor, one.first->load.arrangements >= fewest_for_interval)});
    std::vector<DataColumn<Paired>> columns{
        {"first", [&](const Paired& one) { return summary.name_of(one.first->case_index); }},
        {"second", [&](const Paired& one) { return summary.name_of(one.second->case_index); }},
        {"difference_N", [&](const Paired& one) { return request.force_factor() * one.difference.value; }},
        {"low", [&](const Paired& one) { return request.force_factor() * one.difference.interval.low; }},
        {"high", [&](const Paired& one) { return request.force_factor() * one.difference.interval.high; }}};
    return {.table = std::move(table),
            .after = fmt::format(
                "\nDifferences of the load exceeded with {:.3g} %, by both tails, over the same arrangements, with "
                "members taken as alike.\n",
                (1 - request.quantiles.front()) / unit::percent),
            .records = {json_only(make_rows<Paired>("design/pairs", pairs, columns))}};
}

}  // namespace floes
