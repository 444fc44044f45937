// floes hybrid: the paper's case without a configuration, another with one.

#include <gtest/gtest.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <string>

#include "cli/verb_output.hpp"
#include "core/error.hpp"

namespace floes {
namespace hybrid_test {

std::string hybrid(const std::string& arguments) {
    return verb_output(add_hybrid, "hybrid " + arguments);
}

nlohmann::json row_at(const nlohmann::json& answer, double modulus) {
    for (const auto& row : answer.at("rows")) {
        if (row.at("elastic_modulus_MPa") == modulus) return row;
    }
    ADD_FAILURE() << "no row at " << modulus << " MPa in " << answer;
    return {};
}

TEST(Hybrid, AnswersForThePapersCase) {
    const nlohmann::json answer = nlohmann::json::parse(hybrid("--format json"));
    EXPECT_NEAR(answer.at("crossing_MPa").get<double>(), 10, 1e-9);
    EXPECT_NEAR(answer.at("wall_deg").get<double>(), 45, 1e-9);
    EXPECT_NEAR(row_at(answer, 30).at("limit_stress").get<double>(), 55.7, 0.05);
    EXPECT_NEAR(row_at(answer, 60).at("limit_stress").get<double>(), 50.6, 0.05);
    EXPECT_NEAR(row_at(answer, 200).at("limit_stress").get<double>(), 45.1, 0.05);
    EXPECT_NEAR(row_at(answer, 60).at("characteristic_length").get<double>(), 0.377, 5e-4);
    for (const auto& row : answer.at("rows")) {
        EXPECT_EQ(row.at("hybrid").get<double>(),
                  std::min(row.at("limit_stress").get<double>(), row.at("limit_momentum").get<double>()));
    }
}

TEST(Hybrid, TakesStructureAndIceFromAConfiguration) {
    const std::string table3 = std::string(FLOES_SOURCE_DIR) + "/configs/table3.toml";
    const auto at_60 = [](const std::string& arguments) {
        return row_at(nlohmann::json::parse(hybrid(arguments + " --format json")), 60);
    };
    EXPECT_EQ(at_60(table3), at_60(""));
    EXPECT_NEAR(at_60(table3 + " --set ice.bending_strength_kPa=72.8").at("bending").get<double>(),
                2 * at_60("").at("bending").get<double>(), 1e-9);
    EXPECT_THROW(hybrid(table3 + " --set structure.profile_m=[[-0.443,0.614],[0.122,0.614]]"), InputError);
}

TEST(Hybrid, TakesCoefficients) {
    const nlohmann::json answer = nlohmann::json::parse(hybrid("--kpr 0.01,0,0 --modulus-MPa 60 --format json"));
    EXPECT_TRUE(answer.at("crossing_MPa").is_null());
    EXPECT_EQ(answer.at("rows").size(), 1u);
    EXPECT_THROW(hybrid("--kpr 0.01,0,0 --crossing-MPa 20"), CommandLineEnd);
}

TEST(Hybrid, PrintsATable) {
    const std::string table = hybrid("--modulus-MPa 60");
    EXPECT_NE(table.find("60       0.377     50.6           26.1          12.2              12.3     68.3    50.6"),
              std::string::npos)
        << table;
    EXPECT_NE(table.find("floes break above 10 MPa"), std::string::npos);
    // Loads of millions of N in kN, to whole numbers.
    const std::string large = hybrid(std::string(FLOES_SOURCE_DIR) + "/configs/full_scale.toml --modulus-MPa 60");
    EXPECT_NE(large.find("R_LS, kN"), std::string::npos) << large;
    EXPECT_EQ(large.find(".0 "), std::string::npos) << large;
}

TEST(Hybrid, SaysWhichCaseItTookAndThatItsStrengthIsOfTheSea) {
    std::string table3 = hybrid(std::string(FLOES_SOURCE_DIR) + "/configs/table3.toml --modulus-MPa 60");
    std::ranges::replace(table3, '\n', ' ');  // where a line ends depends on the folder
    EXPECT_NE(table3.find("the first of the 3 cases of "), std::string::npos) << table3;
    EXPECT_NE(table3.find("C_R is of sea ice at full scale, and ice.compressive_strength_kPa = "), std::string::npos);
    EXPECT_EQ(hybrid("--modulus-MPa 60 --crushing-MPa 0.2").find("at full scale, and"), std::string::npos);
}

// OpenFAST's IceFloe prints these figures for its example (modules/icefloe/test/GLA_proto_flex_ISO.log).
TEST(Hybrid, HasIsosLevelIceOfAConfiguration) {
    const std::string example = std::string(FLOES_SOURCE_DIR) +
                                "/configs/full_scale.toml --set structure.profile_m=[[-2,2],[0,2.5],[1.7320508,3.5]] "
                                "--set ice.bending_strength_kPa=700 --set ice.density_kg_m3=916.2 "
                                "--set water.density_kg_m3=999.8 --set contact.ice_structure_friction=0.15 "
                                "--rubble-ice-friction 0.05 --modulus-MPa 8000 --format json";
    const nlohmann::json answer = nlohmann::json::parse(hybrid(example));
    const nlohmann::json& row = answer.at("sloping").at("rows").at(0);
    EXPECT_NEAR(row.at("load").get<double>(), 2.65997e6, 20);
    EXPECT_NEAR(row.at("lifting").get<double>(), 209678, 1);
    EXPECT_NEAR(answer.at("crushing").at("load").get<double>(), 8.50271e6, 5);
    EXPECT_EQ(answer.at("sloping").at("rubble").at("height"), 3.0);
}

TEST(Hybrid, RefusesRubbleThatIsNone) {
    EXPECT_THROW(hybrid("--rubble-deg 50"), InputError);  // steeper than the wall of 45°
    EXPECT_THROW(hybrid("--rubble-m -1"), InputError);
    EXPECT_THROW(hybrid("--rubble-porosity 1"), InputError);
    EXPECT_THROW(hybrid("--crushing-MPa 0"), CommandLineEnd);
    EXPECT_EQ(nlohmann::json::parse(hybrid("--rubble-m 0 --format json")).at("sloping").at("rubble").at("height"), 0);
    // No load of bending in ice as soft as this: a sentence in place of the table, the rest stands.
    EXPECT_NE(hybrid(std::string(FLOES_SOURCE_DIR) + "/configs/full_scale.toml --modulus-MPa 0.001")
                  .find("ISO's formula has no load"),
              std::string::npos);
}

}  // namespace hybrid_test
}  // namespace floes
