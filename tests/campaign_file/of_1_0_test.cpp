// Files that floes 1.0 wrote are read for good: two.h5 and two.journal are what 1.0.0 made of two.toml, two members
// that break floes, with levels, averaged loads and a thinned history.

#include <gtest/gtest.h>

#include <filesystem>

#include "campaign_file/publish.hpp"
#include "hdf5/verify.hpp"
#include "journal/journal.hpp"
#include "support/everything_read.hpp"
#include "support/temporary_folder.hpp"

namespace floes {
namespace {

const std::filesystem::path folder_of_1_0 = std::filesystem::path(FLOES_SOURCE_DIR) / "tests/campaign_file/of_1_0";

TEST(FilesOf10, JournalGivesTheFileThatWasPublishedOfIt) {
    const TemporaryFolder folder;
    std::filesystem::copy(folder_of_1_0 / "two.journal", folder / "two.journal");
    const Campaign campaign = CampaignFile(folder_of_1_0 / "two.h5").campaign();
    const Journal journal = open_journal(folder / "two.journal", campaign, Existing::resume);
    publish(folder / "two.h5", campaign, journal.members(), journal.sessions());
    EXPECT_EQ(table_read(folder / "two.h5"), table_read(folder_of_1_0 / "two.h5"));
    EXPECT_EQ(breaks_read(folder / "two.h5"), breaks_read(folder_of_1_0 / "two.h5"));
    EXPECT_EQ(histories_read(folder / "two.h5"), histories_read(folder_of_1_0 / "two.h5"));
    EXPECT_EQ(load_maps_read(folder / "two.h5"), load_maps_read(folder_of_1_0 / "two.h5"));
    EXPECT_EQ(poses_read(folder / "two.h5"), poses_read(folder_of_1_0 / "two.h5"));
}

TEST(FilesOf10, AreReadWhole) {
    const CampaignTable table = read_campaign_file(folder_of_1_0 / "two.h5");
    ASSERT_EQ(table.members.size(), 2u);
    EXPECT_EQ(table.members[0].failures[0], 4);
    EXPECT_EQ(table.members[1].failures[0], 7);
    EXPECT_EQ(table.levels, (std::vector<double>{1, 5}));
    EXPECT_EQ(table.averaging_times, (std::vector<double>{0.1, 0.5}));
    EXPECT_EQ(table.members[1].load.segment_maximum.size(), 3u);
    EXPECT_FALSE(table.members[1].averaged_over(0.1)->peaks.empty());
    EXPECT_EQ(read_breaks(folder_of_1_0 / "two.h5").size(), 11u);
    EXPECT_EQ(read_poses(folder_of_1_0 / "two.h5", 1).size(), 6u);
}

}  // namespace
}  // namespace floes
