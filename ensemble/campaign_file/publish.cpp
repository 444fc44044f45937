#include <fcntl.h>

#include <filesystem>

#include "campaign/identity.hpp"
#include "campaign_file/campaign_content.hpp"
#include "campaign_file/campaign_kind.hpp"
#include "campaign_file/publish.hpp"
#include "core/error.hpp"
#include "hdf5/contents.hpp"
#include "hdf5/kind.hpp"
#include "hdf5/pages.hpp"
#include "records/file_calls.hpp"

namespace floes {
namespace {

void write_file(const std::filesystem::path& path, CampaignContent& content, std::span<const Session> sessions,
                std::span<const CalibrationRecord> calibrations, const HistoryOf& history_of) {
    const hdf5::QuietErrors quiet;
    hdf5::Handle file = hdf5::create_file(path);
    {
        // All handles are closed before the file is: only then does closing write everything.
        hdf5::write_kind(file.id(), campaign_kind, content.campaign.name);
        hdf5::write_attribute(file.id(), "fingerprint", fingerprint(content.campaign));
        const CampaignScales scales(file.id(), content);
        write_members(file.id(), content, scales);
        write_levels(file.id(), content, scales);
        write_averaged(file.id(), content, scales);
        write_cases(file.id(), content, scales);
        write_arrangements(file.id(), content, scales);
        write_history(file.id(), content, scales, history_of);
        write_breaks(file.id(), content, scales);
        write_calibration(file.id(), content, calibrations);
        write_provenance(file.id(), content, sessions);
        hdf5::write_contents_digests(file.id());
    }
    file.close("H5Fclose", path.string());
    hdf5::append_page_digests(path);
}

}  // namespace

void publish(const std::filesystem::path& path, const Campaign& campaign, std::span<const MemberRecord> records,
             std::span<const Session> sessions, std::span<const CalibrationRecord> calibrations,
             const HistoryOf& history_of) {
    CampaignContent content(campaign, records);
    const std::filesystem::path aside = path.string() + ".tmp";
    try {
        write_file(aside, content, sessions, calibrations, history_of);
        sync_data(open_file(aside, O_RDWR), aside);
    } catch (const RunError&) {
        std::error_code ignored;
        std::filesystem::remove(aside, ignored);  // on a full disk the journal needs the room
        throw;
    }
    rename_into_place(aside, path);
}

}  // namespace floes
