#include "store/member_record.hpp"

#include <algorithm>
#include <map>
#include <utility>

#include "core/error.hpp"

namespace floes {
namespace {

// Reading visits the same fields in the same order as writing: one list for both.
template <class Statistics, class Scalar>
void visit_statistics(Statistics& load, const Scalar& scalar) {
    scalar(load.mean);
    scalar(load.sd);
    scalar(load.maximum);
    scalar(load.mean_maximum);
    scalar(load.sd_maximum);
    scalar(load.trend);
    scalar(load.trend_p);
}

template <class Peaks, class Scalar>
void visit_peaks(Peaks& peaks, const Scalar& scalar) {
    scalar(peaks.compression);
    scalar(peaks.tension);
    scalar(peaks.shear);
    scalar(peaks.bending);
    scalar(peaks.torsion);
    scalar(peaks.in_plane_bending);
}

constexpr std::size_t break_bytes = 8 + 4 + 4 + 1;
constexpr std::size_t pose_bytes = 3 * 8;

void write_result(ByteWriter& out, const MemberResult& result) {
    const auto scalar = [&out](double value) { out.f64(value); };
    out.u8(static_cast<std::uint8_t>(result.status));
    out.text(result.reason);
    visit_statistics(result.load, scalar);
    out.u8(result.load.steady ? 1 : 0);
    out.doubles(result.load.segment_maximum);
    out.f64(result.mean_sway);
    out.f64(result.mean_heave);
    out.f64(result.failure_ratio);
    out.i32(result.failures_bending);
    out.i32(result.failures_shear);
    out.i32(result.failures_compression);
    visit_peaks(result.peaks, scalar);
    out.doubles(result.history.surge);
    out.doubles(result.history.sway);
    out.doubles(result.history.heave);
    out.u64(result.breaks.size());
    for (const BreakEvent& event : result.breaks) {
        out.f64(event.time);
        out.i32(event.floe);
        out.i32(event.joint);
        out.u8(static_cast<std::uint8_t>(event.mode));
    }
    out.u64(result.arrangement.size());
    for (const PlanarPose& pose : result.arrangement) {
        out.f64(pose.x);
        out.f64(pose.z);
        out.f64(pose.yaw);
    }
    out.f64(result.psi4);
    out.f64(result.wall_time);
}

std::uint8_t read_below(ByteReader& in, std::uint8_t limit) {
    const std::uint8_t value = in.u8();
    if (value >= limit) throw RunError("a stored member has a state that does not exist; it was damaged");
    return value;
}

MemberResult read_result(ByteReader& in) {
    MemberResult result;
    const auto scalar = [&in](double& value) { value = in.f64(); };
    result.status = static_cast<MemberStatus>(read_below(in, 2));
    result.reason = in.text();
    visit_statistics(result.load, scalar);
    result.load.steady = read_below(in, 2) == 1;
    result.load.segment_maximum = in.doubles();
    result.mean_sway = in.f64();
    result.mean_heave = in.f64();
    result.failure_ratio = in.f64();
    result.failures_bending = in.i32();
    result.failures_shear = in.i32();
    result.failures_compression = in.i32();
    visit_peaks(result.peaks, scalar);
    result.history.surge = in.doubles();
    result.history.sway = in.doubles();
    result.history.heave = in.doubles();
    result.breaks.resize(in.count(break_bytes));
    for (BreakEvent& event : result.breaks) {
        event.time = in.f64();
        event.floe = in.i32();
        event.joint = in.i32();
        event.mode = static_cast<FailureMode>(read_below(in, failure_mode_names.size()));
    }
    result.arrangement.resize(in.count(pose_bytes));
    for (PlanarPose& pose : result.arrangement) {
        pose.x = in.f64();
        pose.z = in.f64();
        pose.yaw = in.f64();
    }
    result.psi4 = in.f64();
    result.wall_time = in.f64();
    return result;
}

using MemberIdentity = std::pair<std::string, int>;

// Cases of equal physics share their records, hence several numbers to an identity.
std::multimap<MemberIdentity, std::size_t> member_numbers(const Campaign& campaign) {
    std::vector<std::string> keys;
    for (std::size_t k = 0; k < campaign.cases.size(); ++k)
        keys.push_back(case_fingerprint(campaign, static_cast<int>(k)));
    std::multimap<MemberIdentity, std::size_t> numbers;
    for (int number = 0; number < member_count(campaign); ++number) {
        const MemberKey key = member_key(campaign, number);
        numbers.emplace(MemberIdentity{keys[static_cast<std::size_t>(key.case_index)], key.arrangement},
                        static_cast<std::size_t>(number));
    }
    return numbers;
}

}  // namespace

Bytes encode(const MemberRecord& record) {
    ByteWriter out;
    out.text(record.case_key);
    out.i32(record.arrangement);
    out.i32(record.attempt);
    out.i32(record.rank);
    out.text(record.host);
    out.u64(record.peak_memory);
    write_result(out, record.result);
    return out.take();
}

MemberRecord decode_member_record(std::span<const std::byte> bytes) {
    ByteReader in(bytes);
    MemberRecord record;
    record.case_key = in.text();
    record.arrangement = in.i32();
    record.attempt = in.i32();
    record.rank = in.i32();
    record.host = in.text();
    record.peak_memory = in.u64();
    record.result = read_result(in);
    if (in.left() != 0) throw RunError("a stored member goes on after its end; it was written by another version");
    return record;
}

std::vector<const MemberRecord*> match_records(const Campaign& campaign, std::span<const MemberRecord> records) {
    std::vector<const MemberRecord*> matched(static_cast<std::size_t>(member_count(campaign)), nullptr);
    const auto numbers = member_numbers(campaign);
    for (const MemberRecord& record : records) {
        const auto [first, last] = numbers.equal_range({record.case_key, record.arrangement});
        for (auto place = first; place != last; ++place) {
            const MemberRecord*& known = matched[place->second];
            const bool better = known != nullptr && known->result.status == MemberStatus::failed &&
                                record.result.status == MemberStatus::done;
            if (known == nullptr || better) known = &record;
        }
    }
    return matched;
}

std::vector<int> last_attempts(const Campaign& campaign, std::span<const MemberRecord> records) {
    std::vector<int> attempts(static_cast<std::size_t>(member_count(campaign)), 0);
    const auto numbers = member_numbers(campaign);
    for (const MemberRecord& record : records) {
        const auto [first, last] = numbers.equal_range({record.case_key, record.arrangement});
        for (auto place = first; place != last; ++place)
            attempts[place->second] = std::max(attempts[place->second], record.attempt);
    }
    return attempts;
}

}  // namespace floes
