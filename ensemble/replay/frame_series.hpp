#pragma once
// The floes of a field without end that the frames of a record show. A run keeps them in places, where others follow
// those that have left; a record gives each floe that it ever shows elements and joints of its own, floe by floe in the
// order in which they entered, and a frame says which of them are there.

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "hdf5/columns.hpp"
#include "hdf5/dataset.hpp"
#include "ice/failure_mode.hpp"
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

    struct Elements {
        Elements(hid_t group, const RecordScales& scales);
        hdf5::Series<float> position;
        hdf5::Series<float> orientation;
        hdf5::Series<float> velocity;
        hdf5::Series<std::int32_t> piece;
        hdf5::Series<float> utilisation;
    };

    /// Which rows of the elements are of a frame, and what elements they are.
    struct States {
        States(hid_t frames, hid_t states);
        hdf5::Series<std::int32_t> first;
        hdf5::Series<std::int32_t> count;
        hdf5::Series<std::int32_t> element;
    };

    struct Numbers {
        explicit Numbers(hid_t group);
        hdf5::Series<std::int32_t> step;
        hdf5::Series<double> structure;
        hdf5::Series<double> across;
        hdf5::Series<double> yaw;
        hdf5::Series<double> up;
        hdf5::Series<double> pitch;
        hdf5::Series<double> roll;
        hdf5::Series<double> surge;
        hdf5::Series<double> sway;
        hdf5::Series<double> heave;
        hdf5::Series<std::int32_t> first_contact;
        hdf5::Series<std::int32_t> contacts;
    };

    struct Contacts {
        Contacts(hid_t group, const hdf5::Scale& coordinate);
        hdf5::Series<std::int32_t> element;
        hdf5::Series<std::int32_t> other;
        hdf5::Series<float> point;
        hdf5::Series<float> normal;
        hdf5::Series<float> friction;
    };

    /// NaN where a line has broken.
    struct Lines {
        Lines(hid_t group, const hdf5::Scale& line, const hdf5::Scale& coordinate);
        std::size_t count;
        hdf5::Series<float> fairlead;
        hdf5::Series<float> anchor;
        hdf5::Series<float> tension;
    };

    hdf5::Series<double> time_;
    hdf5::Series<std::int32_t> contact_;
    hdf5::Handle frames_group_;
    hdf5::Handle contacts_group_;
    std::optional<hdf5::Handle> states_group_;  ///< of elements that come and go; of others there is none
    std::optional<hdf5::Series<std::int32_t>> state_;
    Elements elements_;
    Numbers numbers_;
    Contacts contacts_;
    std::optional<States> states_;
    std::optional<Lines> lines_;
};

// The part of a recording that says what the ice is, written. For this module only.

hdf5::Scale element_scale(hid_t file, const IceLayout& layout);

/// usual: the scenario's own floe, whose size an attribute has. `scales` have the elements.
void write_ice(hid_t file, const FloeShape& usual, const IceLayout& layout, const RecordScales& scales);

/// The floes of a field without end, which no configuration tells: what read_floes() makes them from again.
void write_floes(hid_t file, const FloeSet& floes, const std::vector<int>& numbers);

void write_joints(hid_t file, const IceLayout& layout, const std::vector<BreakEvent>& breaks);

}  // namespace floes
