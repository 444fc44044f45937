#include "store/member_record.hpp"

#include <gmock/gmock.h>
#include <zlib.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>

#include "core/error.hpp"
#include "member/quantity.hpp"
#include "support/synthetic.hpp"

namespace floes {
namespace member_record_test {

// A record in which every number is an awkward one.
MemberRecord awkward_record() {
    const Campaign campaign = synthetic::campaign();
    MemberRecord record = synthetic::failed_record(campaign, 3);
    const double odd_nan = std::bit_cast<double>(std::uint64_t{0xfff8dead0000beef});
    record.result.load.sd = odd_nan;
    record.result.load.trend = -0.0;
    record.result.load.trend_p = std::numeric_limits<double>::denorm_min();
    record.result.history = {{odd_nan, -0.0, std::numeric_limits<double>::infinity(), 0.1},
                             {},
                             {std::numeric_limits<double>::lowest()},
                             {0.7},
                             {},
                             {5e-324}};
    record.result.load_map.normal.front() = std::numeric_limits<double>::denorm_min();
    record.result.load_map.surge.front() = -0.0;
    record.host = std::string("nö\0de", 6);
    return record;
}

std::vector<std::uint64_t> bits_of(std::span<const double> numbers) {
    std::vector<std::uint64_t> bits;
    for (const double number : numbers) bits.push_back(std::bit_cast<std::uint64_t>(number));
    return bits;
}

TEST(PackedNumbers, AreTheNumbersBitForBit) {
    const std::vector<double> before = awkward_record().result.history.surge;
    EXPECT_EQ(bits_of(unpack(pack(before))), bits_of(before));
    EXPECT_TRUE(unpack(pack(std::vector<double>{})).empty());
    EXPECT_LT(pack(std::vector<double>(1000, 0.1)).chunk.size(), 100u) << "equal numbers must take next to nothing";
}

TEST(PackedNumbers, HoldsAFewNumbersAsTheyAre) {
    for (const std::size_t count : {1u, 127u, 128u, 1000u}) {
        std::vector<double> numbers(count);
        for (std::size_t i = 0; i < count; ++i) numbers[i] = std::sin(static_cast<double>(i));
        const PackedNumbers packed = pack(numbers);
        EXPECT_EQ(packed.deflated(), count >= 128);
        EXPECT_EQ(packed.chunk.size() == 8 * count, count < 128) << count;
        EXPECT_EQ(unpack(packed), numbers) << count;
    }
}

class DamagedNumbers : public testing::TestWithParam<std::size_t> {};

INSTANTIATE_TEST_SUITE_P(PlainAndDeflated, DamagedNumbers, testing::Values(3, 300));

TEST_P(DamagedNumbers, IsRefused) {
    const PackedNumbers whole = pack(std::vector<double>(GetParam(), 0.1));
    for (const std::uint64_t count : {whole.count - 1, whole.count + 1, std::uint64_t{1} << 60})
        EXPECT_THROW(unpack(PackedNumbers{count, whole.chunk}), RunError) << count;
    for (std::size_t size = 0; size < whole.chunk.size(); ++size)
        EXPECT_THROW(unpack(PackedNumbers{whole.count, Bytes(whole.chunk.begin(),
                                                             whole.chunk.begin() + static_cast<std::ptrdiff_t>(size))}),
                     RunError)
            << size;
}

// A fifth of a megabyte that says truly that it holds 208 of zeros.
TEST(PackedNumbers, LongerThanAnyRunIsRefused) {
    z_stream stream{};
    ASSERT_EQ(deflateInit(&stream, 1), Z_OK);
    PackedNumbers packed{26'000'000, Bytes(1 << 20)};
    stream.next_out = reinterpret_cast<Bytef*>(packed.chunk.data());
    stream.avail_out = static_cast<uInt>(packed.chunk.size());
    std::vector<Bytef> zeros(8 * 1'000'000);
    for (int million = 1; million <= 26; ++million) {
        stream.next_in = zeros.data();
        stream.avail_in = static_cast<uInt>(zeros.size());
        ASSERT_GE(deflate(&stream, million == 26 ? Z_FINISH : Z_NO_FLUSH), Z_OK);
    }
    packed.chunk.resize(stream.total_out);
    deflateEnd(&stream);
    EXPECT_THROW(unpack(packed), RunError);
}

// It became a number that nobody had counted: the conversion is undefined.
TEST(MemberRecord, ACountThatIsNoneIsRefused) {
    const std::string key = "failures_bending";
    Bytes bytes = encode(synthetic::record(synthetic::campaign(), 0));
    const std::string_view text(reinterpret_cast<const char*>(bytes.data()), bytes.size());
    ByteWriter number;
    number.f64(1e300);
    std::ranges::copy(number.bytes(), bytes.begin() + static_cast<std::ptrdiff_t>(text.find(key) + key.size()));
    EXPECT_THROW(decode_member_record(bytes), RunError);
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
    const MemberResult whole = after.whole();
    EXPECT_EQ(whole.status, MemberStatus::failed);
    EXPECT_EQ(whole.reason, before.result.reason);
    EXPECT_EQ(std::bit_cast<std::uint64_t>(whole.load.sd), 0xfff8dead0000beef);
    EXPECT_TRUE(std::signbit(whole.load.trend));
    EXPECT_EQ(whole.load.trend_p, before.result.load.trend_p);
    EXPECT_EQ(whole.load.segment_maximum, before.result.load.segment_maximum);
    EXPECT_EQ(whole.load.steady, before.result.load.steady);
    EXPECT_EQ(bits_of(whole.history.surge), bits_of(before.result.history.surge));
    EXPECT_TRUE(whole.history.sway.empty());
    EXPECT_EQ(whole.history.heave, before.result.history.heave);
    EXPECT_EQ(whole.history.concentration, before.result.history.concentration);
    EXPECT_EQ(whole.load_map, before.result.load_map);
    EXPECT_EQ(whole.failures, before.result.failures);
    EXPECT_EQ(whole.peaks, before.result.peaks);
    EXPECT_EQ(whole.breaks, before.result.breaks);
    ASSERT_EQ(whole.arrangement.size(), before.result.arrangement.size());
    EXPECT_EQ(whole.arrangement[2].yaw, before.result.arrangement[2].yaw);
    EXPECT_EQ(whole.psi4, before.result.psi4);
    EXPECT_EQ(whole.wall_time, before.result.wall_time);
    EXPECT_EQ(whole.cpu_time, before.result.cpu_time);
    EXPECT_EQ(whole.load.excess_kurtosis, before.result.load.excess_kurtosis);
    EXPECT_EQ(whole.levels, before.result.levels);
    EXPECT_EQ(whole.levels.size(), 2u);
    ASSERT_EQ(whole.averaged.size(), 2u);
    EXPECT_EQ(whole.averaged[1].time, 0.4);
    EXPECT_EQ(whole.averaged[1].sd, before.result.averaged[1].sd);
    EXPECT_EQ(whole.averaged[1].mean_maximum, before.result.averaged[1].mean_maximum);
    EXPECT_EQ(whole.averaged[1].sd_maximum, before.result.averaged[1].sd_maximum);
    EXPECT_EQ(whole.averaged[1].segment_maximum, before.result.averaged[1].segment_maximum);
    EXPECT_EQ(whole.averaged[1].peaks, before.result.averaged[1].peaks);
    const MemberResult small = after.whole(MemberRecord::Arrays::in_table);
    EXPECT_EQ(small.averaged[1].peaks, before.result.averaged[1].peaks);
    EXPECT_TRUE(small.history.surge.empty());
}

TEST(MemberRecord, PassesOverArraysOfANewerVersion) {
    const MemberRecord before = awkward_record();
    Bytes bytes = encode(before);
    const std::string_view path = "load_map/normal_force";
    const auto found = std::ranges::search(bytes, std::as_bytes(std::span(path)));
    ASSERT_FALSE(found.empty());
    found.front() = std::byte{'?'};
    const MemberResult read = decode_member_record(bytes).whole();
    EXPECT_TRUE(read.load_map.normal.empty());
    EXPECT_EQ(read.load_map.surge, before.result.load_map.surge);
}

TEST(MemberRecord, RefusesSizesThatDoNotFit) {
    MemberRecord record = decode_member_record(encode(awkward_record()));
    PackedArray& map = record.arrays[array_number("load_map/surge_load")];
    for (const std::vector<std::size_t>& sizes : {std::vector<std::size_t>{432}, {36, 12}, {12, 36, 1}, {12, 35}}) {
        map.sizes = sizes;
        EXPECT_THROW(decode_member_record(encode(record)), RunError) << sizes[0];
    }
}

/// As a version would write whose first quantity has another name.
TEST(MemberRecord, HasNaNForQuantitiesThatItsWriterDidNotKnow) {
    Bytes bytes = encode(awkward_record());
    const std::string_view key = quantities.front().key;
    const auto found = std::ranges::search(bytes, std::as_bytes(std::span(key)));
    ASSERT_FALSE(found.empty());
    found.front() = std::byte{'?'};
    const MemberRecord read = decode_member_record(bytes);
    EXPECT_TRUE(std::isnan(quantities.front().of(read.result)));
    EXPECT_EQ(read.result.load.maximum, awkward_record().result.load.maximum);
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
    record.result.load_map = {};
    const Bytes bytes = encode(record);
    for (std::size_t size = 0; size < bytes.size(); ++size)
        EXPECT_THROW(decode_member_record(std::span(bytes).first(size)), RunError) << size << " of " << bytes.size();
}

TEST(MemberRecord, RefusesBytesBehindItsEnd) {
    Bytes bytes = encode(awkward_record());
    bytes.push_back(std::byte{0});
    EXPECT_THROW(decode_member_record(bytes), RunError);
}

TEST(MemberRecord, RefusesAStateThatDoesNotExist) {
    MemberRecord record = awkward_record();
    record.result.breaks[0].mode = static_cast<FailureMode>(6);
    EXPECT_THROW(static_cast<void>(decode_member_record(encode(record)).whole()), RunError);
}

// Counts are the first thing that damage makes enormous: no byte may lead to anything but RunError or a record.
TEST(MemberRecord, SurvivesEveryByteBeingGarbage) {
    const Bytes good = encode(awkward_record());
    for (std::size_t k = 0; k < good.size(); ++k) {
        Bytes bad = good;
        bad[k] = ~bad[k];
        try {
            static_cast<void>(decode_member_record(bad).whole());
        } catch (const RunError&) {
        }
    }
    ByteWriter count;
    count.u64(std::numeric_limits<std::uint64_t>::max());
    EXPECT_THROW(ByteReader(count.bytes()).doubles(), RunError);
    EXPECT_THROW(ByteReader(count.bytes()).text(), RunError);
}

}  // namespace member_record_test
}  // namespace floes
