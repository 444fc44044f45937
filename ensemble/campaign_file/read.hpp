#pragma once
// A campaign file as it is read.

#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "campaign/campaign.hpp"
#include "campaign_file/campaign_table.hpp"
#include "campaign_file/content.hpp"
#include "core/vector.hpp"
#include "hdf5/handle.hpp"
#include "hdf5/read.hpp"
#include "statistics/load_map.hpp"

namespace floes {

// A campaign file, open for reading. To open it costs: its digests of pages are read, or without them a process of its
// own tries whether HDF5 survives it. So who reads several things of a file opens it once.

class CampaignFile {
  public:
    /// Also implicitly, for who reads one thing only. Throws InputError when there is no such file, it is no campaign
    /// file, or its major version is not this program's.
    CampaignFile(const std::filesystem::path& path);
    ~CampaignFile();

    const std::filesystem::path& path() const { return path_; }
    /// That the file's own configuration describes.
    const Campaign& campaign() const;
    /// Its identifier in HDF5. For this module only.
    std::int64_t id() const;

  private:
    struct Opened;

    std::filesystem::path path_;
    std::unique_ptr<const Opened> opened_;
};

/// For each member, in member order.
std::vector<RowStatus> read_states(const CampaignFile& file);

// What a report wants of a campaign file beside its table: the configuration, who made it, one arrangement, the breaks.

/// How the file came about, as /provenance has it.
struct CampaignOrigin {
    std::string configuration;                               ///< resolved TOML: running it gives the same members
    std::vector<std::pair<std::string, std::string>> facts;  ///< attribute and value: date, revision, libraries, …
};

/// Throws as read_campaign_file() does; so do the others.
CampaignOrigin read_origin(const CampaignFile& file);

/// Where the floes of a member lay at the start; none where that is not known.
std::vector<PlanarPose> read_poses(const CampaignFile& file, int member);

/// Wall time of each member, s, in member order.
std::vector<double> read_wall_times(const CampaignFile& file);

struct BreakRow {
    int member = 0;
    double time = 0;  ///< s
    int floe = 0;
    int joint = 0;  ///< within the floe, as its CutFloe has it
    int mode = 0;   ///< as /breaks/mode: 0 bending, 1 shear, 2 compression, …
};

/// All breaks of done members in order of member and time; empty where the file keeps none.
std::vector<BreakRow> read_breaks(const CampaignFile& file);

struct PieceRow {
    int member = 0;
    int floe = 0;
    double area = 0;  ///< m²
};

/// The pieces of all floes that cracked through, in order of member and floe; empty where the file keeps none.
std::vector<PieceRow> read_pieces(const CampaignFile& file);

// The histories of a campaign file, member by member: all of them at once may not fit into memory.

struct StoredHistory {
    int member = 0;
    double step = 0;                 ///< s from value to value: the case's Δt times its history_stride
    std::span<const double> values;  ///< SI, from t = 0 to the end of the run; means over history_stride steps each
};

/// Calls `use` for each done member with the stored history, in member order: never where the file has none, so that
/// who reads must say when there was none. Of others than the members that `wanted` takes, if there is such a function,
/// nothing is read. Throws as read_campaign_file() does.
void for_each_history(const CampaignFile& file, const ArrayOutput& of,
                      const std::function<void(const StoredHistory&)>& use,
                      const std::function<bool(int member)>& wanted = {});
/// Of the surge load.
void for_each_history(const CampaignFile& file, const std::function<void(const StoredHistory&)>& use);

/// The same of several histories of each member, for those that have them all; `values`: one history after the other.
struct StoredHistories {
    int member = 0;
    double step = 0;  ///< s
    std::vector<std::span<const double>> values;
};
void for_each_histories(const CampaignFile& file, std::span<const ArrayOutput* const> of,
                        const std::function<bool(int member)>& wanted,
                        const std::function<void(const StoredHistories&)>& use);

// Where the load of each member acts, as the campaign file has it.

/// Calls `use` with the number and the load map of each done member that has one, in member order. Throws as
/// read_campaign_file() does.
void for_each_load_map(const CampaignFile& file, const std::function<void(int member, const LoadMap&)>& use);

// Reads the table of a campaign file.

/// Throws RunError where it is damaged; so do the readers of the file's other parts.
CampaignTable read_campaign_file(const CampaignFile& file);

// The loads of a campaign file in other windows than those it was run with.

/// The part of a history that lies in the window, which ends the run.
std::span<const double> in_window(const StoredHistory& history, const Analysis& analysis);

/// The table of the file with every done member's surge load, the steps that it counted above levels, and how its
/// structure gave way measured anew in the window of its case: `windows`, one a case, each ending the run. Loads of
/// parts, moments, heave and sway loads, work and the ice keep the window that was run. Throws
/// InputError for histories that are thinned, since maxima and deviations need every step.
CampaignTable measured_anew(const CampaignFile& file, CampaignTable table, const std::vector<Analysis>& windows);

}  // namespace floes
