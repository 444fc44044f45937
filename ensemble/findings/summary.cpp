#include "findings/summary.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include <fmt/format.h>

#include "core/error.hpp"
#include "core/text.hpp"
#include "inference/interval.hpp"
#include "statistics/distributions.hpp"

namespace floes {

bool says_something(const Quantity& quantity, double estimate, Limits limits, int runs) {
    return says_something(estimate, limits, runs, kind_of(quantity));
}

int arrangements_for(const Interval& found, int runs, double share) {
    constexpr int most = 10'000;
    constexpr double tail = 0.025;
    const double half = std::max(found.high - found.estimate, found.estimate - found.low);
    if (runs < 2 || !std::isfinite(half) || found.estimate == 0 || half == 0) return 0;
    const double sd = half * std::sqrt(runs) / student_t(runs - 1, tail);
    for (int n = fewest_for_interval; n < most; ++n)
        if (student_t(n - 1, tail) * sd / std::sqrt(n) <= share * std::abs(found.estimate)) return n;
    return most;
}

namespace {

void count(const MemberRow& member, CaseSummary& row) {
    ++row.members;
    switch (member.status) {
        case RowStatus::missing:
            ++row.missing_members;
            return;
        case RowStatus::failed:
            ++row.failed_members;
            return;
        case RowStatus::done:
            break;
    }
    ++row.done;
    row.not_steady += member.load.steady ? 0 : 1;
    for (const Quantity& one : quantities)
        if (one.count && std::isfinite(one.of(member)))
            row.totals[std::string{one.key.view()}] += static_cast<std::int64_t>(one.of(member));
}

CaseSummary summarise_case(const CampaignTable& table, const std::vector<Quantity>& quantities, int number) {
    CaseSummary row;
    row.about = table.cases[static_cast<std::size_t>(number)];
    for (const MemberRow& member : table.members)
        if (member.case_index == number) count(member, row);
    const std::vector<const MemberRow*> done = done_members(table, static_cast<std::size_t>(number));
    std::vector<std::vector<double>> columns;
    for (const Quantity& quantity : shown_in(quantities, Shown::in_summary)) {
        std::vector<double>& values = columns.emplace_back();
        for (const MemberRow* member : done) values.push_back(quantity.of(*member));
        std::erase_if(values,
                      [](double value) { return !std::isfinite(value); });  // an older version did not measure it
    }
    const std::vector<Limits> resampled = bca_mean_intervals(columns);
    for (std::size_t k = 0; const Quantity& quantity : shown_in(quantities, Shown::in_summary)) {
        const std::vector<double>& values = columns[k];
        const Apart out = quantity.unit == "N" ? apart(values, Sides::above) : Apart{};
        const Interval plain = quantity.positive ? positive_interval(values) : mean_interval(values);
        // Student's limits can leave the range of the values; those of the bootstrap cannot.
        row.estimates[std::string{quantity.key.view()}] = {
            clipped(mixed_interval(values, plain, out, Sides::above), quantity.least, quantity.most), resampled[k++],
            out.count()};
    }
    return row;
}

}  // namespace

bool Summary::complete() const {
    return std::ranges::all_of(cases, [](const CaseSummary& row) { return row.missing_members == 0; });
}

Summary summarise(const CampaignTable& table) {
    Summary summary;
    summary.title = table.title;
    summary.quantities = table.quantities();
    for (int number = 0; number < static_cast<int>(table.cases.size()); ++number) {
        summary.cases.push_back(summarise_case(table, summary.quantities, number));
    }
    for (int number = 0; number < static_cast<int>(table.members.size()); ++number) {
        const MemberRow& member = table.members[static_cast<std::size_t>(number)];
        if (member.status == RowStatus::failed) summary.failed.push_back({number, member.reason});
    }
    return summary;
}

std::vector<const MemberRow*> done_members(const CampaignTable& table, std::size_t of_case) {
    std::vector<const MemberRow*> members;
    for (const MemberRow& member : table.members)
        if (member.done() && member.case_index == static_cast<int>(of_case)) members.push_back(&member);
    return members;
}

std::vector<std::pair<std::string, std::string>> case_legend(const Summary& summary) {
    constexpr std::size_t most = 12;  // more could not be told apart
    std::vector<std::pair<std::string, std::string>> legend;
    if (summary.cases.size() > most) return legend;
    for (std::size_t k = 0; k < summary.cases.size(); ++k) legend.emplace_back(colour(k), summary.label_of(k));
    return legend;
}

std::size_t case_index(const Summary& summary, std::string_view name) {
    std::vector<std::string> names;
    for (std::size_t index = 0; index < summary.cases.size(); ++index) {
        if (summary.cases[index].about.name == name) return index;
        names.push_back(summary.cases[index].about.name);
    }
    throw InputError(fmt::format("There is no case '{}' in this campaign; its cases are {}.", name, name_list(names)));
}

double difference_percent(const Summary& summary, std::size_t of_case, std::size_t reference,
                          const Quantity& quantity) {
    const double value = summary.cases.at(of_case).of(quantity).estimate;
    const double base = summary.cases.at(reference).of(quantity).estimate;
    return base == 0 ? std::numeric_limits<double>::quiet_NaN() : 100 * (value - base) / base;
}

}  // namespace floes
