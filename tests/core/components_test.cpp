#include "core/vector.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <utility>
#include <vector>

namespace floes {
namespace components_test {

using testing::ElementsAre;

std::vector<std::size_t> firsts(std::size_t nodes, const std::vector<std::pair<std::size_t, std::size_t>>& edges) {
    Components components(nodes);
    for (const auto& [a, b] : edges) components.connect(a, b);
    std::vector<std::size_t> result;
    for (std::size_t node = 0; node < nodes; ++node) result.push_back(components.first(node));
    return result;
}

TEST(Components, AreNamedByTheirSmallestNode) {
    EXPECT_THAT(firsts(3, {}), ElementsAre(0, 1, 2));
    EXPECT_THAT(firsts(3, {{0, 1}, {1, 2}}), ElementsAre(0, 0, 0));
    EXPECT_THAT(firsts(6, {{1, 2}, {4, 5}, {2, 5}}), ElementsAre(0, 1, 1, 3, 1, 1));
    EXPECT_THAT(firsts(4, {{2, 3}, {1, 3}, {0, 1}}), ElementsAre(0, 0, 0, 0));
    EXPECT_THAT(firsts(4, {{3, 2}, {3, 3}, {2, 3}}), ElementsAre(0, 1, 2, 2));
}

}  // namespace components_test
}  // namespace floes
