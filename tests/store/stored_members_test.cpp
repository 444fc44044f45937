// What is known of stored members in memory, and which record counts.

#include "store/member_record.hpp"

#include <gmock/gmock.h>

#include <algorithm>

#include "support/synthetic.hpp"

namespace floes {
namespace stored_members_test {

MemberNotes notes_of(const std::vector<MemberRecord>& records) {
    MemberNotes notes;
    for (const MemberRecord& record : records) notes.add(record);
    return notes;
}

TEST(MatchRecords, PutsRecordsInMemberOrder) {
    const Campaign campaign = synthetic::campaign();
    std::vector<MemberRecord> records = synthetic::records(campaign);
    std::reverse(records.begin(), records.end());
    const auto matched = match_records(campaign, notes_of(records));
    ASSERT_EQ(matched.size(), 12u);
    for (int number = 0; number < 12; ++number) {
        const std::optional<std::size_t> record = matched[static_cast<std::size_t>(number)];
        ASSERT_EQ(record.has_value(), number != 7);
        if (record) {
            EXPECT_EQ(records[*record].result.wall_time, 12.5 + number);
        }
    }
}

TEST(MatchRecords, TakesADoneRecordBeforeAFailedOneAndTheFirstBeforeALaterOne) {
    const Campaign campaign = synthetic::campaign();
    std::vector<MemberRecord> records{synthetic::failed_record(campaign, 0), synthetic::record(campaign, 0),
                                      synthetic::record(campaign, 0), synthetic::failed_record(campaign, 0)};
    for (int k = 0; k < 4; ++k) records[static_cast<std::size_t>(k)].attempt = k + 1;
    EXPECT_EQ(match_records(campaign, notes_of(records))[0], 1u);
    EXPECT_EQ(last_attempts(campaign, notes_of(records))[0], 4);
    EXPECT_EQ(last_attempts(campaign, notes_of(records))[1], 0);
}

TEST(MatchRecords, KeepsRecordsValidWhenArrangementsAreAdded) {
    const Campaign small = synthetic::campaign(2);
    const std::vector<MemberRecord> records{synthetic::record(small, 5)};
    EXPECT_EQ(match_records(synthetic::campaign(9), notes_of(records))[5], 0u);
}

TEST(MatchRecords, IgnoresRecordsOfOtherPhysics) {
    Campaign campaign = synthetic::campaign();
    const std::vector<MemberRecord> records{synthetic::record(campaign, 0)};
    campaign.cases[0].scenario.general.iterations = 51;
    EXPECT_THAT(match_records(campaign, notes_of(records)), testing::Each(std::nullopt));
}

TEST(MatchRecords, GivesCasesOfEqualPhysicsTheSameRecord) {
    Campaign campaign = synthetic::campaign();
    campaign.cases.push_back({"soft again", campaign.cases[0].scenario});
    const std::vector<MemberRecord> records{synthetic::record(campaign, 0)};
    EXPECT_EQ(match_records(campaign, notes_of(records))[0], 0u);
    EXPECT_EQ(match_records(campaign, notes_of(records))[3], 0u);
}

}  // namespace stored_members_test
}  // namespace floes
