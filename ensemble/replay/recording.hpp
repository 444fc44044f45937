#pragma once
// The recording of a replayed member, a file of its own in HDF5.

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "hdf5/handle.hpp"
#include "ice/ice_field.hpp"
#include "replay/asked.hpp"
#include "replay/frame_series.hpp"
#include "scenario/floes.hpp"
#include "scenario/scenario.hpp"
#include "simulation/record.hpp"
#include "simulation/sheets.hpp"

namespace floes {

inline constexpr hdf5::FileKind recording_kind{"floes replay", {1, 6}, 4, "recording of floes replay"};

// The recording of a replayed member: frames of all that there is to see, on what they stand, and the whole load
// history. A file of its own in HDF5, described in docs/replay.md. Written and read a frame at a time: a long run is
// larger than the memory.

/// Whether the file is there and is a recording, whatever its version.
bool is_recording(const std::filesystem::path& path);

/// What does not change during a run.
struct RecordingSubject {
    std::string campaign;       ///< title
    std::string fingerprint;    ///< of the campaign
    std::string configuration;  ///< TOML that gives the campaign again
    std::string case_name;
    int member = 0;
    int arrangement = 0;
    Asked asked = {};   ///< whose largest value it shows
    Scenario scenario;  ///< of the member's case
    FloeSet floes;      ///< of the member; where they lie, frames tell. Of a field without end: those that frames show
    Vec2 way = Vec2::Zero();  ///< least and largest x of the structure in the frames, of a field without end, m

    /// In a field without end, what stands beside the ice that frames show: its sides are too long for any picture.
    Channel channel() const;
    /// How far ahead of the structure's axis, and behind it, a field without end is to be seen, m.
    double seen_ahead() const { return scenario.window_ahead() + largest_side(floes); }
    double seen_behind() const { return scenario.window_behind() + largest_side(floes); }
};

/// What is known only at the end of a run.
struct RecordingOutcome {
    LoadHistory history;             ///< of every step
    std::vector<BreakEvent> breaks;  ///< in order of time
    HullHistory hull = {};           ///< of every step, of a hull that gives way
};

/// For each floe, whether a joint of it has failed by `time`, s: 1 or 0. `breaks`: in order of time.
std::vector<std::uint8_t> broken_floes(const std::vector<BreakEvent>& breaks, int floes, double time);

/// Of floes of which a frame shows an element: of a field without end those that are there then.
struct FloeCounts {
    int broken = 0;
    int all = 0;
};
FloeCounts count_floes(const Frame& frame, const IceLayout& layout, const std::vector<BreakEvent>& breaks);

/// Of level ice: pieces, of which all but one have broken off.
FloeCounts count_pieces(const Frame& frame);

/// The piece of a frame with the most elements, of equally large ones the first: of level ice what has not broken off.
int largest_piece(const Frame& frame);

/// Writes a recording beside its place and renames it when it is finished; a recording that is not leaves nothing.
class RecordingWriter {
  public:
    /// Throws RunError naming the call that failed, as the others do.
    RecordingWriter(const std::filesystem::path& path, const RecordingSubject& subject);
    RecordingWriter(const RecordingWriter&) = delete;
    RecordingWriter& operator=(const RecordingWriter&) = delete;
    ~RecordingWriter();

    void add(const Frame& frame);
    /// Frames and breaks of a field without end are in the numbers of `roll`.
    void finish(const RecordingOutcome& outcome, const FloeRoll& roll = {});

  private:
    struct Open {
        Open(hid_t file, const RecordingSubject& subject);
        RecordScales scales;
        FrameSeries series;
    };

    std::filesystem::path path_;
    std::filesystem::path aside_;
    RecordingSubject subject_;
    bool any_ = false;  ///< frame so far
    hdf5::QuietErrors quiet_;
    std::optional<hdf5::Handle> file_;
    std::optional<Open> open_;
};

class Recording {
  public:
    /// Throws InputError when there is no such file, it is no recording, or its major version is not this program's.
    explicit Recording(const std::filesystem::path& path);

    const RecordingSubject& subject() const { return subject_; }
    const RecordingOutcome& outcome() const { return outcome_; }
    const IceLayout& layout() const { return layout_; }

    int frames() const { return static_cast<int>(times_.size()); }
    double time(int frame) const { return times_.at(static_cast<std::size_t>(frame)); }  ///< s
    StructurePose structure(int frame) const;
    std::vector<FrameLine> lines(int frame) const;  ///< mooring lines that hold
    /// The frame whose time is nearest to `time`, s.
    int nearest(double time) const;
    /// Refills `frame` with frame `number`, as single precision keeps it; element angular velocities are not kept.
    void read(int number, Frame& frame) const;
    Frame read(int number) const;

  private:
    /// In a field without end, which rows of the elements are of a frame.
    struct States {
        explicit States(hid_t file);
        std::vector<std::int32_t> first;
        std::vector<std::int32_t> count;
        hdf5::RowReader<std::int32_t> element;
    };

    void check_sizes() const;
    /// The structure and the load on it.
    StructurePose moment(std::size_t number, Vec3& load) const;
    void read_elements(std::size_t number, Frame& frame) const;
    void read_contacts(std::size_t number, Frame& frame) const;

    hdf5::QuietErrors quiet_;
    hdf5::Handle file_;
    RecordingSubject subject_;
    IceLayout layout_;
    RecordingOutcome outcome_;
    std::vector<double> times_;
    // Readers keep the rows that they read last.
    mutable ElementColumns<hdf5::RowReader> elements_;
    mutable ContactColumns<hdf5::RowReader> contacts_;
    mutable std::optional<States> states_;                       ///< of a field without end
    mutable std::optional<LineColumns<hdf5::RowReader>> lines_;  ///< of a structure with mooring lines
    std::vector<std::vector<double>> numbers_;                   ///< of frame_numbers
    std::vector<std::int32_t> step_;
    std::vector<std::int32_t> first_contact_;
    std::vector<std::int32_t> contact_count_;
};

}  // namespace floes
