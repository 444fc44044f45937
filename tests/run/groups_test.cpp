#include "run/writer.hpp"

#include <gmock/gmock.h>

namespace floes {
namespace groups_test {

using testing::ElementsAre;
using testing::IsEmpty;
using testing::SizeIs;

TEST(Groups, HaveTheMasterAsTheirOnlyWriterInSmallRuns) {
    for (const int ranks : {1, 2, 15}) {
        const Groups groups(ranks);
        EXPECT_THAT(groups.writers(), IsEmpty());
        for (int rank = 0; rank < ranks; ++rank) EXPECT_EQ(groups.writer_of(rank), 0);
    }
}

TEST(Groups, HaveAWriterForEveryFourRanksInLargeRunsAndAtMost256) {
    EXPECT_THAT(Groups(16).writers(), ElementsAre(4, 8, 12));
    EXPECT_THAT(Groups(65).writers(), SizeIs(16));
    EXPECT_EQ(Groups(65).writer_of(64), 64);
    EXPECT_THAT(Groups(125).writers(), SizeIs(31));
    EXPECT_THAT(Groups(1563).writers(), SizeIs(223));
    EXPECT_THAT(Groups(15625).writers(), SizeIs(252));
}

TEST(Groups, AreAsManyAsAskedForAndAtMostOneForEachRank) {
    const Groups groups(7, 3);
    EXPECT_THAT(groups.writers(), ElementsAre(3, 6));
    EXPECT_EQ(groups.writer_of(2), 0);
    EXPECT_EQ(groups.writer_of(5), 3);
    EXPECT_EQ(groups.piece_of(0), 0);
    EXPECT_EQ(groups.piece_of(6), 2);
    EXPECT_THAT(groups.group_of(3), ElementsAre(3, 4, 5));
    EXPECT_THAT(groups.group_of(6), ElementsAre(6));
    EXPECT_THAT(groups.group_of(4), IsEmpty());
    EXPECT_THAT(Groups(3, 100).writers(), ElementsAre(1, 2));
}

}  // namespace groups_test
}  // namespace floes
