#pragma once
// Writes the campaign file: one HDF5 file for a whole campaign.

#include <filesystem>
#include <functional>
#include <span>

#include "campaign/campaign.hpp"
#include "store/member_record.hpp"
#include "store/session.hpp"
#include "store/system.hpp"

namespace floes {

/// What makes a campaign file's content at a path.
using ContentWriter = std::function<void(const std::filesystem::path&, const Campaign&, const StoredMembers&,
                                         std::span<const Session>, std::span<const CalibrationRecord>)>;

/// The one of campaign files, by HDF5.
void write_content(const std::filesystem::path& path, const Campaign& campaign, const StoredMembers& members,
                   std::span<const Session> sessions, std::span<const CalibrationRecord> calibrations);

/// Writes the file aside, brings it to the disk, and renames it into place: at every moment `path` is the old file or
/// the new one, whole. Members without a record stand as missing. Outside /provenance the values depend on the campaign
/// and the results alone, not on the order or origin of the records. `sessions`: the last one is the publishing one.
/// `calibrations`: those that gave cases of the campaign their Σ stand in /calibration. Each record that counts is read
/// once, one after another in member order. Throws RunError naming the call that failed. `write`: to a simulated system
/// HDF5 cannot.
void publish(const std::filesystem::path& path, const Campaign& campaign, const StoredMembers& members,
             std::span<const Session> sessions, std::span<const CalibrationRecord> calibrations = {},
             const System& system = this_system(), const ContentWriter& write = write_content);

}  // namespace floes
