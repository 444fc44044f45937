#pragma once
// All that floes reads of a campaign file, as bytes to be compared.

#include <filesystem>
#include <string>

#include "campaign/write.hpp"
#include "campaign_file/read.hpp"
#include "core/bytes.hpp"

namespace floes {

inline void put_cases(const CampaignTable& table, ByteWriter& out) {
    for (const CaseRow& one : table.cases) {
        out.text(one.name);
        out.doubles(std::vector{one.cfm, one.elastic_modulus, one.time_step, one.analysis.steady_start,
                                one.analysis.window, one.analysis.peak_separation, one.contact.erp,
                                one.contact.crushing_pressure, static_cast<double>(one.analysis.segments),
                                static_cast<double>(one.analysis.history_stride), static_cast<double>(one.far_end),
                                static_cast<double>(one.contact.friction), static_cast<double>(one.contact.normal)});
        for (const std::vector<double>& row : one.shape.rows()) out.doubles(row);
    }
}

inline void put_members(const CampaignTable& table, ByteWriter& out) {
    for (const MemberRow& row : table.members) {
        out.i32(row.case_index);
        out.i32(row.arrangement);
        out.i32(static_cast<int>(row.status));
        out.i32(row.load.steady ? 1 : 0);
        out.text(row.reason);
        for (const Quantity& one : table.quantities()) out.f64(row.value(one));
        for (const std::vector<double>* values : {&row.load.segment_maximum, &row.steps_above, &row.upcrossings})
            out.doubles(*values);
        for (const AveragedLoad& one : row.averaged) {
            out.doubles(one.segment_maximum);
            out.doubles(one.peaks);
        }
    }
}

inline Bytes table_read(const std::filesystem::path& path) {
    ByteWriter out;
    const CampaignTable table = read_campaign_file(path);
    out.text(table.title);
    out.doubles(table.levels);
    out.doubles(table.averaging_times);
    put_cases(table, out);
    put_members(table, out);
    return out.take();
}

inline Bytes origin_read(const std::filesystem::path& path) {
    ByteWriter out;
    const CampaignOrigin origin = read_origin(path);
    out.text(origin.configuration);
    for (const auto& [name, value] : origin.facts) out.text(name + value);
    return out.take();
}

inline Bytes campaign_read(const std::filesystem::path& path) {
    ByteWriter out;
    out.text(write_campaign(CampaignFile(path).campaign()));
    return out.take();
}

inline Bytes wall_times_read(const std::filesystem::path& path) {
    ByteWriter out;
    out.doubles(read_wall_times(path));
    return out.take();
}

inline Bytes poses_read(const std::filesystem::path& path) {
    ByteWriter out;
    for (const PlanarPose& pose : read_poses(path, 0)) out.doubles(std::vector{pose.x, pose.z, pose.yaw});
    return out.take();
}

inline Bytes breaks_read(const std::filesystem::path& path) {
    ByteWriter out;
    for (const BreakRow& row : read_breaks(path)) {
        out.f64(row.time);
        for (const int number : {row.member, row.floe, row.joint, row.mode}) out.i32(number);
    }
    return out.take();
}

inline Bytes pieces_read(const std::filesystem::path& path) {
    ByteWriter out;
    for (const PieceRow& row : read_pieces(path)) {
        out.i32(row.member);
        out.i32(row.floe);
        out.doubles(std::vector{row.area});
    }
    return out.take();
}

inline Bytes histories_read(const std::filesystem::path& path) {
    ByteWriter out;
    for_each_history(path, [&](const StoredHistory& history) { out.doubles(history.values); });
    return out.take();
}

inline Bytes load_maps_read(const std::filesystem::path& path) {
    ByteWriter out;
    for_each_load_map(path, [&](int member, const LoadMap& map) {
        out.i32(member);
        for (const std::vector<double>* values : {&map.surge, &map.normal, &map.along_tow}) out.doubles(*values);
    });
    return out.take();
}

/// What there is to read of a file, each as bytes. They throw as the readers do.
inline constexpr Bytes (*parts_read[])(const std::filesystem::path&){table_read,     origin_read,    wall_times_read,
                                                                     poses_read,     breaks_read,    pieces_read,
                                                                     histories_read, load_maps_read, campaign_read};

inline Bytes everything_read(const std::filesystem::path& path) {
    ByteWriter out;
    for (const auto& read : parts_read) out.blob(read(path));
    return out.take();
}

}  // namespace floes
