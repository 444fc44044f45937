#include "campaign_file/publish.hpp"

#include <algorithm>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include <fmt/format.h>

#include "campaign_file/content.hpp"
#include "campaign_file/kinds.hpp"
#include "campaign_file/pieces.hpp"
#include "campaign_file/read.hpp"
#include "core/error.hpp"
#include "hdf5/handle.hpp"
#include "hdf5/pages.hpp"
#include "hdf5/read.hpp"
#include "store/file_calls.hpp"

namespace floes {
namespace {

/// The groups of all that members yield, the quantities first.
void add_member_groups(hid_t file, const CampaignContent& content, const CampaignScales& scales, MemberTables& tables) {
    const auto checksums =
        content.is_piece() ? std::make_shared<const hdf5::Handle>(hdf5::create_group(file, checksums_group)) : nullptr;
    std::vector<std::string_view> groups{"members"};
    for (const ArrayOutput& array : array_outputs)
        if (array.in_file() && content.has(array) && std::ranges::find(groups, array.group()) == groups.end())
            groups.push_back(array.group());
    for (const std::string_view name : groups) {
        const hdf5::Handle group = hdf5::create_group(file, std::string(name));
        if (name == "members") add_members(group.id(), scales, tables);
        if (name == "arrangements") add_arrangement_numbers(group.id(), content, scales, tables);
        add_arrays(group.id(), name, content, scales, tables, checksums);
    }
}

void write_members(const CampaignContent& content, const MemberTables& tables) {
    for (std::size_t row = 0; row < content.records.size(); ++row) {
        const std::size_t member = content.first_row() + row;
        std::optional<MemberRecord> record;
        if (const auto known = content.records[row]) record = content.members->read(*known);
        const MemberRecord* found = record ? &*record : nullptr;
        tables.write({member, row, found, content.rows.row(member, found)});
    }
    tables.finish();
}

/// Which pieces have the rows.
void write_piece_list(hid_t file, std::span<const FilePiece> pieces) {
    const hdf5::Handle group(H5Gopen2(file, "provenance", H5P_DEFAULT), H5Gclose, "H5Gopen", "provenance");
    std::vector<std::string> files;
    for (const FilePiece& piece : pieces) files.push_back(piece.file);
    const hdf5::Scale scale = hdf5::write_scale(
        group.id(), {"piece", "1", "file with some of the rows, relative to the folder of this one"}, files);
    write_columns(group.id(), scale, pieces, piece_columns);
}

/// All but the digests of what lies in pieces, and of the whole. Returns the file, still open.
hdf5::Handle write_contents(const std::filesystem::path& path, const CampaignContent& content,
                            std::span<const Session> sessions, std::span<const CalibrationRecord> calibrations) {
    hdf5::Handle file = hdf5::create_file(path);
    // All handles are closed before the file is: only then does closing write everything.
    hdf5::write_kind(file.id(), content.is_piece() ? piece_kind : campaign_kind, content.campaign.name);
    hdf5::write_attribute(file.id(), "fingerprint", fingerprint(content.campaign));
    const CampaignScales scales(file.id(), content);
    MemberTables tables;
    write_cases(file.id(), content, scales);
    add_member_groups(file.id(), content, scales, tables);
    write_calibration(file.id(), content, calibrations);
    add_provenance(file.id(), content, sessions, tables);
    if (content.pieces.empty()) write_members(content, tables);
    if (!content.pieces.empty()) write_piece_list(file.id(), content.pieces);
    return file;
}

/// Ends a file that has everything but the digests of the whole, and returns that of its contents.
std::string complete(hdf5::Handle file, const std::filesystem::path& path) {
    hdf5::write_contents_digests(file.id());
    const std::string digest = hdf5::read_contents_digests(file.id()).contents;
    file.close("H5Fclose", path.string());
    hdf5::append_page_digests(path);
    return digest;
}

/// Has `write` make the file aside and gives it its name.
void replace_published(const std::filesystem::path& path,
                       const std::function<void(const std::filesystem::path& aside)>& write,
                       const System& system = this_system()) {
    const hdf5::QuietErrors quiet;
    try {
        replace_file(path, path.string() + ".tmp", write, system);
    } catch (const std::runtime_error& error) {
        throw RunError(
            fmt::format("{} cannot be written: {}. Every member that is done lies in the journal beside it; make "
                        "room, and the same command with --resume, or the same merge, writes the file.",
                        path.string(), error.what()));
    }
}

}  // namespace

void write_content(const std::filesystem::path& path, const Campaign& campaign, const StoredMembers& members,
                   std::span<const Session> sessions, std::span<const CalibrationRecord> calibrations) {
    const CampaignContent content(campaign, members);
    complete(write_contents(path, content, sessions, calibrations), path);
}

void publish(const std::filesystem::path& path, const Campaign& campaign, const StoredMembers& members,
             std::span<const Session> sessions, std::span<const CalibrationRecord> calibrations, const System& system,
             const ContentWriter& write) {
    replace_published(
        path, [&](const std::filesystem::path& aside) { write(aside, campaign, members, sessions, calibrations); },
        system);
    if (&system == &this_system()) remove_pieces(path);
}

FilePiece publish_piece(const std::filesystem::path& campaign_file, const std::string& name, const Campaign& campaign,
                        const StoredMembers& members, PieceRows rows) {
    const CampaignContent content(campaign, members, std::move(rows));
    FilePiece piece{.file = name, .digest = {}, .first = content.first, .count = content.count, .found = {}};
    for (std::size_t k = 0; k < found_axes.size(); ++k) piece.found[k] = content.found(*found_axes[k]);
    replace_published(path_of_piece(campaign_file, piece), [&](const std::filesystem::path& aside) {
        piece.digest = complete(write_contents(aside, content, {}, {}), aside);
    });
    return piece;
}

namespace {

/// Paths of the datasets that have no digest yet.
std::vector<std::string> without_digest(hid_t file) {
    std::vector<std::string> found;
    for (const std::string& path : hdf5::paths_of(file).datasets)
        if (!hdf5::has_attribute(hdf5::open_dataset(file, path).id(), hdf5::digest_attribute)) found.push_back(path);
    return found;
}

hdf5::Handle open_again(const std::filesystem::path& path, unsigned how) {
    const hdf5::Handle access = how == H5F_ACC_RDWR ? hdf5::access_for_writing() : hdf5::access_without_locks();
    return {H5Fopen(path.c_str(), how, access.id()), H5Fclose, "H5Fopen", path.string()};
}

/// The checksums that pieces keep of the rows of a dataset, as its digest; none where they keep none.
std::optional<hdf5::StoredDigest> digest_of_rows(const hdf5::Handle& dataset, const std::string& path,
                                                 std::span<const hdf5::Handle> pieces) {
    const std::string kept = fmt::format("{}/{}", checksums_group, checksums_name(path.substr(1)));
    if (!hdf5::exists(pieces.front().id(), kept)) return std::nullopt;
    hdf5::DatasetDigest digest(hdf5::DigestKind::rows);
    for (const hdf5::Handle& piece : pieces)
        for (const std::int32_t row : hdf5::read_values<std::int32_t>(piece.id(), kept))
            digest.add_row(static_cast<std::uint32_t>(row));
    return digest.finish(dataset.id());
}

}  // namespace

DatasetDigests digests_over_pieces(const std::filesystem::path& file, std::span<const FilePiece> pieces,
                                   std::span<const std::string> datasets) {
    const hdf5::QuietErrors quiet;
    const hdf5::Handle opened = open_again(file, H5F_ACC_RDONLY);
    std::vector<hdf5::Handle> sources;  // open meanwhile, so that HDF5 opens them once
    for (const FilePiece& piece : pieces) sources.push_back(open_again(path_of_piece(file, piece), H5F_ACC_RDONLY));
    DatasetDigests digests;
    for (const std::string& path : datasets) {
        const hdf5::Handle dataset = hdf5::open_dataset(opened.id(), path);
        const auto of_rows = digest_of_rows(dataset, path, sources);
        digests[path] = hdf5::digest_text(of_rows ? *of_rows : hdf5::digest_of(dataset, hdf5::DigestKind::values));
    }
    return digests;
}

void publish_over_pieces(const std::filesystem::path& campaign_file, const Campaign& campaign,
                         std::span<const FilePiece> pieces, const FoundSizes& most, std::span<const Session> sessions,
                         std::span<const CalibrationRecord> calibrations, const DigestsOver& digests) {
    const CampaignContent content(campaign, pieces, most);
    const auto write = [&](const std::filesystem::path& aside) {
        std::vector<std::string> open;
        {
            hdf5::Handle file = write_contents(aside, content, sessions, calibrations);
            open = without_digest(file.id());
            file.close("H5Fclose", aside.string());
        }
        const DatasetDigests found = digests(aside, open);
        hdf5::Handle file = open_again(aside, H5F_ACC_RDWR);
        for (const std::string& path : open)
            hdf5::write_attribute(hdf5::open_dataset(file.id(), path).id(), hdf5::digest_attribute, found.at(path));
        complete(std::move(file), aside);
    };
    // Beside the pieces, which it names relative to its folder.
    replace_published(target_of(campaign_file), [&](const std::filesystem::path& aside) {
        try {
            write(aside);
        } catch (...) {
            remove_those(campaign_file, pieces);  // on a full disk the journals need the room
            throw;
        }
    });
    remove_pieces(campaign_file, pieces);
}

}  // namespace floes
