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
    using Row = const MemberRow&;
    std::vector<DataColumn<MemberRow>> columns{
        {"member", [&](Row row) { return &row - table.members.data(); }},
        {"case", [&](Row row) { return table.cases.at(static_cast<std::size_t>(row.case_index)).name; }},
        {"arrangement", &MemberRow::arrangement},
        {"status", [](Row row) { return status_word(row.status); }}};
    const auto add = [&](const Quantity& quantity, std::string_view name) {
        columns.push_back({std::string{name}, [&quantity](Row row) { return row.value(quantity); }});
    };
    const std::vector<Quantity> known = table.quantities();
    for (const Quantity& one : shown_in(known, Shown::in_summary)) add(one, one.name);
    std::size_t segments = 0;  // largest number in any case
    for (const MemberRow& row : table.members) segments = std::max(segments, row.load.segment_maximum.size());
    for (std::size_t k = 0; k < segments; ++k)
        columns.push_back({fmt::format("segment_{}_maximum_N", k + 1), [k](Row row) {
                               const std::vector<double>& maxima = row.load.segment_maximum;
                               return row.done() && k < maxima.size() ? Datum(maxima[k]) : Datum(Absent{});
                           }});
    add(quantity("trend_p"), "trend_p");
    return {.records = {csv_only(make_rows<MemberRow>("", table.members, columns))}};
}

Section long_section(const CampaignTable& table) {
    struct Line {
        const MemberRow* member;
        const Quantity* quantity;
    };
    using Row = const Line&;
    const std::vector<Quantity> known = table.quantities();
    std::vector<Line> values;
    for (const MemberRow& row : table.members)
        for (const Quantity& one : known)
            if (row.done() && std::isfinite(row.value(one))) values.push_back({&row, &one});
    const std::vector<DataColumn<Line>> columns{
        {"case", [&](Row row) { return table.cases.at(static_cast<std::size_t>(row.member->case_index)).name; }},
        {"arrangement", [](Row row) { return row.member->arrangement; }},
        {"quantity", [](Row row) { return row.quantity->key.view(); }},
        {"unit", [](Row row) { return row.quantity->unit; }},
        {"value", [](Row row) { return row.member->value(*row.quantity); }}};
    return {.records = {csv_only(make_rows<Line>("", values, columns))}};
}

}  // namespace floes
