#pragma once
// The floes of a field without end that the frames of a record show. A run keeps them in places, where others follow
// those that have left; a record gives each floe that it ever shows elements and joints of its own, floe by floe in the
// order in which they entered, and a frame says which of them are there.

#include <array>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <optional>
#include <tuple>
#include <vector>

#include "hdf5/columns.hpp"
#include "hdf5/dataset.hpp"
#include "ice/ice_field.hpp"
#include "scenario/floes.hpp"
#include "simulation/record.hpp"
#include "simulation/simulation.hpp"

namespace floes {

class FloeRoll {
  public:
    /// Brings a frame of the run's present into the numbers of the record: floes that are not there any more leave it,
    /// new ones join the roll. Frames come in order of time.
    void enter(const Simulation& run, Frame& frame);

    /// All so far.
    FloeSet floes() const { return gathered(floes_); }
    const std::vector<int>& numbers() const { return numbers_; }  ///< of each: its place in the order of entry, from 0

    /// Those of the breaks of the run that are of these floes, in the numbers of the record. None of a sheet, whose
    /// joints are between its elements, each a floe here: frames tell its pieces.
    std::vector<BreakEvent> breaks(const std::vector<BreakEvent>& of_run) const;

  private:
    std::size_t index_of(int number) const;

    std::vector<int> numbers_;  // rising
    std::vector<SingleFloe> floes_;
    std::vector<int> first_element_;
    int elements_ = 0;
    bool of_sheet_ = false;
};

// The part of a recording that grows: what each frame adds to the file. For this module only.

/// Scales of a recording's frames.
struct RecordScales {
    hdf5::Scale coordinate;
    hdf5::Scale quaternion;
    std::optional<hdf5::Scale> element;  ///< none: a frame has those that are there, of a field without end
    std::optional<hdf5::Scale> line;     ///< mooring lines; none: there are none
};

/// A number of each frame, in the order in which the file has them.
struct FrameNumber {
    const char* name;
    const char* unit;
    const char* text;
    double& (*of)(StructurePose& structure, Vec3& load);
    double sign = 1;    ///< of what the file has
    bool late = false;  ///< missing in records of versions in which structures went straight on only: zeros
};
inline constexpr std::array<FrameNumber, 9> frame_numbers{
    {{"structure", "m", "x of the structure's axis", [](auto& at, auto&) -> double& { return at.position.x(); }},
     {"structure_z", "m", "z of the structure's axis", [](auto& at, auto&) -> double& { return at.position.z(); }, 1,
      true},
     {"structure_yaw", "rad", "yaw of the structure, positive where +z turns to +x",
      [](auto& at, auto&) -> double& { return at.yaw; }, 1, true},
     {"structure_y", "m", "heave of the structure, upwards", [](auto& at, auto&) -> double& { return at.position.y(); },
      1, true},
     {"structure_pitch", "rad", "pitch of the structure, positive with the bow up",
      [](auto& at, auto&) -> double& { return at.pitch; }, 1, true},
     {"structure_roll", "rad", "roll of the structure, positive with starboard (+z) down",
      [](auto& at, auto&) -> double& { return at.roll; }, 1, true},
     {"surge_load", "N", "load of the step, positive against the tow",
      [](auto&, auto& load) -> double& { return load.x(); }, -1},
     {"sway_load", "N", "load of the step, positive towards +z", [](auto&, auto& load) -> double& { return load.z(); }},
     {"heave_load", "N", "load of the step, positive up", [](auto&, auto& load) -> double& { return load.y(); }}}};

// Columns that grow with the frames. Column: hdf5::Series, which is written, or hdf5::RowReader.

template <template <class> class Column>
struct ElementColumns {
    Column<float> position, orientation, velocity;
    Column<std::int32_t> piece;
    Column<float> utilisation;
    auto all() { return std::tie(position, orientation, velocity, piece, utilisation); }
};

template <template <class> class Column>
struct ContactColumns {
    Column<std::int32_t> element, other;
    Column<float> point, normal, friction;
    auto all() { return std::tie(element, other, point, normal, friction); }
};

/// NaN where a line has broken.
template <template <class> class Column>
struct LineColumns {
    Column<float> fairlead, anchor, tension;
    auto all() { return std::tie(fairlead, anchor, tension); }
};

class FrameSeries {
  public:
    FrameSeries(hid_t file, const RecordScales& scales);

    void add(const Frame& frame);
    /// After the last frame.
    void finish();

  private:
    void add_states(const Frame& frame);
    void add_elements(const Frame& frame);
    void add_contacts(const std::vector<FrameContact>& contacts);
    void add_lines(const std::vector<FrameLine>& lines);

    /// Which rows of the elements are of a frame, and what elements they are.
    struct States {
        hdf5::Series<std::int32_t> first, count, element;
    };

    struct Numbers {
        explicit Numbers(hid_t group);
        hdf5::Series<std::int32_t> step;
        std::deque<hdf5::Series<double>> each;  ///< of frame_numbers
        hdf5::Series<std::int32_t> first_contact, contacts;
    };

    /// Calls `use` with every column that has a row for each frame.
    void for_each_of_frames(const auto& use);

    hdf5::Series<double> time_;
    hdf5::Series<std::int32_t> contact_;
    hdf5::Handle frames_group_;
    hdf5::Handle contacts_group_;
    std::optional<hdf5::Handle> states_group_;  ///< of elements that come and go; of others there is none
    std::optional<hdf5::Series<std::int32_t>> state_;
    ElementColumns<hdf5::Series> elements_;
    Numbers numbers_;
    ContactColumns<hdf5::Series> contacts_;
    std::optional<States> states_;
    std::size_t line_count_ = 0;
    std::optional<LineColumns<hdf5::Series>> lines_;
};

// The part of a recording that says what the ice is, written. For this module only.

hdf5::Scale element_scale(hid_t file, const IceLayout& layout);

/// usual: the scenario's own floe, whose size an attribute has. `scales` have the elements.
void write_ice(hid_t file, const FloeShape& usual, const IceLayout& layout, const RecordScales& scales);

/// The floes of a field without end, which no configuration tells: what read_floes() makes them from again.
void write_floes(hid_t file, const FloeSet& floes, const std::vector<int>& numbers);

void write_joints(hid_t file, const IceLayout& layout, const std::vector<BreakEvent>& breaks);

}  // namespace floes
