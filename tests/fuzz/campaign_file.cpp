// A published campaign file, damaged.

#include "campaign_file/publish.hpp"
#include "campaign_file/read_campaign_file.hpp"
#include "campaign_file/read_details.hpp"
#include "campaign_file/read_history.hpp"
#include "campaign_file/read_load_map.hpp"
#include "fuzz/edited_file.hpp"
#include "support/synthetic.hpp"
#include "support/temporary_folder.hpp"

namespace {

using namespace floes;

fuzz::EditedFile published() {
    const TemporaryFolder folder;
    const Campaign campaign = synthetic::campaign(1);
    std::vector<MemberRecord> records;
    for (int number = 0; number < member_count(campaign); ++number)
        records.push_back(synthetic::record(campaign, number));
    publish(folder / "a.h5", campaign, records, std::vector<Session>(1));
    fuzz::require(!read_campaign_file(folder / "a.h5").members.empty(), "the whole file has no members");
    return fuzz::EditedFile(folder / "a.h5");
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    static fuzz::EditedFile file = published();
    file.edit(std::span(data, size));
    const std::filesystem::path path = file.path();
    const auto table = fuzz::taken([&] { return read_campaign_file(path); });
    fuzz::require(table.has_value() || size > 0, "the whole file is refused");
    fuzz::taken([&] { return campaign_of(read_origin(path), path); });
    fuzz::taken([&] { return read_poses(path, 0); });
    fuzz::taken([&] { return read_wall_times(path); });
    fuzz::taken([&] { return read_breaks(path); });
    double sum = 0;
    fuzz::taken([&] {
        for_each_history(path, [&](const SurgeHistory& one) {
            for (const double load : one.surge) sum += load;
        });
        return sum;
    });
    fuzz::taken([&] {
        for_each_load_map(path, [&](int, const LoadMap& map) {
            for (const double load : map.surge) sum += load;
        });
        return sum;
    });
    return 0;
}
