// Fields without end of polygons: scattered ones beside those that lie, and the cells of one Voronoi diagram.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "arrangement/check.hpp"
#include "arrangement/crowd.hpp"
#include "arrangement/endless_field.hpp"
#include "arrangement/order.hpp"
#include "scattered_scenario.hpp"
#include "shapes/polygon.hpp"
#include "support/refusal.hpp"

namespace floes {
namespace endless_polygons_test {

Scenario endless(ShapeKind kind, double concentration = 0.75) {
    Scenario scenario = polygon_scenario(kind, concentration, 24);
    scenario.field.far_end = FarEnd::never;
    scenario.field.half_width = 1.25;
    return scenario;
}

struct Laid {
    std::vector<SingleFloe> floes;
    std::vector<double> ends;

    std::vector<Outline> outlines() const {
        std::vector<Outline> found;
        for (const SingleFloe& floe : floes) found.push_back(on_water(floe.shape.outline, floe.pose));
        return found;
    }
    double area() const {
        double sum = 0;
        for (const SingleFloe& floe : floes) sum += floe.shape.area();
        return sum;
    }
};

Laid laid(const Scenario& scenario, int parts, std::uint32_t number = 0) {
    LaidField field = lay_field(scenario, 1, number);
    Laid all;
    for (std::size_t i = 0; i < field.floes.size(); ++i)
        all.floes.push_back({field.floes.floes[i].pose, field.floes.shape(i), field.floes.material(i)});
    all.ends.push_back(field.ahead.end);
    for (int k = 1; k < parts; ++k) {
        const FieldPart part = field.ahead.next();
        EXPECT_EQ(part.floes.size(), static_cast<std::size_t>(scenario.field.floes)) << k;
        all.floes.insert(all.floes.end(), part.floes.begin(), part.floes.end());
        all.ends.push_back(part.end);
    }
    return all;
}

constexpr ShapeKind kinds[]{ShapeKind::polygon, ShapeKind::voronoi};

TEST(EndlessPolygons, PartsAreTheSameHoweverFarTheyAreLaid) {
    for (const ShapeKind kind : kinds) {
        const Laid three = laid(endless(kind), 3);
        const Laid six = laid(endless(kind), 6);
        for (std::size_t i = 0; i < three.floes.size(); ++i) {
            EXPECT_EQ(three.floes[i].pose.x, six.floes[i].pose.x);
            EXPECT_EQ(three.floes[i].pose.z, six.floes[i].pose.z);
            EXPECT_EQ(three.floes[i].pose.yaw, six.floes[i].pose.yaw);
            EXPECT_EQ(three.floes[i].shape.outline, six.floes[i].shape.outline);
        }
        EXPECT_NE(laid(endless(kind), 1, 1).floes[0].pose.z, three.floes[0].pose.z) << "another arrangement";
        std::set<Outline> outlines;
        for (const SingleFloe& floe : six.floes) outlines.insert(floe.shape.outline);
        EXPECT_EQ(outlines.size(), six.floes.size()) << "each part has polygons of its own";
    }
}

TEST(EndlessPolygons, KeepTheClearanceAcrossTheirSeams) {
    for (const ShapeKind kind : kinds) {
        const Scenario scenario = endless(kind);
        const std::vector<Outline> all = laid(scenario, 6).outlines();
        const double gap = scenario.arrangement.clearance - 1e-9;
        for (std::size_t i = 0; i < all.size(); ++i) {
            for (const Corner& corner : all[i]) {
                EXPECT_LE(std::abs(corner.z), scenario.field.half_width - gap);
                EXPECT_GE(corner.x, scenario.field.begin + gap);
            }
            for (std::size_t k = 0; k < i; ++k) EXPECT_GE(distance_between(all[i], all[k]), gap) << i << ' ' << k;
        }
    }
}

// As for rectangles (endless_field_test.cpp): eight strips from the end of one part to that of the next.
TEST(EndlessPolygons, CoverAsMuchAtTheirSeamsAsElsewhere) {
    constexpr int parts = 8, strips = 8;
    for (const auto& [kind, fields] : {std::pair(ShapeKind::polygon, 12), {ShapeKind::voronoi, 24}}) {
        const Scenario scenario = endless(kind);
        std::vector<std::vector<double>> found(strips);
        double length = 0, area = 0;
        for (int number = 0; number < fields; ++number) {
            const Laid all = laid(scenario, parts, static_cast<std::uint32_t>(number));
            const std::vector<Outline> outlines = all.outlines();
            for (std::size_t k = 0; k + 2 < all.ends.size(); ++k) {
                const double strip = (all.ends[k + 1] - all.ends[k]) / strips;
                for (std::size_t i = 0; i < strips; ++i)
                    found[i].push_back(
                        coverage({all.ends[k] + static_cast<double>(i) * strip, -1.25, strip, 2.5}, outlines));
            }
            length += all.ends.back() - scenario.field.begin;
            area += all.area();
        }
        for (std::size_t i = 0; i < found.size(); ++i) {
            EXPECT_LT(error_of_mean(found[i]), 0.012);
            EXPECT_NEAR(mean(found[i]), 0.75, 0.045) << "strip " << i;
        }
        EXPECT_NEAR(area / (length * 2.5), 0.75, 0.012);
    }
}

TEST(EndlessPolygons, OfMixedSizesKeepTheLawOfTheirSizes) {
    Scenario scenario = endless(ShapeKind::polygon, 0.7);
    scenario.field.floes = 30;
    scenario.sizes.law = SizeLaw::list;
    scenario.sizes.list = {{0.4, 0.4, 0.5}, {0.6, 0.6, 0.3}, {0.8, 0.4, 0.2}};
    int small = 0;
    for (const SingleFloe& floe : laid(scenario, 5).floes) small += floe.shape.area() < 0.2 ? 1 : 0;
    EXPECT_NEAR(small, 5 * 15, 6);  // those that wait beyond the last part are not counted
}

// The gaps of a part's cells leave the concentration of these cells, so that they cover it exactly in the long run.
TEST(EndlessPolygons, CellsCoverTheConcentrationAt90PercentToo) {
    const Scenario scenario = endless(ShapeKind::voronoi, 0.9);
    const Laid all = laid(scenario, 12);
    EXPECT_NEAR(all.area() / ((all.ends.back() - scenario.field.begin) * 2.5), 0.9, 0.01);
}

// Of points that are not relaxed some cells are narrower than the ice is thick.
TEST(EndlessPolygons, CellsTooNarrowToBeFloesAreOpenWater) {
    Scenario scenario = endless(ShapeKind::voronoi);
    scenario.shapes.relaxations = 0;
    scenario.floe.thickness = 0.1;
    const Laid all = laid(scenario, 12);
    EXPECT_EQ(all.floes.size(), 12u * 24u);
    for (const SingleFloe& floe : all.floes) EXPECT_GT(inner_radius(floe.shape.outline), 0.05);
    EXPECT_NEAR(all.area() / ((all.ends.back() - scenario.field.begin) * 2.5), 0.75, 0.02);
}

TEST(EndlessPolygons, GapsBelowTheClearanceAreASentence) {
    EXPECT_THAT(refusal([] { laid(endless(ShapeKind::voronoi, 0.999), 1); }),
                testing::HasSubstr("arrangement.clearance_m"));
}

TEST(EndlessPolygons, EachPartHasWeakFloesOfItsOwn) {
    Scenario scenario = endless(ShapeKind::voronoi);
    scenario.spread.weakened = 0.3;
    const Laid all = laid(scenario, 4);
    std::set<std::vector<bool>> which;
    for (std::size_t part = 0; part < 4; ++part) {
        std::vector<bool> weak;
        for (std::size_t i = 0; i < 24; ++i)
            weak.push_back(all.floes[24 * part + i].material.ice.bending_strength < scenario.ice.bending_strength);
        which.insert(weak);
    }
    EXPECT_EQ(which.size(), 4u);
}

/// A polygon that is fixed stays, and pushes the other as far as two that move part together.
TEST(Crowd, PushesOneFromOneThatIsFixed) {
    const std::vector<Outline> square{{{-0.2, -0.2}, {0.2, -0.2}, {0.2, 0.2}, {-0.2, 0.2}}};
    const std::vector<PlanarPose> at{{0.3, 0, 0}};
    const std::vector<PlanarPose> lies{{0, 0, 0}};
    Crowd crowd({-5, -5, 10, 10}, square, at, {square, lies});
    EXPECT_NEAR(crowd.deepest(), 0.1, 1e-12);
    EXPECT_NEAR(crowd.overlaps().front(), 0.1, 1e-12);
    crowd.sweep();
    EXPECT_EQ(crowd.deepest(), 0);
    ASSERT_EQ(crowd.poses().size(), 1u);
    EXPECT_NEAR(crowd.poses().front().x, 0.3 + 1.5 * 0.1, 1e-12);  // the overlap, over-relaxed
    EXPECT_NEAR(crowd.overlap_at(0, {0.1, 0, 0}), 0.3, 1e-12);     // with what lies
}

}  // namespace endless_polygons_test
}  // namespace floes
