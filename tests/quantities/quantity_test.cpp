// The list of quantities: its keys have one form, and each leads to its own place.

#include "quantities/quantity.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <set>
#include <string_view>

namespace floes {
namespace {

TEST(Quantities, HaveKeysOfTheirOwnAndSayWhatTheyAre) {
    std::set<std::string_view> keys;
    for (const Quantity& one : quantities) {
        EXPECT_TRUE(keys.insert(one.key).second) << one.key;
        EXPECT_FALSE(one.unit.empty()) << one.key;
        EXPECT_FALSE(one.long_name.empty()) << one.key;
        if (one.shown >= Shown::in_summary) {
            EXPECT_FALSE(one.name.empty() || one.label.empty()) << one.key;
        }
        if (one.in_designs || one.stops) {
            EXPECT_GE(one.shown, Shown::in_summary) << one.key;
        }
        EXPECT_LT(one.least, one.most) << one.key;
    }
}

// Written to one after another: two that shared a place would give one value.
TEST(Quantities, HavePlacesOfTheirOwn) {
    MemberOutputs outputs;
    double value = 1;
    for (const Quantity& one : quantities) one.place.set(outputs, value++);
    value = 1;
    for (const Quantity& one : quantities) EXPECT_EQ(one.of(outputs), value++) << one.key;
}

TEST(Quantities, AreFoundByKey) {
    EXPECT_EQ(find_quantity("sd_maximum"), &quantity("sd_maximum"));
    EXPECT_EQ(find_quantity("sd_maximum_"), nullptr);
    MemberOutputs outputs;
    outputs.load.mean = 3;
    EXPECT_EQ(quantity("mean_load").of(outputs), 3);
}

TEST(Unmeasured, IsNaNAndCountsNothing) {
    const MemberOutputs outputs = unmeasured(2);
    for (const Quantity& one : quantities) {
        if (one.count)
            EXPECT_EQ(one.of(outputs), 0) << one.key;
        else
            EXPECT_TRUE(std::isnan(one.of(outputs))) << one.key;
    }
    EXPECT_EQ(outputs.load.segment_maximum.size(), 2u);
    EXPECT_TRUE(std::isnan(outputs.load.segment_maximum[1]));
    EXPECT_FALSE(outputs.load.steady);
}

}  // namespace
}  // namespace floes
