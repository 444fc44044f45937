#include "campaign_file/arrangement_rows.hpp"

#include <algorithm>

namespace floes {

ArrangementRows::ArrangementRows(const Campaign& campaign)
    : group_of_case_(sharing_groups(campaign)), arrangements_(campaign.arrangements) {
    groups_ = *std::ranges::max_element(group_of_case_) + 1;
}

int ArrangementRows::row(MemberKey member) const {
    return member.arrangement * groups_ + group_of_case_.at(static_cast<std::size_t>(member.case_index));
}

}  // namespace floes
