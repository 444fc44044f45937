#include "findings/catalogue.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "campaign_file/publish.hpp"
#include "campaign_file/read.hpp"
#include "support/synthetic.hpp"
#include "support/temporary_folder.hpp"

namespace floes {
namespace load_maps_test {

/// Member n of the first case has n + 1 N straight ahead at the keel, 3 N at 45 degrees at the top.
std::vector<MemberRecord> loaded(const Campaign& campaign) {
    std::vector<MemberRecord> records;
    for (const int number : {0, 3, 6}) {
        MemberRecord& record = records.emplace_back(synthetic::record(campaign, number));
        LoadMap map;
        map.surge.assign(LoadMap::heights * LoadMap::angles, 0.0);
        map.normal = map.surge;
        map.surge[17] = number + 1;
        map.surge[11 * LoadMap::angles + 22] = 3;
        map.normal[17] = 10 * (number + 1);
        for (std::size_t part = 0; part < LoadMap::parts; ++part)
            map.along_tow.push_back(number + 0.1 * static_cast<double>(part));
        record.result.load_map = map;
    }
    return records;
}

TEST(LoadMaps, AreMeansOverTheMembersOfACase) {
    const TemporaryFolder folder;
    const Campaign campaign = synthetic::campaign();
    publish(folder / "a.h5", campaign, loaded(campaign), {});
    const auto maps = find_load_maps(folder / "a.h5", read_campaign_file(folder / "a.h5"));
    ASSERT_EQ(maps.size(), 1u);  // of the other cases no member is done
    EXPECT_EQ(maps[0].case_index, 0u);
    EXPECT_EQ(maps[0].members, 3);
    EXPECT_DOUBLE_EQ(maps[0].load(), 7);
    EXPECT_DOUBLE_EQ(maps[0].mean.normal[17], 40);
    EXPECT_DOUBLE_EQ(maps[0].share_within(30), 4.0 / 7);
    EXPECT_DOUBLE_EQ(maps[0].share_within(60), 1);
    EXPECT_DOUBLE_EQ(maps[0].share_between(0, 0.5), 4.0 / 7);
    ASSERT_EQ(maps[0].along_tow.size(), LoadMap::parts);
    EXPECT_DOUBLE_EQ(maps[0].along_tow[10].estimate, 4);
    EXPECT_NEAR(maps[0].along_tow[10].high - 4, 4.302652729911275 * 3 / std::sqrt(3.0), 1e-9);  // t(2), s = 3
}

// 1.75 m/s for the run-up of 1 s and half of the window of 1.2 s; then the structure stands.
TEST(LoadMaps, AreDrawnAlongThePath) {
    const TemporaryFolder folder;
    const Campaign campaign = synthetic::campaign();
    publish(folder / "a.h5", campaign, loaded(campaign), {});
    Evidence evidence = read_evidence(CampaignFile(folder / "a.h5"));
    evidence.campaign.cases[0].scenario.path.legs = {{0, 1.75, 1.6, 0}, {0, 0, 0.6, 0}};
    const Section drawn = load_map_section(evidence);
    ASSERT_FALSE(drawn.figures.empty());
    EXPECT_EQ(drawn.figures.back().x.label, "distance towed, m");
    EXPECT_NEAR(drawn.figures.back().x.low, 1.75, 1e-9);
    EXPECT_NEAR(drawn.figures.back().x.high, 1.75 * 1.6, 1e-9);
}

}  // namespace load_maps_test
}  // namespace floes
