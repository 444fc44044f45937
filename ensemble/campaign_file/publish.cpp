#include <algorithm>
#include <string>
#include <string_view>
#include <vector>

#include <fmt/format.h>

#include "campaign_file/content.hpp"
#include "campaign_file/publish.hpp"
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
    std::vector<std::string_view> groups{"members"};
    for (const ArrayOutput& array : array_outputs)
        if (array.in_file() && content.has(array) && std::ranges::find(groups, array.group()) == groups.end())
            groups.push_back(array.group());
    for (const std::string_view name : groups) {
        const hdf5::Handle group = hdf5::create_group(file, std::string(name));
        if (name == "members") add_members(group.id(), scales, tables);
        if (name == "arrangements") add_arrangement_numbers(group.id(), content, scales, tables);
        add_arrays(group.id(), name, content, scales, tables);
    }
}

void write_members(const CampaignContent& content, const MemberTables& tables) {
    for (std::size_t member = 0; member < content.records.size(); ++member) {
        std::optional<MemberRecord> record;
        if (const auto known = content.records[member]) record = content.members.read(*known);
        const MemberRecord* found = record ? &*record : nullptr;
        tables.write({member, found, content.rows.row(member, found)});
    }
    tables.finish();
}

}  // namespace

void write_content(const std::filesystem::path& path, const Campaign& campaign, const StoredMembers& members,
                   std::span<const Session> sessions, std::span<const CalibrationRecord> calibrations) {
    const CampaignContent content(campaign, members);
    const hdf5::QuietErrors quiet;
    hdf5::Handle file = hdf5::create_file(path);
    {
        // All handles are closed before the file is: only then does closing write everything.
        hdf5::write_kind(file.id(), campaign_kind, content.campaign.name);
        hdf5::write_attribute(file.id(), "fingerprint", fingerprint(content.campaign));
        const CampaignScales scales(file.id(), content);
        MemberTables tables;
        write_cases(file.id(), content, scales);
        add_member_groups(file.id(), content, scales, tables);
        write_calibration(file.id(), content, calibrations);
        add_provenance(file.id(), content, sessions, tables);
        write_members(content, tables);
        hdf5::write_contents_digests(file.id());
    }
    file.close("H5Fclose", path.string());
    hdf5::append_page_digests(path);
}

void publish(const std::filesystem::path& path, const Campaign& campaign, const StoredMembers& members,
             std::span<const Session> sessions, std::span<const CalibrationRecord> calibrations, const System& system,
             const ContentWriter& write) {
    try {
        replace_file(
            path, path.string() + ".tmp",
            [&](const std::filesystem::path& aside) { write(aside, campaign, members, sessions, calibrations); },
            system);
    } catch (const RunError& error) {
        throw RunError(
            fmt::format("{} cannot be written: {}. Every member that is done lies in the journal beside it; make "
                        "room, and the same command with --resume, or the same merge, writes the file.",
                        path.string(), error.what()));
    }
}

}  // namespace floes
