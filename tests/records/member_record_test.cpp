#include "records/member_record.hpp"

#include <gmock/gmock.h>
#include <zlib.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <utility>

#include "core/error.hpp"
#include "quantities/quantity.hpp"
#include "support/synthetic.hpp"

namespace floes {
namespace {

LoadHistory awkward_history() {
    const double odd_nan = std::bit_cast<double>(std::uint64_t{0xfff8dead0000beef});
    return {{odd_nan, -0.0, std::numeric_limits<double>::infinity(), 0.1}, {}, {std::numeric_limits<double>::lowest()}};
}

LoadMap awkward_map() {
    LoadMap map;
    map.surge.assign(LoadMap::heights * LoadMap::angles, -0.0);
    map.normal = map.surge;
    map.normal.front() = std::numeric_limits<double>::denorm_min();
    map.along_tow = {0.1, -0.1};
    return map;
}

// A record in which every number is an awkward one.
MemberRecord awkward_record() {
    const Campaign campaign = synthetic::campaign();
    MemberRecord record = synthetic::failed_record(campaign, 3);
    const double odd_nan = std::bit_cast<double>(std::uint64_t{0xfff8dead0000beef});
    record.result.load.sd = odd_nan;
    record.result.load.trend = -0.0;
    record.result.load.trend_p = std::numeric_limits<double>::denorm_min();
    record.history = pack(awkward_history(), awkward_map());
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

// A fifth of a megabyte that says truly that it holds 208 of zeros.
TEST(PackedHistory, LongerThanAnyRunIsRefused) {
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

/// What a version wrote into its journals.
enum class Written { schema_2, schema_1, before_levels, before_processor_time };

/// The bytes of older versions: quantities in an order that was fixed, without their keys; up to schema 1 histories as
/// they are, in the result.
Bytes older_bytes(const MemberRecord& record, Written version) {
    const MemberResult& result = record.result;
    const LoadHistory history = version == Written::schema_2 ? LoadHistory{} : unpack(record.history);
    ByteWriter out;
    out.text(record.case_key);
    for (const int number : {record.arrangement, record.attempt, record.rank}) out.i32(number);
    out.text(record.host);
    out.u64(record.peak_memory);
    out.u8(static_cast<std::uint8_t>(result.status));
    out.text(result.reason);
    const LoadStatistics& load = result.load;
    for (const double value :
         {load.mean, load.sd, load.maximum, load.mean_maximum, load.sd_maximum, load.trend, load.trend_p})
        out.f64(value);
    out.u8(load.steady ? 1 : 0);
    out.doubles(load.segment_maximum);
    for (const double value : {result.mean_sway, result.mean_heave, result.failure_ratio}) out.f64(value);
    for (const int count : {result.failures_bending, result.failures_shear, result.failures_compression})
        out.i32(count);
    const PeakReactions& peaks = result.peaks;
    for (const double value :
         {peaks.compression, peaks.tension, peaks.shear, peaks.bending, peaks.torsion, peaks.in_plane_bending})
        out.f64(value);
    for (const auto* part : {&history.surge, &history.sway, &history.heave}) out.doubles(*part);
    out.u64(result.breaks.size());
    for (const BreakEvent& event : result.breaks) {
        out.f64(event.time);
        out.i32(event.floe);
        out.i32(event.joint);
        out.u8(static_cast<std::uint8_t>(event.mode));
    }
    out.u64(result.arrangement.size());
    for (const PlanarPose& pose : result.arrangement)
        for (const double value : {pose.x, pose.z, pose.yaw}) out.f64(value);
    out.f64(result.psi4);
    out.f64(result.wall_time);
    if (version == Written::before_processor_time) return out.take();
    out.f64(result.cpu_time);
    if (version == Written::before_levels) return out.take();
    out.f64(load.skewness);
    out.f64(load.excess_kurtosis);
    out.u64(result.levels.size());
    for (const LevelCount& count : result.levels) {
        out.i32(count.steps_above);
        out.i32(count.upcrossings);
    }
    if (version == Written::schema_1) return out.take();
    for (const PackedNumbers* numbers : {&record.history.surge, &record.history.sway, &record.history.heave}) {
        out.u64(numbers->count);
        out.blob(numbers->chunk);
    }
    return out.take();
}

TEST(OlderMemberRecord, IsReadBitForBit) {
    MemberRecord before = awkward_record();
    before.result.averaged.clear();  // which no older version knew, nor these
    before.history.map = {};
    before.result.local_order = before.result.coverage_ahead = std::numeric_limits<double>::quiet_NaN();
    for (const Written version : {Written::schema_2, Written::schema_1}) {
        const MemberRecord after = decode_older_member_record(older_bytes(before, version));
        EXPECT_EQ(encode(after), encode(before));
        EXPECT_EQ(after.history, before.history);
        EXPECT_TRUE(after.result.history.surge.empty());
    }
    EXPECT_THROW(decode_member_record(older_bytes(before, Written::schema_2)), RunError);
}

TEST(OlderMemberRecord, DoesNotKnowWhatCameLater) {
    MemberRecord before = awkward_record();
    before.history.map = {};
    const MemberRecord middle = decode_older_member_record(older_bytes(before, Written::before_levels));
    EXPECT_EQ(middle.result.cpu_time, before.result.cpu_time);
    EXPECT_TRUE(std::isnan(middle.result.load.skewness));
    EXPECT_TRUE(middle.result.levels.empty());
    const MemberRecord after = decode_older_member_record(older_bytes(before, Written::before_processor_time));
    EXPECT_EQ(after.result.wall_time, before.result.wall_time);
    EXPECT_TRUE(std::isnan(after.result.cpu_time));
    EXPECT_EQ(after.history, before.history);
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
    ASSERT_EQ(after.result.averaged.size(), 2u);
    EXPECT_EQ(after.result.averaged[1].time, 0.4);
    EXPECT_EQ(after.result.averaged[1].sd, before.result.averaged[1].sd);
    EXPECT_EQ(after.result.averaged[1].mean_maximum, before.result.averaged[1].mean_maximum);
    EXPECT_EQ(after.result.averaged[1].sd_maximum, before.result.averaged[1].sd_maximum);
    EXPECT_EQ(after.result.averaged[1].segment_maximum, before.result.averaged[1].segment_maximum);
    EXPECT_EQ(after.result.averaged[1].peaks, before.result.averaged[1].peaks);
}

/// From before peaks were taken: the record ends with its averaged loads.
TEST(MemberRecord, HasNoPeaksWhereItsWriterDidNotTakeThem) {
    MemberRecord before = awkward_record();
    before.history.map = {};
    for (AveragedLoad& one : before.result.averaged) one.peaks.clear();
    Bytes bytes = encode(before);
    bytes.resize(bytes.size() - 8 * before.result.averaged.size());  // how many there are of each
    const MemberRecord after = decode_member_record(bytes);
    EXPECT_EQ(encode(after), encode(before));
}

/// From before maps were taken: the record ends with its peaks.
TEST(MemberRecord, HasNoLoadMapWhereItsWriterDidNotTakeIt) {
    const MemberRecord before = awkward_record();
    const PackedLoadMap& map = before.history.map;
    Bytes bytes = encode(before);
    std::size_t length = 0;
    for (const PackedNumbers* part : {&map.surge, &map.normal, &map.along_tow}) length += 16 + part->chunk.size();
    const std::span<const std::byte> older = std::span(bytes).first(bytes.size() - length);
    const MemberRecord after = decode_member_record(older);
    EXPECT_TRUE(after.history.map.empty());
    EXPECT_EQ(after.history.heave, before.history.heave);
    EXPECT_EQ(after.result.averaged.back().peaks, before.result.averaged.back().peaks);
    for (std::size_t size = older.size() + 1; size < bytes.size(); ++size)
        EXPECT_THROW(decode_member_record(std::span(bytes).first(size)), RunError) << size;
}

/// Of schema 3, but from before loads were averaged: the record ends with its histories.
TEST(MemberRecord, HasNoAveragedLoadsWhereItsWriterDidNotTakeThem) {
    MemberRecord before = awkward_record();
    before.result.averaged.clear();
    before.history.map = {};
    Bytes bytes = encode(before);
    bytes.resize(bytes.size() - 8);  // how many times there are
    const MemberRecord after = decode_member_record(bytes);
    EXPECT_TRUE(after.result.averaged.empty());
    EXPECT_EQ(after.history, before.history);
    EXPECT_TRUE(std::isnan(averaged_over(quantity("mean_maximum"), 0.1).of(after.result)));
    EXPECT_EQ(encode(after), encode(before));
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
    record.history = {};
    const Bytes bytes = encode(record);
    record.result.averaged.clear();
    const std::size_t before_averages = encode(record).size() - 8;  // where older ones end
    std::size_t before_peaks = bytes.size();                        // where less old ones end
    for (const AveragedLoad& one : awkward_record().result.averaged) before_peaks -= 8 * (1 + one.peaks.size());
    for (std::size_t size = 0; size < bytes.size(); ++size) {
        if (size == before_averages || size == before_peaks) continue;
        EXPECT_THROW(decode_member_record(std::span(bytes).first(size)), RunError) << size << " of " << bytes.size();
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

}  // namespace
}  // namespace floes
