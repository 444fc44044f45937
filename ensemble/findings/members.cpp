#include "findings/members.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace floes {
namespace {

const char* status_word(RowStatus status) {
    switch (status) {
        case RowStatus::done:
            return "done";
        case RowStatus::failed:
            return "failed";
        case RowStatus::missing:
            break;
    }
    return "missing";
}

}  // namespace

Section members_section(const CampaignTable& table) {
    Results results{
        .columns = program_columns("member case arrangement status"), .view = Results::View::none, .in_json = false};
    const std::vector<Quantity> known = table.quantities();
    std::vector<Quantity> shown;
    for (const Quantity& quantity : shown_in(known, Shown::in_summary)) shown.push_back(quantity);
    for (const Quantity& quantity : shown) results.columns.push_back({std::string{quantity.key.view()}});
    std::size_t segments = 0;  // largest number in any case
    for (const MemberRow& row : table.members) segments = std::max(segments, row.load.segment_maximum.size());
    for (std::size_t k = 0; k < segments; ++k) results.columns.push_back({fmt::format("segment_{}_maximum", k + 1)});
    results.columns.push_back({"trend_p"});
    shown.push_back(quantity("trend_p"));
    for (std::size_t number = 0; number < table.members.size(); ++number) {
        const MemberRow& row = table.members[number];
        std::vector<Datum> line{number, table.cases.at(static_cast<std::size_t>(row.case_index)).name, row.arrangement,
                                status_word(row.status)};
        for (const Quantity& quantity : shown) line.emplace_back(row.value(quantity));
        for (std::size_t k = 0; k < segments; ++k) {
            const std::vector<double>& maxima = row.load.segment_maximum;
            line.insert(line.end() - 1, row.done() && k < maxima.size() ? Datum(maxima[k]) : Datum(Absent{}));
        }
        results.add(std::move(line));
    }
    return {.results = {std::move(results)}};
}

Section long_section(const CampaignTable& table) {
    Results results{.columns = program_columns("case arrangement quantity unit value"),
                    .view = Results::View::none,
                    .in_json = false};
    const std::vector<Quantity> known = table.quantities();
    for (const MemberRow& row : table.members)
        for (const Quantity& quantity : known)
            if (row.done() && std::isfinite(row.value(quantity)))
                results.add({table.cases.at(static_cast<std::size_t>(row.case_index)).name, row.arrangement,
                             quantity.key.view(), quantity.unit, row.value(quantity)});
    return {.results = {std::move(results)}};
}

}  // namespace floes
