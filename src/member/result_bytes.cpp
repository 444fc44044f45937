#include "member/result_bytes.hpp"

#include "core/error.hpp"
#include "quantities/quantity.hpp"

namespace floes {
namespace {

constexpr std::size_t break_bytes = 8 + 4 + 4 + 1;
constexpr std::size_t pose_bytes = 3 * 8;
constexpr std::size_t level_bytes = 2 * 4;
constexpr std::size_t averaged_bytes = 4 * 8 + 8;  // at least

std::uint8_t read_below(ByteReader& in, std::uint8_t limit) {
    const std::uint8_t value = in.u8();
    if (value >= limit) throw RunError("a stored member has an unknown state; it was damaged");
    return value;
}

void put(const Quantity& one, MemberOutputs& outputs, double value) {
    if (!one.place.holds(value)) throw RunError("a stored member has a count beyond all counts; it was damaged");
    one.place.set(outputs, value);
}

/// Writes each with its key, so that a reader of another version can identify it.
void write_quantities(ByteWriter& out, const MemberOutputs& outputs) {
    out.u32(static_cast<std::uint32_t>(quantities.size()));
    for (const Quantity& one : quantities) {
        out.text(one.key.view());
        out.f64(one.of(outputs));
    }
}

/// Quantities missing in the bytes are NaN; keys unknown to this version are skipped.
void read_quantities(ByteReader& in, MemberOutputs& outputs) {
    outputs = unmeasured(0);
    for (std::uint32_t left = in.u32(); left > 0; --left) {
        const Quantity* known = find_quantity(in.text());
        const double value = in.f64();
        if (known != nullptr) put(*known, outputs, value);
    }
}

void write_record(ByteWriter& out, const MemberResult& result) {
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

void read_record(ByteReader& in, MemberResult& result) {
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
}

void read_levels(ByteReader& in, MemberResult& result) {
    result.levels.resize(in.count(level_bytes));
    for (LevelCount& count : result.levels) {
        count.steps_above = in.i32();
        count.upcrossings = in.i32();
    }
}

}  // namespace

void write(ByteWriter& out, const MemberResult& result) {
    out.u8(static_cast<std::uint8_t>(result.status));
    out.text(result.reason);
    write_quantities(out, result);
    out.u8(result.load.steady ? 1 : 0);
    out.doubles(result.load.segment_maximum);
    write_record(out, result);
    out.f64(result.cpu_time);
    out.u64(result.levels.size());
    for (const LevelCount& count : result.levels) {
        out.i32(count.steps_above);
        out.i32(count.upcrossings);
    }
}

MemberResult read_member_result(ByteReader& in) {
    MemberResult result;
    result.status = static_cast<MemberStatus>(read_below(in, 2));
    result.reason = in.text();
    read_quantities(in, result);
    result.load.steady = read_below(in, 2) == 1;
    result.load.segment_maximum = in.doubles();
    read_record(in, result);
    result.cpu_time = in.f64();
    read_levels(in, result);
    return result;
}

void write_averaged(ByteWriter& out, const MemberResult& result) {
    out.u64(result.averaged.size());
    for (const AveragedLoad& one : result.averaged) {
        for (const double value : {one.time, one.sd, one.mean_maximum, one.sd_maximum}) out.f64(value);
        out.doubles(one.segment_maximum);
    }
    for (const AveragedLoad& one : result.averaged) out.doubles(one.peaks);
}

void read_averaged(ByteReader& in, MemberResult& result) {
    if (in.left() == 0) return;
    result.averaged.resize(in.count(averaged_bytes));
    for (AveragedLoad& one : result.averaged) {
        for (double* value : {&one.time, &one.sd, &one.mean_maximum, &one.sd_maximum}) *value = in.f64();
        one.segment_maximum = in.doubles();
    }
    if (in.left() == 0) return;  // from before peaks were taken
    for (AveragedLoad& one : result.averaged) one.peaks = in.doubles();
}

void write_load_map(ByteWriter& out, const MemberResult& result) {
    for (const auto* part : {&result.load_map.surge, &result.load_map.normal, &result.load_map.along_tow})
        out.doubles(*part);
}

void read_load_map(ByteReader& in, MemberResult& result) {
    for (auto* part : {&result.load_map.surge, &result.load_map.normal, &result.load_map.along_tow})
        *part = in.doubles();
}

MemberResult read_older_member_result(ByteReader& in) {
    MemberResult result;
    static_cast<MemberOutputs&>(result) = unmeasured(0);
    const auto take = [&](const Quantity& one, double value) { one.place.set(result, value); };
    result.status = static_cast<MemberStatus>(read_below(in, 2));
    result.reason = in.text();
    for (const Quantity* one :
         {&quantity("mean_load"), &quantity("sd_load"), &quantity("maximum_load"), &quantity("mean_maximum"),
          &quantity("sd_maximum"), &quantity("trend"), &quantity("trend_p")})
        take(*one, in.f64());
    result.load.steady = read_below(in, 2) == 1;
    result.load.segment_maximum = in.doubles();
    for (const Quantity* one : {&quantity("mean_sway"), &quantity("mean_heave"), &quantity("failure_ratio")})
        take(*one, in.f64());
    for (const Quantity* one :
         {&quantity("failures_bending"), &quantity("failures_shear"), &quantity("failures_compression")})
        take(*one, in.i32());
    for (const Quantity* one :
         {&quantity("peak_compression"), &quantity("peak_tension"), &quantity("peak_shear"), &quantity("peak_bending"),
          &quantity("peak_torsion"), &quantity("peak_in_plane_bending")})
        take(*one, in.f64());
    read_record(in, result);
    // The oldest records end here,
    if (in.left() > 0) result.cpu_time = in.f64();
    if (in.left() == 0) return result;  // those of layout 1.2 here.
    take(quantity("skewness"), in.f64());
    take(quantity("excess_kurtosis"), in.f64());
    read_levels(in, result);
    return result;
}

}  // namespace floes
