#include "findings/catalogue.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "findings/example.hpp"

namespace floes {
namespace piece_sizes_test {

TEST(IceSizes, AreSharesOfTheArea) {
    IceSizes sizes;
    EXPECT_TRUE(std::isnan(sizes.quantile(0.5)));
    sizes.add(0.36, 3);
    sizes.add(0.04, 2);
    EXPECT_DOUBLE_EQ(sizes.count(), 5);
    EXPECT_NEAR(sizes.area(), 1.16, 1e-12);
    EXPECT_NEAR(sizes.quantile(0.05), 0.2, 1e-9);
    EXPECT_NEAR(sizes.quantile(0.5), 0.6, 1e-9);
    ASSERT_EQ(sizes.steps().size(), 2u);
    EXPECT_NEAR(sizes.steps()[0].second, 0.08 / 1.16, 1e-12);
    EXPECT_DOUBLE_EQ(sizes.steps()[1].second, 1);
    sizes.add(0.04 + 1e-14, -2);  // as large but for rounding
    EXPECT_EQ(sizes.steps().size(), 1u);
}

FloeAreas alike(const std::vector<double>& areas) {
    return [areas](int) { return areas; };
}

/// E30 has four done members; of each one of two floes is in three pieces.
TEST(PieceSizes, TakeTheFloesThatCrackedAndAddTheirPieces) {
    const CampaignTable table = example::campaign();
    std::vector<PieceRow> pieces;
    for (std::size_t k = 0; k < table.members.size(); ++k) {
        if (!table.members[k].done() || table.members[k].case_index != 0) continue;
        for (const double area : {0.04, 0.12, 0.2}) pieces.push_back({static_cast<int>(k), 1, area});
    }
    ASSERT_EQ(pieces.size(), 12u);
    const std::vector<double> floes{1, 0.36};
    const auto found = find_piece_sizes(table, pieces, alike(floes));
    ASSERT_EQ(found.size(), 3u);
    EXPECT_EQ(found[0].runs, 4);
    EXPECT_DOUBLE_EQ(found[0].split, 1);
    EXPECT_DOUBLE_EQ(found[0].pieces, 3);
    EXPECT_NEAR(found[0].in_pieces, 0.36 / 1.36, 1e-9);
    EXPECT_DOUBLE_EQ(found[0].before.count(), 8);
    EXPECT_DOUBLE_EQ(found[0].after.count(), 16) << "a floe less and three pieces more in each";
    EXPECT_NEAR(found[0].after.area(), found[0].before.area(), 1e-9);
    EXPECT_NEAR(found[0].after.quantile(0.1), std::sqrt(0.12), 1e-6);
    EXPECT_DOUBLE_EQ(found[1].split, 0);
    EXPECT_DOUBLE_EQ(found[1].after.count(), found[1].before.count());
}

// Twelve parts of two floes came by; what is known of the sizes is one part.
TEST(PieceSizes, OfAFieldWithoutEndAreOfAllFloesThatCame) {
    CampaignTable table = example::campaign();
    for (MemberRow& member : table.members) member.floes_entered = 24;
    const std::vector<double> floes{1, 0.36};
    const auto found = find_piece_sizes(table, {}, alike(floes));
    EXPECT_DOUBLE_EQ(found[0].before.count(), 4 * 24);
    EXPECT_NEAR(found[0].before.area(), 4 * 12 * 1.36, 1e-6);
    EXPECT_NEAR(found[0].after.area(), found[0].before.area(), 1e-9);
}

// Cells of a Voronoi diagram are others in each arrangement, and a sum of pieces is its floe but for rounding.
TEST(PieceSizes, TakeFloesOfTheMembersOwn) {
    const CampaignTable table = example::campaign();
    const auto area = [](int member) { return 1000.0000000005 + member; };
    std::vector<PieceRow> pieces;
    for (std::size_t k = 0; k < table.members.size(); ++k) {
        const MemberRow& member = table.members[k];
        if (!member.done() || member.case_index != 0) continue;
        const int number = static_cast<int>(k);
        for (const double share : {0.3, 0.7}) pieces.push_back({number, 1, share * area(number) + 1e-9});
    }
    const auto found = find_piece_sizes(table, pieces, [&](int member) {
        return std::vector<double>{3.0, area(member)};
    });
    EXPECT_DOUBLE_EQ(found[0].before.count(), 8);
    EXPECT_DOUBLE_EQ(found[0].after.count(), 12) << "two pieces for one of two floes in each";
    EXPECT_NEAR(found[0].after.area(), found[0].before.area(), 1e-6);
}

TEST(PieceSizes, AreMissingWhereNothingBroke) {
    Evidence evidence = evidence_of({}, example::campaign());
    evidence.kept.set(std::vector<PieceRow>{});
    EXPECT_THAT(piece_sizes_section(evidence).missing, testing::HasSubstr("no floe is known to be in pieces"));
}

}  // namespace piece_sizes_test
}  // namespace floes
