#pragma once
// Tows through fields without end, run and compared.

#include <gtest/gtest.h>

#include <algorithm>
#include <utility>
#include <vector>

#include "arrangement/arrangement.hpp"
#include "scenario/validate.hpp"
#include "simulation/simulation.hpp"

namespace floes {

inline Simulation tow(const Scenario& scenario, std::uint32_t number = 0) {
    LaidField laid = lay_field(scenario, 1, number);
    return {scenario, laid.laid(), std::move(laid.ahead)};
}

/// Runs both, of which one is longer, and expects the loads of the shorter to be the first of the longer, to the bit.
/// The longer is to come so far that floes take the places of others.
inline void expect_same_beginning(Simulation& shorter, Simulation& longer) {
    ASSERT_TRUE(shorter.run({}));
    ASSERT_TRUE(longer.run({}));
    std::vector<double> begin = longer.loads().surge;
    begin.resize(shorter.loads().surge.size());
    EXPECT_EQ(begin, shorter.loads().surge);
    EXPECT_GT(*std::ranges::max_element(begin), 1);
    EXPECT_GT(longer.ice().floes(), longer.ice().places()) << "floes are to have left";
}

}  // namespace floes
