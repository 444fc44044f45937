#pragma once
// The record of a replayed member: frames of all that there is to see, on what they stand, and the whole load history.
// A file of its own in HDF5, described in docs/replay.md. Written and read a frame at a time: a long run is larger than
// the memory.

#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "ice/failure_mode.hpp"
#include "ice/floe_grid.hpp"
#include "scenario/scenario.hpp"
#include "simulation/channel.hpp"
#include "simulation/frame.hpp"
#include "simulation/load_history.hpp"

namespace floes {

/// A joint by the elements that it connects, in the order of IceField::elements().
struct RecordJoint {
    int a = 0;
    int b = 0;
    JointAxis axis = JointAxis::x;  ///< of the floe, from a to b
};

/// Whether the file is there and is a record, whatever its version.
bool is_record(const std::filesystem::path& path);

/// What does not change during a run.
struct RecordSubject {
    std::string campaign;       ///< title
    std::string fingerprint;    ///< of the campaign
    std::string configuration;  ///< TOML that gives the campaign again
    std::string case_name;
    int member = 0;
    int arrangement = 0;
    Scenario scenario;  ///< of the member's case
};

/// What follows from a subject.
Channel channel_of(const RecordSubject& subject);
int elements_of_a_floe(const RecordSubject& subject);
/// Floe by floe, within a floe in the order in which they are numbered in the break log.
std::vector<RecordJoint> joints_of(const RecordSubject& subject, int floes);

/// What is known only at the end of a run.
struct RecordOutcome {
    LoadHistory history;             ///< of every step
    std::vector<BreakEvent> breaks;  ///< in order of time
};

/// Of each floe, whether a joint of it has failed by `time`, s: 1 or 0. `breaks`: in order of time.
std::vector<std::uint8_t> broken_floes(const std::vector<BreakEvent>& breaks, int floes, double time);

/// Writes a record beside its place and renames it when it is finished; a record that is not leaves nothing.
class RecordWriter {
  public:
    /// Throws RunError naming the call that failed, as the others do.
    RecordWriter(const std::filesystem::path& path, const RecordSubject& subject, int floes);
    ~RecordWriter();

    void add(const Frame& frame);
    void finish(const RecordOutcome& outcome);

  private:
    class File;
    std::unique_ptr<File> file_;
};

class Record {
  public:
    /// Throws InputError when there is no such file, it is no record, or its major version is not this program's.
    explicit Record(const std::filesystem::path& path);
    ~Record();

    const RecordSubject& subject() const;
    const RecordOutcome& outcome() const;
    int floes() const;
    int elements() const;

    int frames() const;
    double time(int frame) const;  ///< s
    /// The frame whose time is nearest to `time`, s.
    int nearest(double time) const;
    /// Refills `frame` with frame `number`, as single precision keeps it; element spins are not kept.
    void read(int number, Frame& frame) const;
    Frame read(int number) const;

  private:
    class File;
    std::unique_ptr<File> file_;
};

}  // namespace floes
