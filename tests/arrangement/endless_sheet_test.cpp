// The cells of level ice without end: a sheet without a seam, the same whatever was asked for before.

#include <gtest/gtest.h>

#include <map>
#include <vector>

#include "arrangement/endless_field.hpp"

namespace floes {
namespace endless_sheet_cells_test {

Scenario sheet() {
    Scenario scenario;
    scenario.arrangement.method = ArrangementMethod::level;
    scenario.field.floes = 1;
    scenario.field.concentration = 1;
    scenario.field.begin = 2;
    scenario.field.far_end = FarEnd::never;
    scenario.floe.breadth = 1.0;
    scenario.floe.element = 0.1;
    return scenario;
}

struct Laid {
    std::vector<SingleFloe> cells;
    std::vector<CutJoint> joints;
    double end = 0;
};

Laid laid(const Scenario& scenario, int parts, std::uint32_t number = 0) {
    EndlessSheet field(scenario, 1, number);
    Laid all;
    for (int i = 0; i < parts; ++i) {
        FieldPart part = field.next();
        all.end = part.end;
        all.cells.insert(all.cells.end(), part.floes.begin(), part.floes.end());
        all.joints.insert(all.joints.end(), part.joints.begin(), part.joints.end());
    }
    return all;
}

TEST(EndlessSheetCells, AreOthersForAnotherDraw) {
    Scenario scenario = sheet();
    const auto first = [&] { return laid(scenario, 1).cells.front().pose.x; };
    const double of_first_draw = first();
    EXPECT_EQ(first(), of_first_draw);
    scenario.elements.draw = 1;
    EXPECT_NE(first(), of_first_draw);
}

TEST(EndlessSheetCells, CoverTheSheetAndAreMuchAlike) {
    const Scenario scenario = sheet();
    const Laid all = laid(scenario, 20);
    double area = 0;
    for (const SingleFloe& cell : all.cells) {
        EXPECT_EQ(cell.pose.yaw, 0);
        ASSERT_EQ(cell.shape.cut().elements.size(), 1u);
        area += cell.shape.area();
        EXPECT_GT(cell.shape.area(), 0.5 * 0.01);
        EXPECT_LT(cell.shape.area(), 1.6 * 0.01);
        for (const Corner& corner : cell.shape.outline) {
            EXPECT_LE(std::abs(corner.z + cell.pose.z), scenario.floe.breadth / 2 + 1e-9);
            EXPECT_GE(corner.x + cell.pose.x, scenario.field.begin - 1e-9);
        }
    }
    EXPECT_NEAR(area / scenario.floe.breadth, all.end - scenario.field.begin, 0.03);
}

// Of a plane map of cells with three at each corner, V - E + F = 1: three joints a cell, less those of the rim.
TEST(EndlessSheetCells, AreJoinedToAllTheirNeighbours) {
    const Laid all = laid(sheet(), 20);
    std::map<int, int> joints;
    for (const CutJoint& one : all.joints) {
        EXPECT_GT(one.a, one.b);
        EXPECT_GT(one.span, 0.04);
        EXPECT_GT(one.length, 0.05 * 0.1);
        ++joints[one.a];
        ++joints[one.b];
        const SingleFloe& a = all.cells[static_cast<std::size_t>(one.a)];
        const SingleFloe& b = all.cells[static_cast<std::size_t>(one.b)];
        EXPECT_GT(dot(one.normal, Corner{b.pose.x - a.pose.x, b.pose.z - a.pose.z}), 0);
    }
    EXPECT_EQ(joints.size(), all.cells.size());
    const double mean = static_cast<double>(all.joints.size()) / static_cast<double>(all.cells.size());
    EXPECT_GT(mean, 2.5);
    EXPECT_LT(mean, 3.0);
}

TEST(EndlessSheetCells, AreEachArrangementsOwnAndKnowNothingOfWhatComesLater) {
    const Laid few = laid(sheet(), 3);
    const Laid many = laid(sheet(), 9);
    for (std::size_t i = 0; i < few.cells.size(); ++i) EXPECT_EQ(few.cells[i].shape, many.cells[i].shape);
    EXPECT_NE(laid(sheet(), 1, 1).cells.front().shape, few.cells.front().shape);
}

}  // namespace endless_sheet_cells_test
}  // namespace floes
