// floes calibrate: it measures what the arguments request, in both directions.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <string>

#include "cli/verb_output.hpp"
#include "support/refusal.hpp"

namespace floes {
namespace {

using nlohmann::json;

std::string calibrate(const std::string& arguments) {
    return verb_output(add_calibrate, "calibrate " + arguments);
}

TEST(Calibrate, MeasuresEveryCombination) {
    const json curve =
        json::parse(calibrate("--sheet-m 1.2 --element-m 0.3,0.4 --iterations 10,20 --cfm 0.016 --format json"))
            .at("curve");
    ASSERT_EQ(curve.size(), 4u);
    EXPECT_EQ(curve[1].at("element_m"), 0.3);
    EXPECT_EQ(curve[1].at("iterations"), 20);
    EXPECT_EQ(curve[2].at("element_m"), 0.4);
    EXPECT_GT(curve[1].at("elastic_modulus_MPa"), curve[0].at("elastic_modulus_MPa")) << "iterations make it stiffer";
}

TEST(Calibrate, LooksForTheCfmOfTheIceThatWasAskedFor) {
    const std::string ice = "--sheet-m 1.2 --element-m 0.3 --thickness-m 0.04 --iterations 30 --format json";
    const json found = json::parse(calibrate(ice + " --modulus-MPa 20"));
    for (const json& point : found.at("curve")) {
        EXPECT_EQ(point.at("element_m"), 0.3);
        EXPECT_EQ(point.at("thickness_m"), 0.04);
        EXPECT_EQ(point.at("iterations"), 30);
    }
    const json there = json::parse(calibrate(ice + " --cfm " + found.at("cfm").dump())).at("curve").at(0);
    EXPECT_NEAR(there.at("elastic_modulus_MPa").get<double>(), 20, 0.2);
}

TEST(Calibrate, RefusesToLookForTheCfmOfSeveralIces) {
    EXPECT_THAT(refusal([] { calibrate("--element-m 0.2,0.15 --iterations 50,100 --modulus-MPa 60"); }),
                testing::HasSubstr("the Σ of one ice, but the given lists make 4"));
    EXPECT_THROW(calibrate("--modulus-MPa 60 --cfm 0.016"), CommandLineEnd);
}

}  // namespace
}  // namespace floes
