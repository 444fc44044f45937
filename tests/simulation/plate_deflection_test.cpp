#include "simulation/laboratory.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

#include "support/froude.hpp"
#include "support/refusal.hpp"
#include "support/sweeping_scenario.hpp"

namespace floes {
namespace plate_deflection_test {

Scenario paper_plate(double cfm) {
    Scenario scenario = sweeping_scenario();
    scenario.floe.thickness = 0.030;
    scenario.joint.cfm = cfm;
    return scenario;
}

// A sheet of 2.6 m is small against the 1.9 m (five characteristic lengths) on which the load acts, so it reads
// somewhat softer than one of 5.4 m; the full figure is docs/fracture.md.
TEST(PlateDeflection, ASmallSheetReadsThePapersModulus) {
    const PlateDeflection at_60 = measure_plate_deflection(paper_plate(0.016), {.sheet = 2.6});
    EXPECT_NEAR(at_60.elastic_modulus, 60e6, 0.10 * 60e6);
    const PlateDeflection at_30 = measure_plate_deflection(paper_plate(0.03), {.sheet = 2.6});
    EXPECT_NEAR(at_30.elastic_modulus, 30e6, 0.10 * 30e6);
}

TEST(PlateDeflection, IsLinearInTheLoad) {
    const PlateDeflection result = measure_plate_deflection(paper_plate(0.016), {.sheet = 2.6});
    ASSERT_EQ(result.load.size(), 3u);
    for (std::size_t i = 0; i < 3; ++i)
        EXPECT_NEAR(result.load[i] / result.deflection[i], result.slope, 1e-3 * result.slope);
}

TEST(PlateDeflection, EvenAndOddSheetsAgree) {
    const double odd = measure_plate_deflection(paper_plate(0.016), {.sheet = 2.6}).elastic_modulus;
    const double even = measure_plate_deflection(paper_plate(0.016), {.sheet = 2.8}).elastic_modulus;
    EXPECT_NEAR(even / odd, 1, 0.15);
}

// Of a power of 4 to the bit: support/froude.hpp. Without a load the sheet stays where it is but for rounding, and that
// counts as settled at every size.
TEST(PlateDeflection, IsTheSameTestAtAnySize) {
    const Scenario scenario = sweeping_scenario();
    PlateTest test = plate_test_for(scenario);
    EXPECT_EQ(test.sheet, 5.4);
    EXPECT_EQ(test.load, 3);
    test.sheet = 2.6;
    const PlateDeflection tank = measure_plate_deflection(scenario, test);
    for (const double s : {1.0 / 16, 16.0, 256.0}) {
        const Scenario other = test::scaled(scenario, s);
        PlateTest there = plate_test_for(other);
        EXPECT_EQ(there.sheet, s * 5.4);
        there.sheet = s * test.sheet;
        EXPECT_EQ(measure_plate_deflection(other, there).elastic_modulus, s * tank.elastic_modulus) << s;
    }
}

std::string message_of(const Scenario& scenario, const PlateTest& test) {
    return refusal_or("", [&] { measure_plate_deflection(scenario, test); });
}

// Bullet's solver cannot hold the contact law of the defaults, and in a plate test nothing touches. It solves the
// joints one after the other as ours does, in another order.
TEST(PlateDeflection, IsOfTheIceWhateverSolverACaseHas) {
    Scenario scenario = paper_plate(0.016);
    const double lanes = measure_plate_deflection(plate_scenario(scenario), {.sheet = 2.6}).elastic_modulus;
    scenario.general.solver = SolverKind::stock;
    scenario.contact = with_preset(scenario.contact, ContactPreset::paper);
    const double stock = measure_plate_deflection(plate_scenario(scenario), {.sheet = 2.6}).elastic_modulus;
    EXPECT_NEAR(stock / lanes, 1, 0.05);
}

// Beams have ν of the ice; narrow ones none, where the plate of 0.3 would read 9 % too little.
TEST(PlateDeflection, ReadsBeamsByTheirOwnPoissonRatio) {
    const auto read = [](double ratio) {
        Scenario scenario;
        scenario.ice.poisson_ratio = ratio;
        return measure_plate_deflection(plate_scenario(scenario), {.sheet = 2.6}).elastic_modulus;
    };
    EXPECT_NEAR(read(0) / read(0.3), 1, 0.04);
}

TEST(PlateDeflection, RefusesWithAReason) {
    EXPECT_NE(message_of(paper_plate(0.016), {.sheet = 2.7}).find("13.5 elements"), std::string::npos);
    Scenario weak = paper_plate(0.016);
    weak.ice.bending_strength = 100;
    EXPECT_NE(message_of(weak, {.sheet = 1.0}).find("breaks the sheet"), std::string::npos);
    EXPECT_NE(message_of(paper_plate(0.1), {.sheet = 0.6, .load = 9}).find("sinks"), std::string::npos);
    EXPECT_NE(message_of(paper_plate(0.016), {.load = 0}).find("above 0 N"), std::string::npos);
}

TEST(PlateDeflection, NamesTheSheetsThatCanBeTested) {
    const auto told = [](double sheet) {
        return refusal([&] { measure_plate_deflection(sweeping_scenario(), {.sheet = sheet}); });
    };
    EXPECT_THAT(told(0.1), testing::EndsWith("Try 0.4 m."));
    EXPECT_THAT(told(0.5), testing::EndsWith("Try 0.4 m or 0.6 m."));
}

}  // namespace plate_deflection_test
}  // namespace floes
