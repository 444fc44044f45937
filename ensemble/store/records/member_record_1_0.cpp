// Records of floes 1.0, whose arrays each had a place of their own.

#include "core/error.hpp"
#include "member/result_bytes.hpp"
#include "records/record_head.hpp"

namespace floes {
namespace {

constexpr std::size_t break_bytes = 8 + 4 + 4 + 1;
constexpr std::size_t pose_bytes = 3 * 8;
constexpr std::size_t level_bytes = 2 * 4;
constexpr std::size_t averaged_bytes = 4 * 8 + 8;  // at least

/// Its histories were packed, and stood behind it.
void read_unpacked_histories(ByteReader& in, MemberResult& result) {
    for (auto* history : {&result.history.surge, &result.history.sway, &result.history.heave}) *history = in.doubles();
}

/// Only three modes had a total; every failure is among the events.
void read_breaks(ByteReader& in, MemberResult& result) {
    result.breaks.resize(in.count(break_bytes));
    result.failures = {};
    for (BreakEvent& event : result.breaks) {
        event.time = in.f64();
        event.floe = in.i32();
        event.joint = in.i32();
        event.mode = as_field<FailureMode>(in.u8());
        ++result.failures[static_cast<std::size_t>(event.mode)];
    }
}

void read_poses(ByteReader& in, MemberResult& result) {
    result.arrangement.resize(in.count(pose_bytes));
    for (PlanarPose& pose : result.arrangement) {
        pose.x = in.f64();
        pose.z = in.f64();
        pose.yaw = in.f64();
    }
}

void read_levels(ByteReader& in, MemberResult& result) {
    result.levels.resize(in.count(level_bytes));
    for (LevelCount& count : result.levels) {
        count.steps_above = in.i32();
        count.upcrossings = in.i32();
    }
}

void read_averaged(ByteReader& in, MemberResult& result) {
    result.averaged.resize(in.count(averaged_bytes));
    for (AveragedLoad& one : result.averaged) {
        for (double* value : {&one.time, &one.sd, &one.mean_maximum, &one.sd_maximum}) *value = in.f64();
        one.segment_maximum = in.doubles();
    }
    for (AveragedLoad& one : result.averaged) one.peaks = in.doubles();
}

PackedArray read_packed(ByteReader& in, std::vector<std::size_t> sizes) {
    PackedArray array{std::move(sizes), {}};
    array.numbers.count = in.u64();
    array.numbers.chunk = in.blob();
    if (array.sizes.empty()) array.sizes = {static_cast<std::size_t>(array.numbers.count)};
    return array;
}

}  // namespace

MemberRecord decode_member_record_1_0(std::span<const std::byte> bytes) {
    ByteReader in(bytes);
    MemberRecord record = read_head(in);
    record.result = read_outcome(in);
    MemberResult& result = record.result;
    result.load.segment_maximum = in.doubles();
    read_unpacked_histories(in, result);
    read_breaks(in, result);
    read_poses(in, result);
    result.psi4 = in.f64();
    result.wall_time = in.f64();
    result.cpu_time = in.f64();
    read_levels(in, result);
    const auto read = [&](std::string_view path, std::vector<std::size_t> sizes = {}) {
        PackedArray array = read_packed(in, std::move(sizes));
        if (array.empty()) return;
        const std::size_t number = array_number(path);
        check_sizes(array_outputs[number], array.sizes, array.numbers.count);
        record.arrays[number] = std::move(array);
    };
    for (const char* path : {"history/surge_load", "history/sway_load", "history/heave_load"}) read(path);
    read_averaged(in, result);
    if (in.left() > 0) {
        for (const char* path : {"load_map/surge_load", "load_map/normal_force"})
            read(path, {LoadMap::heights, LoadMap::angles});
        read("load_map/surge_load_along_tow");
    }
    if (in.left() != 0) throw RunError("a stored member is longer than expected; it was written by another version");
    PackedArrays others = take_arrays(result);
    for (std::size_t k = 0; k < others.size(); ++k)
        if (record.arrays[k].empty()) record.arrays[k] = std::move(others[k]);
    return record;
}

}  // namespace floes
