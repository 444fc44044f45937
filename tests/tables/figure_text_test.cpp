// Figures as characters: every sign stands where the axes say.

#include "tables/figure_text.hpp"

#include <gmock/gmock.h>

#include <sstream>
#include <string>
#include <vector>

#include "tables/table.hpp"

namespace floes {
namespace figure_text_test {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::Not;

/// 20 m x 8 m, of which a character of a picture 10 wide is 2 m x 4 m.
Figure plan() {
    Figure figure{.x = {"m", 0, 20}, .y = {.label = "m", .low = -4, .high = 4, .downwards = true}};
    figure.area({{0, -4}, {4, -4}, {4, 0}, {0, 0}}, "structure");
    figure.area({{8, 0}, {12, 0}, {12, 4}, {8, 4}}, "ice");
    figure.cross(19, 3, "c3 thick");
    return figure;
}

std::vector<std::string> lines_of(const std::string& text) {
    std::istringstream in(text);
    std::vector<std::string> lines;
    for (std::string line; std::getline(in, line);) lines.push_back(line);
    return lines;
}

TEST(FigureText, PutsSignsWhereTheAxesSay) {
    EXPECT_THAT(lines_of(figure_text(plan(), 10, 10, Letters::ascii)),
                ElementsAre("##", "    oo   x", "|| 2 m", "# hull  o ice  x anchor"));
    EXPECT_THAT(lines_of(figure_text(plan(), 10, 10, Letters::unicode)),
                ElementsAre("██", "    ⣿⣿   ×", "┴┴ 2 m", "█ hull  ⣿ ice  × anchor"));
}

TEST(FigureText, StartsFromBelowWhereValuesGrowUp) {
    Figure figure = plan();
    figure.y.downwards = false;
    EXPECT_THAT(lines_of(figure_text(figure, 10, 10, Letters::ascii)),
                ElementsAre("    oo   x", "##", "|| 2 m", "# hull  o ice  x anchor"));
}

TEST(FigureText, KeepsFloesThatTouchApart) {
    Figure figure{.x = {"m", 0, 8}, .y = {.label = "m", .low = 0, .high = 4, .downwards = true}};
    figure.area({{0, 0}, {4, 0}, {4, 4}, {0, 4}}, "ice");
    figure.area({{4, 0}, {8, 0}, {8, 4}, {4, 4}}, "ice");
    EXPECT_EQ(lines_of(figure_text(figure, 4, 9, Letters::unicode)).front(), "⣿⡇⣿⣿");
}

TEST(FigureText, IsNeitherWiderNorHigherThanAskedFor) {
    for (const auto& [columns, rows] : {std::pair{7, 40}, {200, 3}, {40, 1}}) {
        const std::vector<std::string> lines = lines_of(figure_text(plan(), columns, rows, Letters::unicode));
        EXPECT_LE(std::ssize(lines), rows + 2);
        for (std::size_t k = 0; k + 2 < lines.size(); ++k)
            EXPECT_LE(text_width(lines[k]), static_cast<std::size_t>(columns));
    }
}

TEST(FigureText, DrawsTheWayOverTheIceAndNothingBeyondTheAxes) {
    Figure figure = plan();
    figure.line({{-50, 2}, {10, 2}}, "c0");
    figure.line({{10, 2}, {500, 2}}, "c1 thick");
    figure.line({{0, -2}, {20, -2}}, "dashed");
    EXPECT_THAT(lines_of(figure_text(figure, 10, 10, Letters::ascii)),
                ElementsAre("##", "-----=====", "|| 2 m", "# hull  o ice  - way  = measured"));
}

}  // namespace figure_text_test
}  // namespace floes
