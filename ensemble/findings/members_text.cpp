#include "findings/members_text.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "findings/figures.hpp"

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

std::string members_csv(const CampaignTable& table) {
    std::string text = "member,case,arrangement,status";
    for (const Quantity& quantity : quantities) text += fmt::format(",{}", quantity.key);
    std::size_t segments = 0;  // the most that a case has
    for (const MemberRow& row : table.members) segments = std::max(segments, row.segment_maximum.size());
    for (std::size_t segment = 1; segment <= segments; ++segment) text += fmt::format(",segment_{}_maximum_N", segment);
    text += ",trend_p\n";
    for (std::size_t number = 0; number < table.members.size(); ++number) {
        const MemberRow& row = table.members[number];
        text += fmt::format("{},{},{},{}", number, table.cases.at(static_cast<std::size_t>(row.case_index)).name,
                            row.arrangement, status_word(row.status));
        const bool done = row.status == RowStatus::done;
        for (const Quantity& quantity : quantities) text += "," + (done ? csv_number(quantity.value(row)) : "");
        for (std::size_t segment = 0; segment < segments; ++segment) {
            const bool has_it = done && segment < row.segment_maximum.size();
            text += "," + (has_it ? csv_number(row.segment_maximum[segment]) : "");
        }
        text += "," + (done ? csv_number(row.trend_p) : "") + "\n";
    }
    return text;
}

}  // namespace floes
