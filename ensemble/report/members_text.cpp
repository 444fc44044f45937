#include "report/members_text.hpp"

#include <fmt/format.h>

#include "report/figures.hpp"

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
    text += ",trend_p\n";
    for (std::size_t number = 0; number < table.members.size(); ++number) {
        const MemberRow& row = table.members[number];
        text += fmt::format("{},{},{},{}", number, table.cases.at(static_cast<std::size_t>(row.case_index)).name,
                            row.arrangement, status_word(row.status));
        const bool done = row.status == RowStatus::done;
        for (const Quantity& quantity : quantities) text += "," + (done ? csv_number(quantity.value(row)) : "");
        text += "," + (done ? csv_number(row.trend_p) : "") + "\n";
    }
    return text;
}

}  // namespace floes
