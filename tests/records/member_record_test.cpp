#include "records/member_record.hpp"

#include <gmock/gmock.h>

#include <bit>
#include <cmath>
#include <limits>
#include <utility>

#include "core/error.hpp"
#include "support/synthetic.hpp"

namespace floes {
namespace {

LoadHistory awkward_history() {
    const double odd_nan = std::bit_cast<double>(std::uint64_t{0xfff8dead0000beef});
    return {{odd_nan, -0.0, std::numeric_limits<double>::infinity(), 0.1}, {}, {std::numeric_limits<double>::lowest()}};
}

// A record in which every number is an awkward one.
MemberRecord awkward_record() {
    const Campaign campaign = synthetic::campaign();
    MemberRecord record = synthetic::failed_record(campaign, 3);
    const double odd_nan = std::bit_cast<double>(std::uint64_t{0xfff8dead0000beef});
    record.result.load.sd = odd_nan;
    record.result.load.trend = -0.0;
    record.result.load.trend_p = std::numeric_limits<double>::denorm_min();
    record.history = pack(awkward_history());
    record.host = std::string("nö\0de", 6);
    return record;
}

std::vector<std::uint64_t> bits_of(std::span<const double> numbers) {
    std::vector<std::uint64_t> bits;
    for (const double number : numbers) bits.push_back(std::bit_cast<std::uint64_t>(number));
    return bits;
}

TEST(PackedHistory, IsTheHistoryBitForBit) {
    const LoadHistory before = awkward_history();
    const LoadHistory after = unpack(pack(before));
    EXPECT_EQ(bits_of(after.surge), bits_of(before.surge));
    EXPECT_TRUE(after.sway.empty());
    EXPECT_EQ(after.heave, before.heave);
    EXPECT_LT(pack(std::vector<double>(1000, 0.1)).chunk.size(), 100u) << "equal numbers must take next to nothing";
}

TEST(PackedHistory, HoldsAFewNumbersAsTheyAre) {
    for (const std::size_t count : {1u, 127u, 128u, 1000u}) {
        std::vector<double> numbers(count);
        for (std::size_t i = 0; i < count; ++i) numbers[i] = std::sin(static_cast<double>(i));
        const PackedNumbers packed = pack(numbers);
        EXPECT_EQ(packed.deflated(), count >= 128);
        EXPECT_EQ(packed.chunk.size() == 8 * count, count < 128) << count;
        EXPECT_EQ(unpack(packed), numbers) << count;
    }
}

class DamagedHistory : public testing::TestWithParam<std::size_t> {};

INSTANTIATE_TEST_SUITE_P(PlainAndDeflated, DamagedHistory, testing::Values(3, 300));

TEST_P(DamagedHistory, IsRefused) {
    const PackedNumbers whole = pack(std::vector<double>(GetParam(), 0.1));
    for (const std::uint64_t count : {whole.count - 1, whole.count + 1, std::uint64_t{1} << 60})
        EXPECT_THROW(unpack(PackedNumbers{count, whole.chunk}), RunError) << count;
    for (std::size_t size = 0; size < whole.chunk.size(); ++size)
        EXPECT_THROW(unpack(PackedNumbers{whole.count, Bytes(whole.chunk.begin(),
                                                             whole.chunk.begin() + static_cast<std::ptrdiff_t>(size))}),
                     RunError)
            << size;
}

/// What journals of schema 1 hold: the record ends with its result, and that has the numbers as they are.
Bytes bytes_of_schema_1(MemberRecord record) {
    record.result.history = unpack(std::exchange(record.history, {}));
    Bytes bytes = encode(record);
    bytes.resize(bytes.size() - 3 * 16);  // three packed rows of nothing: count and length
    return bytes;
}

TEST(MemberRecord, OfAnOlderJournalGetsItsHistoryPacked) {
    const MemberRecord old = awkward_record();
    const MemberRecord read = decode_member_record(bytes_of_schema_1(old));
    EXPECT_EQ(read.history, old.history);
    EXPECT_TRUE(read.result.history.surge.empty());
    EXPECT_EQ(read.result.levels, old.result.levels);
}

TEST(MemberRecord, ComesBackBitForBit) {
    const MemberRecord before = awkward_record();
    const MemberRecord after = decode_member_record(encode(before));
    EXPECT_EQ(encode(after), encode(before));
    EXPECT_EQ(after.case_key, before.case_key);
    EXPECT_EQ(after.arrangement, before.arrangement);
    EXPECT_EQ(after.attempt, before.attempt);
    EXPECT_EQ(after.rank, before.rank);
    EXPECT_EQ(after.host, before.host);
    EXPECT_EQ(after.peak_memory, before.peak_memory);
    EXPECT_EQ(after.result.status, MemberStatus::failed);
    EXPECT_EQ(after.result.reason, before.result.reason);
    EXPECT_EQ(std::bit_cast<std::uint64_t>(after.result.load.sd), 0xfff8dead0000beef);
    EXPECT_TRUE(std::signbit(after.result.load.trend));
    EXPECT_EQ(after.result.load.trend_p, before.result.load.trend_p);
    EXPECT_EQ(after.result.load.segment_maximum, before.result.load.segment_maximum);
    EXPECT_EQ(after.result.load.steady, before.result.load.steady);
    EXPECT_EQ(after.history, before.history);
    EXPECT_EQ(after.result.failures_compression, before.result.failures_compression);
    EXPECT_EQ(after.result.peaks, before.result.peaks);
    EXPECT_EQ(after.result.breaks, before.result.breaks);
    ASSERT_EQ(after.result.arrangement.size(), before.result.arrangement.size());
    EXPECT_EQ(after.result.arrangement[2].yaw, before.result.arrangement[2].yaw);
    EXPECT_EQ(after.result.psi4, before.result.psi4);
    EXPECT_EQ(after.result.wall_time, before.result.wall_time);
    EXPECT_EQ(after.result.cpu_time, before.result.cpu_time);
    EXPECT_EQ(after.result.load.excess_kurtosis, before.result.load.excess_kurtosis);
    EXPECT_EQ(after.result.levels, before.result.levels);
    EXPECT_EQ(after.result.levels.size(), 2u);
}

/// Skewness, kurtosis and two level counts, which older versions did not write.
constexpr std::size_t later_bytes = 8 + 8 + 8 + 2 * 8;

TEST(MemberRecord, OfATimeBeforeProcessorTimeWasMeasuredIsRead) {
    const MemberRecord before = awkward_record();
    Bytes bytes = bytes_of_schema_1(before);
    bytes.resize(bytes.size() - later_bytes);
    const MemberRecord middle = decode_member_record(bytes);
    EXPECT_EQ(middle.result.cpu_time, before.result.cpu_time);
    EXPECT_TRUE(std::isnan(middle.result.load.skewness));
    EXPECT_TRUE(middle.result.levels.empty());
    bytes.resize(bytes.size() - 8);
    const MemberRecord after = decode_member_record(bytes);
    EXPECT_EQ(after.result.wall_time, before.result.wall_time);
    EXPECT_TRUE(std::isnan(after.result.cpu_time));
}

TEST(MemberRecord, BytesAreTheSameOnEveryMachine) {
    MemberRecord record;
    record.case_key = "ab";
    record.arrangement = 0x01020304;
    record.attempt = -2;
    const Bytes bytes = encode(record);
    const std::vector<int> first{2, 0, 0, 0, 0, 0, 0, 0, 'a', 'b', 4, 3, 2, 1, 0xfe, 0xff, 0xff, 0xff};
    for (std::size_t k = 0; k < first.size(); ++k) EXPECT_EQ(std::to_integer<int>(bytes[k]), first[k]) << k;
}

TEST(MemberRecord, RefusesEveryShortenedOne) {
    MemberRecord record = awkward_record();
    record.history = {};
    const Bytes bytes = encode(record);
    const std::size_t before_packing = bytes.size() - 3 * 16;  // these three are what older versions wrote
    const std::size_t before_moments = before_packing - later_bytes;
    const std::size_t before_cpu_time = before_moments - 8;
    for (std::size_t size = 0; size < bytes.size(); ++size)
        if (size != before_cpu_time && size != before_moments && size != before_packing) {
            EXPECT_THROW(decode_member_record(std::span(bytes).first(size)), RunError)
                << size << " of " << bytes.size();
        }
}

TEST(MemberRecord, RefusesBytesBehindItsEnd) {
    Bytes bytes = encode(awkward_record());
    bytes.push_back(std::byte{0});
    EXPECT_THROW(decode_member_record(bytes), RunError);
}

TEST(MemberRecord, RefusesAStateThatDoesNotExist) {
    MemberRecord record = awkward_record();
    record.result.breaks[0].mode = static_cast<FailureMode>(6);
    EXPECT_THROW(decode_member_record(encode(record)), RunError);
}

// Counts are the first thing that damage makes enormous: no byte may lead to anything but RunError or a record.
TEST(MemberRecord, SurvivesEveryByteBeingGarbage) {
    const Bytes good = encode(awkward_record());
    for (std::size_t k = 0; k < good.size(); ++k) {
        Bytes bad = good;
        bad[k] = ~bad[k];
        try {
            decode_member_record(bad);
        } catch (const RunError&) {
        }
    }
    ByteWriter count;
    count.u64(std::numeric_limits<std::uint64_t>::max());
    EXPECT_THROW(ByteReader(count.bytes()).doubles(), RunError);
    EXPECT_THROW(ByteReader(count.bytes()).text(), RunError);
}

TEST(MatchRecords, PutsRecordsInMemberOrder) {
    const Campaign campaign = synthetic::campaign();
    std::vector<MemberRecord> records = synthetic::records(campaign);
    std::reverse(records.begin(), records.end());
    const auto matched = match_records(campaign, records);
    ASSERT_EQ(matched.size(), 12u);
    for (int number = 0; number < 12; ++number) {
        const MemberRecord* record = matched[static_cast<std::size_t>(number)];
        ASSERT_EQ(record == nullptr, number == 7);
        EXPECT_TRUE(record == nullptr || record->result.wall_time == 12.5 + number) << number;
    }
}

TEST(MatchRecords, TakesADoneRecordBeforeAFailedOneAndTheFirstBeforeALaterOne) {
    const Campaign campaign = synthetic::campaign();
    std::vector<MemberRecord> records{synthetic::failed_record(campaign, 0), synthetic::record(campaign, 0),
                                      synthetic::record(campaign, 0), synthetic::failed_record(campaign, 0)};
    for (int k = 0; k < 4; ++k) records[static_cast<std::size_t>(k)].attempt = k + 1;
    EXPECT_EQ(match_records(campaign, records)[0], &records[1]);
    EXPECT_EQ(last_attempts(campaign, records)[0], 4);
    EXPECT_EQ(last_attempts(campaign, records)[1], 0);
}

TEST(MatchRecords, KeepsRecordsValidWhenArrangementsAreAdded) {
    const Campaign small = synthetic::campaign(2);
    const std::vector<MemberRecord> records{synthetic::record(small, 5)};
    EXPECT_EQ(match_records(synthetic::campaign(9), records)[5], &records[0]);
}

TEST(MatchRecords, IgnoresRecordsOfOtherPhysics) {
    Campaign campaign = synthetic::campaign();
    const std::vector<MemberRecord> records{synthetic::record(campaign, 0)};
    campaign.cases[0].scenario.general.iterations = 51;
    EXPECT_THAT(match_records(campaign, records), testing::Each(nullptr));
}

TEST(MatchRecords, GivesCasesOfEqualPhysicsTheSameRecord) {
    Campaign campaign = synthetic::campaign();
    campaign.cases.push_back({"soft again", campaign.cases[0].scenario});
    const std::vector<MemberRecord> records{synthetic::record(campaign, 0)};
    EXPECT_EQ(match_records(campaign, records)[0], &records[0]);
    EXPECT_EQ(match_records(campaign, records)[3], &records[0]);
}

}  // namespace
}  // namespace floes
