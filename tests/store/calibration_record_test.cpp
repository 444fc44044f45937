#include "store/member_record.hpp"

#include <gtest/gtest.h>

#include "core/error.hpp"
#include "store/journal.hpp"
#include "support/synthetic.hpp"
#include "support/temporary_folder.hpp"

namespace floes {
namespace calibration_record_test {

TEST(CalibrationRecord, BytesGiveItBackAndNothingElseDoes) {
    const Bytes bytes = encode(synthetic::calibration(synthetic::campaign()));
    EXPECT_EQ(encode(decode_calibration_record(bytes)), bytes);
    Bytes longer = bytes;
    longer.push_back(std::byte{0});
    EXPECT_THROW(decode_calibration_record(longer), RunError);
    EXPECT_THROW(decode_calibration_record(std::span(bytes).first(bytes.size() - 1)), RunError);
}

TEST(CalibrationRecord, KeyIsTheIceAndTheWantedModulusAlone) {
    const Scenario ice;
    Scenario elsewhere;
    elsewhere.field.floes = 7;
    elsewhere.structure.speed = 0.1;
    elsewhere.floe.length = 1.2;
    elsewhere.joint.cfm = 0.5;
    EXPECT_EQ(calibration_key(elsewhere), calibration_key(ice));
    for (const auto change :
         {+[](Scenario& s) { s.ice.elastic_modulus = 61e6; }, +[](Scenario& s) { s.floe.thickness = 0.04; },
          +[](Scenario& s) { s.floe.element = 0.3; }, +[](Scenario& s) { s.general.iterations = 51; },
          +[](Scenario& s) { s.general.time_step = 0.01; }, +[](Scenario& s) { s.general.solver = SolverKind::stock; },
          +[](Scenario& s) { s.joint.erp = 0.7; }, +[](Scenario& s) { s.water.density = 1025; }}) {
        Scenario other;
        change(other);
        EXPECT_NE(calibration_key(other), calibration_key(ice));
    }
}

TEST(CalibrationRecord, BelongsToTheCasesWithItsIceAndItsCfm) {
    Campaign campaign = synthetic::campaign();
    const std::vector<CalibrationRecord> records{synthetic::calibration(campaign)};
    // The third case has the ice of the second and the same Σ.
    EXPECT_EQ(match_calibrations(campaign, records),
              (std::vector<const Calibration*>{nullptr, &records[0].found, &records[0].found}));
    campaign.cases[2].scenario.joint.cfm = 0.02;
    EXPECT_EQ(match_calibrations(campaign, records),
              (std::vector<const Calibration*>{nullptr, &records[0].found, nullptr}));
}

TEST(CalibrationRecord, StaysInTheJournalOnce) {
    const TemporaryFolder folder;
    const Campaign campaign = synthetic::campaign();
    const CalibrationRecord record = synthetic::calibration(campaign);
    for (const Existing existing : {Existing::refuse, Existing::resume}) {
        Journal journal = open_journal(folder / "a.journal", campaign, existing);
        journal.append(record);
        journal.append(synthetic::record(campaign, 0));
    }
    const JournalContents contents = read_journal(folder / "a.journal");
    ASSERT_EQ(contents.calibrations.size(), 1u);
    EXPECT_EQ(encode(contents.calibrations[0]), encode(record));
    EXPECT_EQ(contents.members.size(), 2u);
}

}  // namespace calibration_record_test
}  // namespace floes
