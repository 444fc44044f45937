// Words of a stop rule become settings of it.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "cli/until.hpp"
#include "support/refusal.hpp"

namespace floes {
namespace until_test {

using testing::ElementsAre;
using testing::HasSubstr;

TEST(Until, IsADesignValueInAnExposure) {
    const auto wanted = ElementsAre("stop.of=\"design_mooring_force\"", "stop.half_width_percent=15",
                                    "stop.exposure_h=3", "campaign.arrangements=1000");
    for (const char* text : {"mooring_force 3 h +- 15 %", "mooring_force 3h+-15%", "mooring_force in 3 h ± 15 %",
                             "  mooring_force 3 h +/- 15", "mooring_force in 3 h within 15 %"})
        EXPECT_THAT(until_settings(text), wanted) << text;
    EXPECT_THAT(until_settings("load +- 7.5 %"),
                ElementsAre("stop.of=\"design_load\"", "stop.half_width_percent=7.5", "campaign.arrangements=1000"));
}

TEST(Until, IsAMean) {
    EXPECT_THAT(
        until_settings("mean_surge_mooring +- 5 %"),
        ElementsAre("stop.of=\"mean_surge_mooring\"", "stop.half_width_percent=5", "campaign.arrangements=1000"));
    EXPECT_THAT(until_settings("mean_maximum_0.5s +- 5 %").front(), HasSubstr("mean_maximum_0.5s"));
}

TEST(Until, SaysWhatItTakes) {
    EXPECT_THAT(refusal([] { until_settings("mooring force, please"); }), HasSubstr("is not understood; write what"));
    EXPECT_THAT(refusal([] { until_settings("moor_force 3 h +- 15 %"); }),
                HasSubstr("moor_force is not known; take one of load, mooring_force, "));
    EXPECT_THAT(refusal([] { until_settings("mean_load 3 h +- 5 %"); }),
                HasSubstr("the mean of mean_load has no exposure; leave \"3 h\" out"));
}

}  // namespace until_test
}  // namespace floes
