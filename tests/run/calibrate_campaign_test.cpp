#include "run/calibrate.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <sstream>

#include "campaign/campaign.hpp"
#include "run/fakes.hpp"
#include "support/refusal.hpp"

namespace floes {
namespace calibrate_campaign_test {

using testing::HasSubstr;

/// The first and the third case want a modulus; the second is the same ice with its Σ given.
Campaign coarse() {
    Campaign campaign = synthetic::coarse_campaign();
    for (Case& one : campaign.cases) one.scenario.ice.elastic_modulus = 200e6;
    campaign.cases[0].pairing = Pairing::find_cfm;
    campaign.cases[2].pairing = Pairing::find_cfm;
    return campaign;
}

struct Calibrating {
    explicit Calibrating(std::span<const CalibrationRecord> kept = {}, int threads = 2) {
        Progress progress(out, Progress::Style::plain);
        records = calibrate_campaign(campaign, kept, threads, progress);
    }
    std::ostringstream out;
    Campaign campaign = coarse();
    std::vector<CalibrationRecord> records;
};

TEST(CalibrateCampaign, GivesCasesOfOneIceTheSigmaThatShowsTheirModulus) {
    const Calibrating run;
    ASSERT_EQ(run.records.size(), 1u);
    const Calibration& found = run.records[0].found;
    EXPECT_EQ(run.campaign.cases[0].scenario.joint.cfm, found.cfm);
    EXPECT_EQ(run.campaign.cases[1].scenario.joint.cfm, coarse().cases[1].scenario.joint.cfm) << "was given";
    EXPECT_EQ(run.campaign.cases[2].scenario.joint.cfm, found.cfm);
    for (const Case& one : run.campaign.cases) EXPECT_EQ(one.pairing, Pairing::settled);
    const CurvePoint point =
        measure_curve_point(run.campaign.cases[0].scenario, {.sheet = 7 * 0.75});  // 5.4 m are 7.2 elements
    EXPECT_NEAR(point.elastic_modulus, 200e6, 0.01 * 200e6);
    EXPECT_THAT(run.out.str(), HasSubstr("calibrating soft, open: searching for the Σ that gives 200 MPa on a sheet of "
                                         "5.25 m (elements of 0.75 m do not divide 5.4 m)"));
    EXPECT_THAT(run.out.str(), HasSubstr("calibrated soft, open: Σ = "));
}

TEST(CalibrateCampaign, TakesWhatIsKeptAndGivesTheSameWithoutIt) {
    const Calibrating first;
    const Calibrating second({}, 1);
    EXPECT_EQ(fingerprint(second.campaign), fingerprint(first.campaign));
    EXPECT_EQ(encode(second.records.at(0)), encode(first.records.at(0)));
    const Calibrating resumed(first.records);
    EXPECT_EQ(fingerprint(resumed.campaign), fingerprint(first.campaign));
    EXPECT_THAT(resumed.out.str(), HasSubstr(" MPa), as before"));
    EXPECT_EQ(resumed.out.str().find("searching for"), std::string::npos);
}

TEST(CalibrateCampaign, RefusesAModulusAboveTheCeilingNamingTheCase) {
    Campaign campaign = coarse();
    campaign.cases[2].scenario.ice.elastic_modulus = 1e12;
    std::ostringstream out;
    Progress progress(out, Progress::Style::plain);
    EXPECT_THAT(refusal([&] { calibrate_campaign(campaign, {}, 2, progress); }),
                HasSubstr("case open cannot be calibrated: An elastic modulus of 1e+06 MPa is above"));
}

TEST(CalibrateCampaign, TheJournalKeepsItForTheFileAndForLater) {
    const TemporaryFolder folder;
    const Calibrating first;
    Recorder::Places places{folder / "a.h5", Existing::refuse};
    EXPECT_TRUE(kept_calibrations(places).empty());
    places.calibrations = first.records;
    {
        Recorder recorder(first.campaign, places);
        recorder.begin(synthetic::session());
        recorder.finish("complete");
    }
    EXPECT_TRUE(kept_calibrations(places).empty()) << "nothing is taken over unasked";
    places.existing = Existing::resume;
    const auto kept = kept_calibrations(places);
    ASSERT_EQ(kept.size(), 1u);
    EXPECT_EQ(encode(kept[0]), encode(first.records[0]));
    EXPECT_EQ(read_stored_campaign(read_journal(folder / "a.journal"), "a.journal").cases[0].scenario.joint.cfm,
              first.records[0].found.cfm);
}

}  // namespace calibrate_campaign_test
}  // namespace floes
