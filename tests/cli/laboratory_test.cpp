// floes laboratory: the plate measures what the arguments request, in both directions.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <nlohmann/json.hpp>
#include <string>

#include "cli/verb_output.hpp"
#include "support/refusal.hpp"
#include "support/temporary_folder.hpp"

namespace floes {
namespace laboratory_test {

using nlohmann::json;

std::string plate(const std::string& arguments) {
    return verb_output(add_laboratory, "laboratory plate " + arguments);
}

TEST(LaboratoryPlate, MeasuresEveryCombination) {
    const json curve =
        json::parse(plate("--sheet-m 1.2 --element-m 0.3,0.4 --iterations 10,20 --cfm 0.016 --format json"))
            .at("curve");
    ASSERT_EQ(curve.size(), 4u);
    EXPECT_EQ(curve[1].at("element_m"), 0.3);
    EXPECT_EQ(curve[1].at("iterations"), 20);
    EXPECT_EQ(curve[2].at("element_m"), 0.4);
    EXPECT_GT(curve[1].at("elastic_modulus_MPa"), curve[0].at("elastic_modulus_MPa")) << "iterations make it stiffer";
}

TEST(LaboratoryPlate, LooksForTheCfmOfTheIceThatWasAskedFor) {
    const std::string ice = "--sheet-m 1.2 --element-m 0.3 --thickness-m 0.04 --iterations 30 --format json";
    const json found = json::parse(plate(ice + " --modulus-MPa 20"));
    for (const json& point : found.at("curve")) {
        EXPECT_EQ(point.at("element_m"), 0.3);
        EXPECT_EQ(point.at("thickness_m"), 0.04);
        EXPECT_EQ(point.at("iterations"), 30);
    }
    const json there = json::parse(plate(ice + " --cfm " + found.at("cfm").dump())).at("curve").at(0);
    EXPECT_NEAR(there.at("elastic_modulus_MPa").get<double>(), 20, 0.2);
}

TEST(LaboratoryPlate, RefusesToLookForTheCfmOfSeveralIces) {
    EXPECT_THAT(refusal([] { plate("--element-m 0.2,0.15 --iterations 50,100 --modulus-MPa 60"); }),
                testing::HasSubstr("the Σ of one ice, but the given lists make 4"));
    EXPECT_THROW(plate("--modulus-MPa 60 --cfm 0.016"), CommandLineEnd);
}

/// Configurations with an E, and with a Σ, that no default has.
class LaboratoryOfAConfiguration : public testing::Test {
  protected:
    LaboratoryOfAConfiguration() {
        std::ofstream(beams_) << "[joint]\nmodel = \"beam\"\n[ice]\nelastic_modulus_MPa = 500\n";
        std::ofstream(sigma_) << "general.solver = \"lanes\"\njoint.model = \"cfm\"\njoint.cfm = 0.05\n"
                                 "water.heave_damping_from = \"share\"\nwater.added_mass_from = \"share\"\n";
    }

    static json cantilever(const std::string& arguments) {
        return json::parse(verb_output(add_laboratory, "laboratory cantilever " + arguments + " --format json"))
            .at("rows");
    }

    TemporaryFolder folder_;
    std::string beams_ = folder_ / "beams.toml";
    std::string sigma_ = folder_ / "sigma.toml";
};

TEST_F(LaboratoryOfAConfiguration, BendsAPlateOfItsIce) {
    const json beams = json::parse(plate(beams_ + " --element-m 1.8 --format json")).at("curve");
    ASSERT_EQ(beams.size(), 1u);
    EXPECT_EQ(beams[0].at("joint_model"), "beam");
    EXPECT_EQ(beams[0].at("set_modulus_MPa"), 500);
    EXPECT_NEAR(beams[0].at("sheet_m").get<double>(), 5.4, 1e-9) << "the largest of its elements";
    const std::string small = " --sheet-m 1.2 --element-m 0.3 --thickness-m 0.04 --format json";
    const json sigma = json::parse(plate(sigma_ + small)).at("curve");
    ASSERT_EQ(sigma.size(), 1u);
    EXPECT_EQ(sigma[0].at("joint_model"), "cfm");
    EXPECT_EQ(sigma[0].at("cfm"), 0.05);
    EXPECT_EQ(json::parse(plate(beams_ + small + " --cfm 0.016,0.03")).at("curve").size(), 2u);
}

TEST_F(LaboratoryOfAConfiguration, BreaksABeamOfItsIce) {
    const json sigma = cantilever(sigma_ + " --elements 1 --load bending");
    ASSERT_EQ(sigma.size(), 1u);
    EXPECT_EQ(sigma[0].at("cfm"), 0.05);
    const json stiffness = cantilever(beams_ + " --stiffness --elements 2");
    ASSERT_EQ(stiffness.size(), 1u);
    EXPECT_EQ(stiffness[0].at("elastic_modulus_MPa"), 500);
    const json floating = cantilever(beams_ + " --floating --elements 2 --load bending");
    ASSERT_EQ(floating.size(), 1u);
    EXPECT_NEAR(floating[0].at("elastic_foundation_ratio").get<double>(), 1.0140, 1e-4) << "of 500 MPa";
}

// Without a configuration the joints that a campaign has by default are tested too, not only the paper's.
TEST(LaboratoryCantilever, TestsTheDefaultBeams) {
    const json found = json::parse(
        verb_output(add_laboratory, "laboratory cantilever --cfm 0.016 --elements 2 --load bending --format json"));
    const json& rows = found.at("rows");
    ASSERT_EQ(rows.size(), 2u);
    EXPECT_TRUE(rows[0].at("cfm").is_null());
    EXPECT_EQ(rows[1].at("cfm"), 0.016);
    for (const json& row : rows)
        EXPECT_NEAR(row.at("strength_kPa").get<double>() / row.at("set_kPa").get<double>(), 1, 0.35);
}

TEST(Laboratory, VerbsOf1_0AreRefusedWithTheirNewNames) {
    for (const auto& [words, now] : {std::pair{"calibrate table3.toml --modulus-MPa 60", "floes laboratory plate"},
                                     {"calibrate --help", "floes laboratory plate"},
                                     {"cantilever --floating", "floes laboratory cantilever"}}) {
        try {
            verb_output(add_laboratory, words);
            ADD_FAILURE() << words;
        } catch (const CommandLineEnd& end) {
            EXPECT_EQ(end.status(), 2);
            EXPECT_THAT(end.what(), testing::HasSubstr(now));
        }
    }
}

TEST(Laboratory, WantsATest) {
    EXPECT_THROW(verb_output(add_laboratory, "laboratory"), CommandLineEnd);
}

}  // namespace laboratory_test
}  // namespace floes
