#pragma once
// The part of a recording that grows: what each frame adds to the file. For this room only.

#include <cstdint>
#include <optional>

#include "hdf5/series.hpp"
#include "simulation/frame.hpp"

namespace floes {

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

}  // namespace floes
