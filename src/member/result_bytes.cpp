#include "member/result_bytes.hpp"

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
constexpr std::size_t level_bytes = 2 * 4;

std::uint8_t read_below(ByteReader& in, std::uint8_t limit) {
    const std::uint8_t value = in.u8();
    if (value >= limit) throw RunError("a stored member has a state that does not exist; it was damaged");
    return value;
}

}  // namespace

void write(ByteWriter& out, const MemberResult& result) {
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
    out.f64(result.cpu_time);
    out.f64(result.load.skewness);
    out.f64(result.load.excess_kurtosis);
    out.u64(result.levels.size());
    for (const LevelCount& count : result.levels) {
        out.i32(count.steps_above);
        out.i32(count.upcrossings);
    }
}

MemberResult read_member_result(ByteReader& in) {
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
    // Journals from before it was measured end here,
    result.cpu_time = in.left() > 0 ? in.f64() : MemberResult::not_measured;
    result.load.skewness = MemberResult::not_measured;
    result.load.excess_kurtosis = MemberResult::not_measured;
    if (in.left() == 0) return result;  // and those from before these here.
    result.load.skewness = in.f64();
    result.load.excess_kurtosis = in.f64();
    result.levels.resize(in.count(level_bytes));
    for (LevelCount& count : result.levels) {
        count.steps_above = in.i32();
        count.upcrossings = in.i32();
    }
    return result;
}

}  // namespace floes
