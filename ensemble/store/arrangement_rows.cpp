#include "store/arrangement_rows.hpp"

#include <algorithm>
#include <cstdint>

#include "arrangement/arrangement.hpp"

namespace floes {

ArrangementRows::ArrangementRows(const Campaign& campaign) : arrangements_(campaign.arrangements) {
    std::vector<std::uint64_t> keys;
    for (const Case& one : campaign.cases) {
        const std::uint64_t key = geometry_key(one.scenario);
        const auto known = std::find(keys.begin(), keys.end(), key);
        geometry_of_case_.push_back(static_cast<int>(known - keys.begin()));
        if (known == keys.end()) keys.push_back(key);
    }
    geometries_ = static_cast<int>(keys.size());
}

int ArrangementRows::row(MemberKey member) const {
    return member.arrangement * geometries_ + geometry_of_case_.at(static_cast<std::size_t>(member.case_index));
}

}  // namespace floes
