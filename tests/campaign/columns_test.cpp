// Floes that differ, from a file of poses or from the configuration itself.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "campaign/campaign.hpp"
#include "campaign/read.hpp"
#include "campaign/write.hpp"
#include "core/error.hpp"
#include "scenario/floes.hpp"
#include "support/refusal.hpp"

namespace floes {
namespace columns_test {

using ::testing::HasSubstr;

/// The text of the file stands in its name.
std::string load_text(const std::string& path) {
    return path.substr(path.find("x_m"));
}

Campaign with_rows(const std::string& header, const std::string& rows, const std::string& more = "") {
    const std::string text = "[arrangement]\nmethod = \"file\"\nfile = \"\"\"" + header + "\n" + rows +
                             "\"\"\"\n[field]\nfloes = 2\nconcentration_percent = 1\n[structure]\nspeed_m_s = 0.05\n" +
                             more;
    return read_campaign({text, "a.toml", {}, true}, load_text);
}

std::string message(const std::string& header, const std::string& rows, const std::string& more = "") {
    return refusal([&] { with_rows(header, rows, more); });
}

const char* const header = "x_m,z_m,yaw_deg,floe.length_m,floe.breadth_m,ice.thickness_m,ice.bending_strength_kPa";
const char* const two = "7.4,0,0,0.8,0.4,0.04,50\n18.6,1.5,90,0.6,0.6,0.03,60\n";

TEST(Columns, GiveEachFloeItsOwnShapeAndIce) {
    const Scenario scenario = with_rows(header, two).cases.at(0).scenario;
    const FloeSet floes = floes_of(scenario);
    ASSERT_EQ(floes.size(), 2u);
    EXPECT_EQ(floes.shape(0), (FloeShape{0.8, 0.4, 0.04, 0.2, {}, 0}));
    EXPECT_EQ(floes.shape(1), (FloeShape{0.6, 0.6, 0.03, 0.2, {}, 1}));
    EXPECT_EQ(floes.material(0).ice.bending_strength, 50e3);
    EXPECT_EQ(floes.material(1).ice.bending_strength, 60e3);
    EXPECT_EQ(floes.material(1).ice.density, scenario.ice.density);
    EXPECT_DOUBLE_EQ(floes.floes[1].pose.yaw, std::acos(-1) / 2);
    EXPECT_EQ(element_count(floes), 4 * 2 + 3 * 3);
}

TEST(Columns, OfTheConfigurationAreThoseOfAFile) {
    const Campaign campaign = with_rows(header, two);
    const Campaign again = read_campaign({write_campaign(campaign), "b.toml", {}, true}, load_text);
    const FloeSet first = floes_of(campaign.cases.at(0).scenario);
    const FloeSet second = floes_of(again.cases.at(0).scenario);
    EXPECT_EQ(first.shapes, second.shapes);
    EXPECT_EQ(first.materials, second.materials);
}

TEST(Columns, GiveTheFieldItsLength) {
    const auto length = [](const std::string& rows) {
        return with_rows(header, rows).cases.at(0).scenario.field_length();
    };
    const double area = 0.8 * 0.4 + 0.6 * 0.6;
    EXPECT_NEAR(length("7.4,0,0,1.6,0.4,0.04,50\n18.6,1.5,90,0.6,0.6,0.03,60\n") / length(two), (area + 0.32) / area,
                1e-9);
}

TEST(Columns, ArePropertiesOfFloesAndNothingElse) {
    EXPECT_THAT(message("x_m,z_m,yaw_deg,floe.width_m", "7.4,0,0,1\n"), HasSubstr("width_m"));
    EXPECT_THAT(message("x_m,z_m,yaw_deg,floe.length_m,floe.length_m", "7.4,0,0,1,1\n"),
                HasSubstr("the column floe.length_m is there twice"));
    EXPECT_THAT(message("x_m,z_m,yaw_deg,joint.model", "7.4,0,0,1\n"), HasSubstr("model"));
    EXPECT_THAT(message("x_m,z_m,yaw_deg,,floe.length_m", "7.4,0,0,1,1\n"), HasSubstr("column 4 has no name"));
}

TEST(Columns, HoldANumberInItsRangeForEachFloe) {
    EXPECT_THAT(message("x_m,z_m,yaw_deg,floe.length_m", "7.4,0,0,1\n7,0,0\n"), HasSubstr(":3"));
    EXPECT_THAT(message("x_m,z_m,yaw_deg,ice.thickness_m", "7.4,0,0,0.03\n18.6,1.5,0,-1\n"), HasSubstr("thickness_m"));
    EXPECT_THAT(
        message("x_m,z_m,yaw_deg,floe.length_m", "7.4,0,0,0.6\n18.6,1.5,0,0.7\n", "[floe]\nelements = \"squares\"\n"),
        HasSubstr("floe 1: floe.element_m = 0.2 does not divide floe.length_m = 0.7"));
    EXPECT_THAT(message("x_m,z_m,yaw_deg,ice.density_kg_m3", "7.4,0,0,900\n18.6,1.5,0,1100\n"), HasSubstr("sinks"));
}

TEST(Columns, AllFloesTogetherAreNotTooManyElements) {
    EXPECT_THAT(message("x_m,z_m,yaw_deg,floe.element_m", "7.4,0,0,0.2\n18.6,1.5,0,0.0001\n"),
                HasSubstr("3.6e+07 elements"));
    // The table's own element is not that of any floe.
    EXPECT_NO_THROW(
        with_rows("x_m,z_m,yaw_deg,floe.element_m", "7.4,0,0,0.2\n18.6,1.5,0,0.2\n", "[floe]\nelement_m = 0.0001\n"));
}

}  // namespace columns_test
}  // namespace floes
