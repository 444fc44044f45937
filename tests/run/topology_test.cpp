#include "run/link.hpp"

#include <vector>

#include <gtest/gtest.h>

namespace floes {
namespace topology_test {

CoreMask mask_of(int first, int count) {
    CoreMask mask{};
    for (int core = first; core < first + count; ++core) {
        mask[static_cast<std::size_t>(core / 64)] |= std::uint64_t{1} << (core % 64);
    }
    return mask;
}

TEST(Topology, ALoneRankHasItsWholeMask) {
    EXPECT_EQ(share_of_cores(std::vector<CoreMask>{mask_of(0, 100)}, 0), 100);
    EXPECT_EQ(share_of_cores(std::vector<CoreMask>{mask_of(62, 4)}, 0), 4);
}

TEST(Topology, BoundRanksHaveTheirOwnCores) {
    const std::vector masks{mask_of(0, 4), mask_of(4, 2)};
    EXPECT_EQ(share_of_cores(masks, 0), 4);
    EXPECT_EQ(share_of_cores(masks, 1), 2);
}

TEST(Topology, RanksOfOneMaskShareItAndWasteNothing) {
    const std::vector<CoreMask> masks(3, mask_of(0, 8));
    EXPECT_EQ(share_of_cores(masks, 0), 3);
    EXPECT_EQ(share_of_cores(masks, 1), 3);
    EXPECT_EQ(share_of_cores(masks, 2), 2);
}

TEST(Topology, AnOversubscribedRankStillHasOneThread) {
    const std::vector<CoreMask> masks(5, mask_of(0, 2));
    for (std::size_t rank = 0; rank < masks.size(); ++rank) EXPECT_EQ(share_of_cores(masks, rank), 1);
}

TEST(Topology, SaysWhenRanksShareFewerCores) {
    const std::vector<CoreMask> masks(2, mask_of(0, 1));
    EXPECT_NE(binding_remark(make_topology(masks, 0)).find("2 ranks on this node have 1 core between them"),
              std::string::npos);
    const std::vector<CoreMask> apart{mask_of(0, 1), mask_of(1, 1)};
    EXPECT_TRUE(binding_remark(make_topology(apart, 0)).empty());
}

TEST(Topology, SaysWhenALoneRankIsBoundToPartOfItsNode) {
    EXPECT_NE(binding_remark({.cores = 1, .bound_cores = 1, .node_cores = 8, .node_ranks = 1, .rank_cores = 1})
                  .find("1 of its 8 cores"),
              std::string::npos);
    EXPECT_TRUE(
        binding_remark({.cores = 8, .bound_cores = 8, .node_cores = 8, .node_ranks = 1, .rank_cores = 8}).empty());
    EXPECT_TRUE(
        binding_remark({.cores = 4, .bound_cores = 4, .node_cores = 8, .node_ranks = 2, .rank_cores = 8}).empty());
}

}  // namespace topology_test
}  // namespace floes
