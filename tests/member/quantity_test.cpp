// The list of quantities: its keys have one form, and each leads to its own place.

#include "member/quantity.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <string_view>

namespace floes {
namespace quantity_test {

TEST(Quantities, HaveKeysOfTheirOwnAndSayWhatTheyAre) {
    std::set<std::string_view> keys;
    for (const Quantity& one : quantities) {
        EXPECT_TRUE(keys.insert(one.key.view()).second) << one.key.view();
        EXPECT_FALSE(one.unit.empty()) << one.key.view();
        EXPECT_FALSE(one.long_name.empty()) << one.key.view();
        if (one.shown >= Shown::in_summary) {
            EXPECT_FALSE(one.label.empty()) << one.key.view();
        }
        if (one.in_designs || (one.stops && !one.of_moored)) {  // those stand in summarize --parts moored
            EXPECT_GE(one.shown, Shown::in_summary) << one.key.view();
        }
        EXPECT_LT(one.least, one.most) << one.key.view();
    }
}

// Written to one after another: two that shared a place would give one value.
TEST(Quantities, HavePlacesOfTheirOwn) {
    MemberOutputs outputs;
    double value = 1;
    for (const Quantity& one : quantities) one.place.set(outputs, value++);
    value = 1;
    for (const Quantity& one : quantities) EXPECT_EQ(one.of(outputs), value++) << one.key.view();
}

TEST(Quantities, AreFoundByKey) {
    EXPECT_EQ(find_quantity("sd_maximum"), &quantity("sd_maximum"));
    EXPECT_EQ(find_quantity("sd_maximum_"), nullptr);
    MemberOutputs outputs;
    outputs.load.mean = 3;
    EXPECT_EQ(quantity("mean_load").of(outputs), 3);
}

TEST(AveragedQuantities, FollowThoseThatTheyAreMadeFrom) {
    const std::vector<Quantity> all = quantities_with(std::vector{0.1, 2.0});
    EXPECT_EQ(all.size(), quantities.size() + 8);
    const auto place = std::ranges::find(all, "mean_maximum", [](const Quantity& one) { return one.key.view(); });
    const Quantity& short_time = place[1];
    EXPECT_EQ(short_time.key.view(), "mean_maximum_0.1s");
    EXPECT_EQ(short_time.label.view(), "mean maximum over 0.1 s");
    EXPECT_EQ(short_time.shown, Shown::in_pairs);
    EXPECT_TRUE(short_time.positive && short_time.in_designs && short_time.stops);
    EXPECT_EQ(place[2].key.view(), "mean_maximum_2s");
    std::set<std::string_view> keys;
    for (const Quantity& one : all) EXPECT_TRUE(keys.insert(one.key.view()).second) << one.key.view();
}

TEST(AveragedQuantities, AreOfTheirTimeAndNaNWhereItWasNotTaken) {
    MemberOutputs outputs;
    outputs.load.mean_maximum = 9;
    outputs.averaged = {{0.1, 1, {}, 2, 3}, {0.5, 4, {2, 8, 5}, 5, 6}};
    EXPECT_EQ(averaged_over(quantity("sd_load"), 0.1).of(outputs), 1);
    EXPECT_EQ(averaged_over(quantity("mean_maximum"), 0.5).of(outputs), 5);
    EXPECT_EQ(averaged_over(quantity("sd_maximum"), 0.5).of(outputs), 6);
    EXPECT_EQ(averaged_over(quantity("maximum_load"), 0.5).of(outputs), 8);
    EXPECT_TRUE(std::isnan(averaged_over(quantity("maximum_load"), 0.1).of(outputs)));
    EXPECT_TRUE(std::isnan(averaged_over(quantity("mean_maximum"), 1).of(outputs)));
}

TEST(AveragedQuantities, AreFoundByKey) {
    EXPECT_EQ(any_quantity("mean_load")->key.view(), "mean_load");
    EXPECT_EQ(any_quantity("mean_maximum_0.5s")->averaging, 0.5);
    for (const char* key :
         {"mean_load_0.5s", "mean_maximum_0.50s", "mean_maximum_0.5", "mean_maximum_s", "maximum_", "x"})
        EXPECT_FALSE(any_quantity(key)) << key;
}

TEST(Unmeasured, IsNaN) {
    const MemberOutputs outputs = unmeasured(2);
    for (const Quantity& one : quantities) EXPECT_TRUE(std::isnan(one.of(outputs))) << one.key.view();
    EXPECT_EQ(outputs.load.segment_maximum.size(), 2u);
    EXPECT_TRUE(std::isnan(outputs.load.segment_maximum[1]));
    EXPECT_FALSE(outputs.load.steady);
}

}  // namespace quantity_test
}  // namespace floes
