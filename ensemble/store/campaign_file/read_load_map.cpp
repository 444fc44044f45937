#include "campaign_file/read_load_map.hpp"

#include "campaign_file/read_arrays.hpp"

namespace floes {

void for_each_load_map(const CampaignFile& file, const std::function<void(int, const LoadMap&)>& use) {
    const hdf5::QuietErrors quiet;
    const ArrayPlaces places(file.campaign());
    const std::vector<RowStatus> states = read_states(file);
    std::vector<ArrayReader> readers = array_readers(file, "load_map", places);
    for (std::size_t member = 0; member < states.size(); ++member) {
        if (states[member] != RowStatus::done) continue;
        MemberResult result;
        for (ArrayReader& one : readers)
            one.read(member, member_key(file.campaign(), static_cast<int>(member)).case_index, result);
        if (!result.load_map.empty()) use(static_cast<int>(member), result.load_map);
    }
}

}  // namespace floes
