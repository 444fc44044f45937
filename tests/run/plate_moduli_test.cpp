#include "run/calibrate.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <sstream>

#include "run/fakes.hpp"
#include "simulation/laboratory.hpp"
#include "support/refusal.hpp"

namespace floes {
namespace plate_moduli_test {

using testing::HasSubstr;

Campaign coarse() {
    Campaign campaign = synthetic::coarse_campaign();
    for (Case& one : campaign.cases) one.scenario.joint.cfm = 0.03;
    return campaign;
}

double modulus_shown(const Case& one) {
    return measure_curve_point(one.scenario, whole_plate_test(one.scenario)).elastic_modulus;
}

std::string settled(Campaign& campaign, int threads = 2) {
    std::ostringstream out;
    Progress progress(out, Progress::Style::plain);
    settle_moduli(campaign, threads, progress);
    return out.str();
}

TEST(PlateModuli, AStatedSigmaGetsTheModulusThatItShows) {
    Campaign campaign = coarse();
    campaign.cases[1].pairing = Pairing::find_modulus;
    const double before = campaign.cases[0].scenario.ice.elastic_modulus;
    const std::string said = settled(campaign);
    EXPECT_NEAR(campaign.cases[1].scenario.ice.elastic_modulus / modulus_shown(campaign.cases[1]), 1, 5e-3);
    EXPECT_EQ(campaign.cases[1].pairing, Pairing::settled);
    EXPECT_EQ(campaign.cases[0].scenario.ice.elastic_modulus, before) << "was settled";
    EXPECT_THAT(said, HasSubstr("case stiff: joint.cfm = 0.03 gives "));
    Campaign again = coarse();
    again.cases[1].pairing = Pairing::find_modulus;
    settled(again, 1);
    EXPECT_EQ(again.cases[1].scenario.ice.elastic_modulus, campaign.cases[1].scenario.ice.elastic_modulus);
}

TEST(PlateModuli, AStatedPairHasToAgreeWithinFivePercent) {
    const double shown = modulus_shown(coarse().cases[0]);
    for (const double factor : {0.97, 1.0, 1.04}) {
        Campaign campaign = coarse();
        campaign.cases[0].pairing = Pairing::check;
        campaign.cases[0].scenario.ice.elastic_modulus = factor * shown;
        EXPECT_EQ(settled(campaign), "");
        EXPECT_EQ(campaign.cases[0].scenario.ice.elastic_modulus, factor * shown) << "as stated";
        EXPECT_EQ(campaign.cases[0].pairing, Pairing::settled);
    }
    for (const double factor : {0.9, 1.1, 30.0}) {
        Campaign campaign = coarse();
        campaign.cases[2].pairing = Pairing::check;
        campaign.cases[2].scenario.ice.elastic_modulus = factor * shown;
        const std::string message = refusal([&] { settled(campaign); });
        EXPECT_THAT(message, HasSubstr("case open: ice.elastic_modulus_MPa = "));
        EXPECT_THAT(message, HasSubstr(fmt::format("shows {:.3g} MPa", shown / 1e6)));
        EXPECT_THAT(message, HasSubstr("joint.model = \"beam\""));
    }
}

TEST(PlateModuli, IceWithoutATestIsRefusedOnlyWhereItsModulusIsNeeded) {
    Campaign campaign = coarse();
    for (Case& one : campaign.cases) one.scenario.ice.bending_strength = 1;  // Pa: the load breaks the sheet
    campaign.cases[0].pairing = Pairing::check;
    EXPECT_THAT(settled(campaign), HasSubstr("case soft: whether E and Σ agree cannot be tested: "));
    campaign.cases[1].pairing = Pairing::find_modulus;
    EXPECT_THAT(refusal([&] { settled(campaign); }), HasSubstr("State ice.elastic_modulus_MPa."));
}

}  // namespace plate_moduli_test
}  // namespace floes
