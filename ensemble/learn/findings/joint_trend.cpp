#include "findings/joint_trend.hpp"

namespace floes {

std::vector<JointTrend> joint_trends(const CampaignTable& table) {
    std::vector<std::vector<MemberTrend>> cases(table.cases.size());
    for (std::size_t index = 0; index < table.cases.size(); ++index)
        for (const MemberRow* row : done_members(table, index))
            cases[index].push_back(member_trend(*row, table.cases[index].analysis.window));
    return joint_trends(cases);
}

}  // namespace floes
