#pragma once
// The arrays of members in a campaign file, by their list. For this module only.

#include <cstddef>
#include <filesystem>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "campaign/campaign.hpp"
#include "campaign_file/campaign_file.hpp"
#include "campaign_file/campaign_table.hpp"
#include "campaign_file/content.hpp"
#include "core/vector.hpp"
#include "hdf5/read.hpp"
#include "statistics/load_map.hpp"

namespace floes {

/// An array with a row for each member, or for each arrangement, read row by row.
class ArrayReader {
  public:
    /// `places`: of the file's campaign. Of an array that the file does not have every read is empty. Throws RunError
    /// where its rows do not fit the campaign.
    ArrayReader(const CampaignFile& file, const ArrayOutput& array, const ArrayPlaces& places);

    ArrayValues read(std::size_t row, int case_index);
    void read(std::size_t row, int case_index, MemberResult& into) { array_->access.set(into, read(row, case_index)); }

  private:
    const ArrayOutput* array_;
    const ArrayPlaces* places_;
    std::vector<std::size_t> sizes_;
    std::optional<hdf5::RowReader<double>> rows_;
};

/// Readers of the arrays of one group, or of one array.
std::vector<ArrayReader> array_readers(const CampaignFile& file, std::string_view group_or_path,
                                       const ArrayPlaces& places);

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

struct ArrayOutput;

struct StoredHistory {
    int member = 0;
    double step = 0;                 ///< s from value to value: the case's Δt times its history_stride
    std::span<const double> values;  ///< SI, from t = 0 to the end of the run; means over history_stride steps each
};

/// Calls `use` for each done member with the stored history, in member order: never where the file has none, so that
/// who reads must say when there was none. Throws as read_campaign_file() does.
void for_each_history(const CampaignFile& file, const ArrayOutput& of,
                      const std::function<void(const StoredHistory&)>& use);
/// Of the surge load.
void for_each_history(const CampaignFile& file, const std::function<void(const StoredHistory&)>& use);

/// The same of several histories of each member, for those that have them all; `values`: one history after the other.
struct StoredHistories {
    int member = 0;
    double step = 0;  ///< s
    std::vector<std::span<const double>> values;
};
void for_each_histories(const CampaignFile& file, std::span<const ArrayOutput* const> of,
                        const std::function<void(const StoredHistories&)>& use);

/// The loads of one member.
void with_history(const CampaignFile& file, int member, const std::function<void(const StoredHistory&)>& use);

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

/// The table of the file with every done member's surge load, and the steps that it counted above levels,
/// measured anew in the window of its case: `windows`, one a case, each ending the run. Nothing else changes. Throws
/// InputError for histories that are thinned, since maxima and deviations need every step.
CampaignTable measured_anew(const CampaignFile& file, CampaignTable table, const std::vector<Analysis>& windows);

}  // namespace floes
