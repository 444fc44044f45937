#include "campaign_file/read_details.hpp"

#include "campaign_file/arrangement_rows.hpp"
#include "campaign_file/read_arrays.hpp"
#include "hdf5/columns.hpp"
#include "quantities/member_outputs.hpp"

namespace floes {
namespace {

constexpr auto last_mode = static_cast<std::int8_t>(std::size(failure_mode_names) - 1);

constexpr const char* told_facts[]{"date",  "floes", "git_revision", "machine", "compiler", "compiler_flags", "bullet",
                                   "eigen", "hdf5",  "tbb",          "boost",   "mpi",      "math_library",   "seed"};

std::string fact(hid_t group, const char* name) {
    const hdf5::Handle attribute(hdf5::check_read(H5Aopen(group, name, H5P_DEFAULT), group, name), H5Aclose, "H5Aopen",
                                 name);
    const hdf5::Handle type(H5Aget_type(attribute.id()), H5Tclose, "H5Aget_type", name);
    if (H5Tget_class(type.id()) == H5T_STRING) return hdf5::read_text_attribute(group, name);
    if (H5Aget_storage_size(attribute.id()) != sizeof(std::uint64_t))
        hdf5::refuse_damaged(group, fmt::format("the attribute {} is no single number", name));
    std::uint64_t number = 0;
    hdf5::check_read(H5Aread(attribute.id(), hdf5::native_type<std::uint64_t>(), &number), group, name);
    return std::to_string(number);
}

}  // namespace

CampaignOrigin read_origin(const CampaignFile& file) {
    const hdf5::QuietErrors quiet;
    const hdf5::Handle group(
        hdf5::check_read(H5Gopen2(file.id(), "provenance", H5P_DEFAULT), file.id(), "the group provenance"), H5Gclose,
        "H5Gopen", "provenance");
    CampaignOrigin origin;
    origin.configuration = hdf5::read_text(file.id(), "provenance/configuration");
    for (const char* name : told_facts) {
        if (hdf5::has_attribute(group.id(), name)) origin.facts.emplace_back(name, fact(group.id(), name));
    }
    return origin;
}

std::vector<PlanarPose> read_poses(const CampaignFile& file, int member) {
    const hdf5::QuietErrors quiet;
    const ArrayPlaces places(file.campaign());
    const MemberKey key = member_key(file.campaign(), member);
    MemberResult result;
    ArrayReader(file, array_output("arrangements/pose"), places)
        .read(static_cast<std::size_t>(ArrangementRows(file.campaign()).row(key)), key.case_index, result);
    return result.arrangement;
}

std::vector<double> read_wall_times(const CampaignFile& file) {
    const hdf5::QuietErrors quiet;
    return hdf5::read_values<double>(file.id(), "provenance/wall_time");
}

std::vector<BreakRow> read_breaks(const CampaignFile& file) {
    const hdf5::QuietErrors quiet;
    const auto member = hdf5::read_values<std::int32_t>(file.id(), "breaks/member");
    const auto time = hdf5::read_column<double>(file.id(), "breaks/time", member.size());
    const auto floe = hdf5::read_column<std::int32_t>(file.id(), "breaks/floe", member.size());
    const auto joint = hdf5::read_column<std::int32_t>(file.id(), "breaks/joint", member.size());
    const auto mode = hdf5::read_numbers<std::int8_t>(file.id(), "breaks/mode", member.size(), 0, last_mode);
    std::vector<BreakRow> rows;
    for (std::size_t i = 0; i < member.size(); ++i)
        rows.push_back({member[i], time.at(i), floe.at(i), joint.at(i), mode.at(i)});
    return rows;
}

std::vector<PieceRow> read_pieces(const CampaignFile& file) {
    const hdf5::QuietErrors quiet;
    if (!hdf5::exists(file.id(), "pieces")) return {};
    const auto member = hdf5::read_values<std::int32_t>(file.id(), "pieces/member");
    const auto floe = hdf5::read_column<std::int32_t>(file.id(), "pieces/floe", member.size());
    const auto area = hdf5::read_column<double>(file.id(), "pieces/area", member.size());
    std::vector<PieceRow> rows;
    for (std::size_t i = 0; i < member.size(); ++i) rows.push_back({member[i], floe.at(i), area.at(i)});
    return rows;
}

}  // namespace floes
