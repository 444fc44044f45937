// A field without end: no gap and no overlap where its parts meet, and each part the same however far it is laid.

#include "arrangement/endless_field.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "arrangement/crowd.hpp"
#include "scattered_scenario.hpp"

namespace floes {
namespace endless_field_test {

Scenario narrow(int floes = 24) {
    Scenario scenario = scattered_scenario();
    scenario.field.far_end = FarEnd::never;
    scenario.field.floes = floes;
    scenario.field.half_width = 1.25;
    return scenario;
}

struct Laid {
    std::vector<SingleFloe> floes;
    std::vector<double> ends;
};

Laid laid(const Scenario& scenario, int parts, std::uint32_t number = 0) {
    EndlessField field(scenario, 1, number, geometry_key(scenario));
    Laid all;
    for (int k = 0; k < parts; ++k) {
        const FieldPart part = field.next();
        EXPECT_EQ(part.floes.size(), static_cast<std::size_t>(scenario.field.floes)) << k;
        all.floes.insert(all.floes.end(), part.floes.begin(), part.floes.end());
        all.ends.push_back(part.end);
    }
    return all;
}

TurnedRectangle outline(const SingleFloe& floe, double margin) {
    const Rectangle shape{0.5 * floe.shape.length, 0.5 * floe.shape.breadth};
    return {shape.grown(margin), turn_of(floe.pose.yaw)};
}

/// Share of a field of this breadth that floes cover within `half` m of x, by points.
double covered(const std::vector<SingleFloe>& floes, double x, double half, double breadth) {
    constexpr int along = 10, across = 60;
    int hits = 0;
    for (int i = 0; i < along; ++i) {
        for (int k = 0; k < across; ++k) {
            const Vec2 at(x + half * (2 * (i + 0.5) / along - 1), breadth * ((k + 0.5) / across - 0.5));
            hits += std::ranges::any_of(floes, [&](const SingleFloe& floe) {
                return overlap(outline(floe, 0), {{0, 0}, turn_of(0)}, at.x() - floe.pose.x, at.y() - floe.pose.z);
            });
        }
    }
    return static_cast<double>(hits) / (along * across);
}

void expect_apart(const Scenario& scenario, const Laid& all) {
    const double margin = 0.5 * (scenario.arrangement.clearance - 1e-9);
    for (std::size_t i = 0; i < all.floes.size(); ++i) {
        const TurnedRectangle one = outline(all.floes[i], margin);
        EXPECT_LE(std::abs(all.floes[i].pose.z) + extent(one.shape, one.turn).z, scenario.field.half_width + 1e-9);
        EXPECT_GE(all.floes[i].pose.x - extent(one.shape, one.turn).x, scenario.field.begin - 1e-9);
        for (std::size_t k = 0; k < i; ++k)
            EXPECT_FALSE(overlap(one, outline(all.floes[k], margin), all.floes[k].pose.x - all.floes[i].pose.x,
                                 all.floes[k].pose.z - all.floes[i].pose.z))
                << i << ' ' << k;
    }
}

TEST(EndlessField, ItsPartsAreTheSameHoweverFarItIsLaid) {
    const Laid three = laid(narrow(), 3);
    const Laid six = laid(narrow(), 6);
    for (std::size_t i = 0; i < three.floes.size(); ++i) {
        EXPECT_EQ(three.floes[i].pose.x, six.floes[i].pose.x);
        EXPECT_EQ(three.floes[i].pose.z, six.floes[i].pose.z);
        EXPECT_EQ(three.floes[i].pose.yaw, six.floes[i].pose.yaw);
    }
    EXPECT_NE(laid(narrow(), 1, 1).floes[0].pose.z, three.floes[0].pose.z) << "another arrangement";
}

TEST(EndlessField, FloesKeepTheClearanceAcrossItsSeams) {
    expect_apart(narrow(), laid(narrow(), 6));
}

TEST(EndlessField, FloesOfMixedSizesDoToo) {
    Scenario scenario = narrow(30);
    scenario.sizes.law = SizeLaw::list;
    scenario.sizes.list = {{0.4, 0.4, 0.5}, {0.6, 0.6, 0.3}, {0.8, 0.4, 0.2}};
    const Laid all = laid(scenario, 6);
    expect_apart(scenario, all);
    std::map<double, int> count;
    for (const SingleFloe& floe : all.floes) ++count[floe.shape.length];
    // Those that wait beyond the last part are not counted: a third of a part at most.
    EXPECT_NEAR(count[0.4], 6 * 15, 6);
    EXPECT_NEAR(count[0.6], 6 * 9, 6);
    EXPECT_NEAR(count[0.8], 6 * 6, 6);
}

// From the end of one part to the next, in eight strips: each is covered as the field is to be, within a twentieth. The
// wall that the floes of a part were packed against lies in one of them, the floes that stayed end at the first. With
// all that waits thrown again the seam has 66 %, with nothing of it 79 % before the wall and 69 % behind it.
TEST(EndlessField, CoversAsMuchAtItsSeamsAsElsewhere) {
    constexpr int fields = 24, parts = 8, strips = 8;
    const Scenario scenario = narrow();
    std::vector<std::vector<double>> found(strips);
    double length = 0;
    for (std::uint32_t number = 0; number < fields; ++number) {
        const Laid all = laid(scenario, parts, number);
        for (std::size_t k = 0; k + 2 < all.ends.size(); ++k) {
            const double strip = (all.ends[k + 1] - all.ends[k]) / strips;
            for (int i = 0; i < strips; ++i)
                found[static_cast<std::size_t>(i)].push_back(
                    covered(all.floes, all.ends[k] + (i + 0.5) * strip, 0.5 * strip, 2.5));
        }
        length += all.ends.back() - scenario.field.begin;
    }
    for (std::size_t i = 0; i < found.size(); ++i) {
        EXPECT_LT(error_of_mean(found[i]), 0.01);
        EXPECT_NEAR(mean(found[i]), 0.75, 0.04) << "strip " << i;
    }
    EXPECT_NEAR(fields * parts * scenario.field.floes * 0.36 / (length * 2.5), 0.75, 0.01);
}

}  // namespace endless_field_test
}  // namespace floes
