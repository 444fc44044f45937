// Load histories in the campaign file: whole, thinned, left out, taken out.

#include <gmock/gmock.h>

#include "campaign/campaign.hpp"
#include "campaign_file/publish.hpp"
#include "campaign_file/read.hpp"
#include "hdf5/dataset.hpp"
#include "hdf5/read.hpp"
#include "support/synthetic.hpp"
#include "support/temporary_folder.hpp"

namespace floes {
namespace history_test {

/// The records' histories as a campaign with these strides keeps them; their values are made up anyhow.
void publish_thinned(const std::filesystem::path& path, Campaign campaign, std::vector<int> strides) {
    for (std::size_t k = 0; k < strides.size(); ++k) campaign.cases[k].scenario.analysis.history_stride = strides[k];
    auto records = synthetic::records(campaign);
    for (MemberRecord& record : records) {
        for (std::size_t k = 0; k < strides.size(); ++k) {
            if (record.case_key != case_fingerprint(campaign, static_cast<int>(k))) continue;
            LoadHistory& history = record.result.history;
            for (const auto& one : load_histories)
                (history.*one.values).resize((history.*one.values).size() / static_cast<std::size_t>(strides[k]));
        }
    }
    publish(path, campaign, records, {});
}

std::vector<double> times(const std::filesystem::path& path) {
    return hdf5::read_values<double>(hdf5::open_for_reading(path).id(), "time");
}

TEST(History, HasATimeOfItsOwnWhereItIsThinned) {
    const TemporaryFolder folder;
    const auto path = folder / "a.h5";
    publish_thinned(path, synthetic::campaign(), {10, 10, 10});
    EXPECT_EQ(times(path).size(), 11u);
    EXPECT_DOUBLE_EQ(times(path)[0], 0.2);
    EXPECT_DOUBLE_EQ(times(path).back(), 2.2);
    int members = 0;
    for_each_history(path, [&](const StoredHistory& history) {
        ++members;
        EXPECT_DOUBLE_EQ(history.step, 0.2);
        EXPECT_EQ(history.values.size(), history.member % 3 == 2 ? 10u : 11u);
    });
    EXPECT_EQ(members, 10);
    EXPECT_EQ(read_campaign_file(path).cases[2].analysis.history_stride, 10);
}

TEST(History, CountsValuesWhereCasesAreThinnedDifferently) {
    const TemporaryFolder folder;
    const auto path = folder / "a.h5";
    publish_thinned(path, synthetic::campaign(), {1, 10, 5});
    EXPECT_EQ(times(path).size(), 110u);
    EXPECT_EQ(times(path)[2], 3);
    for_each_history(path, [&](const StoredHistory& history) {
        const int of_case = history.member % 3;
        EXPECT_DOUBLE_EQ(history.step, of_case == 0 ? 0.02 : of_case == 1 ? 0.2 : 0.1);
        EXPECT_EQ(history.values.size(), of_case == 0 ? 110u : of_case == 1 ? 11u : 20u);
    });
}

// A file whose histories somebody took out to make it smaller, and one of before they could be thinned.
TEST(History, IsNotMissedWhereItWasTakenOut) {
    const TemporaryFolder folder;
    const auto path = folder / "a.h5";
    const Campaign campaign = synthetic::campaign();
    publish(path, campaign, synthetic::records(campaign), {});
    const auto remove = [&](const char* name) {
        const hdf5::Handle file(H5Fopen(path.c_str(), H5F_ACC_RDWR, H5P_DEFAULT), H5Fclose, "H5Fopen", "a.h5");
        hdf5::check(H5Ldelete(file.id(), name, H5P_DEFAULT), "H5Ldelete", name);
    };
    const auto count = [&] {
        int members = 0;
        for_each_history(path, [&](const StoredHistory& history) {
            ++members;
            EXPECT_DOUBLE_EQ(history.step, 0.02);
        });
        return members;
    };
    remove("cases/history_stride");
    EXPECT_EQ(count(), 10);
    EXPECT_EQ(read_campaign_file(path).cases[0].analysis.history_stride, 1);
    remove("history/surge_load");
    EXPECT_EQ(count(), 0);
    remove("history");
    EXPECT_EQ(count(), 0);
    EXPECT_EQ(read_campaign_file(path).members.size(), 12u);
}

TEST(Levels, AreNotMissedWhereNoneAreGiven) {
    const TemporaryFolder folder;
    const auto path = folder / "a.h5";
    Campaign campaign = synthetic::campaign();
    for (Case& one : campaign.cases) one.scenario.analysis.exceedance_levels.clear();
    publish(path, campaign, synthetic::records(campaign), {});
    {
        const hdf5::Handle file(H5Fopen(path.c_str(), H5F_ACC_RDWR, H5P_DEFAULT), H5Fclose, "H5Fopen", "a.h5");
        EXPECT_FALSE(hdf5::exists(file.id(), "exceedance"));
        EXPECT_FALSE(hdf5::exists(file.id(), "level"));
    }
    const CampaignTable table = read_campaign_file(path);
    EXPECT_TRUE(table.levels.empty());
    EXPECT_TRUE(table.members[0].steps_above.empty());
}

TEST(LoadMaps, AreReadAsTheyWereWritten) {
    const TemporaryFolder folder;
    const auto path = folder / "a.h5";
    const Campaign campaign = synthetic::campaign();
    auto records = synthetic::records(campaign);
    records[3].result.load_map = {};  // as of an earlier version
    publish(path, campaign, records, {});
    std::vector<int> members;
    for_each_load_map(path, [&](int member, const LoadMap& map) {
        members.push_back(member);
        EXPECT_EQ(map, synthetic::record(campaign, member).result.load_map);
    });
    EXPECT_THAT(members, testing::ElementsAre(0, 1, 2, 5, 6, 8, 9, 10, 11));  // 4 failed, and 7 is missing
}

}  // namespace history_test
}  // namespace floes
