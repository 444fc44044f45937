#include "replay/recording.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <span>

#include "campaign/read.hpp"
#include "core/error.hpp"
#include "hdf5/columns.hpp"
#include "hdf5/kind.hpp"
#include "replay/recorded_parts.hpp"
#include "replay/recording_kind.hpp"

namespace floes {
namespace {

Vec3 vector_at(std::span<const float> values, std::size_t index) {
    return {values[3 * index], values[3 * index + 1], values[3 * index + 2]};
}

}  // namespace

bool is_recording(const std::filesystem::path& path) {
    const hdf5::QuietErrors quiet;
    try {
        return hdf5::is_of_kind(hdf5::open_for_reading(path).id(), recording_kind);
    } catch (const InputError&) {
        return false;  // no such file, or no HDF5 file
    }
}

class Recording::File {
  public:
    explicit File(const std::filesystem::path& path)
        : file_(opened(path)),
          subject(read_subject(file_.id())),
          layout(subject.floes),
          elements_(file_.id(), hdf5::exists(file_.id(), "states") ? "states/" : "frames/"),
          contacts_(file_.id()) {
        times = hdf5::read_values<double>(file_.id(), "time");
        outcome = read_outcome(file_.id(), layout);
        step_ = hdf5::read_values<std::int32_t>(file_.id(), "frames/step");
        structure_ = hdf5::read_values<double>(file_.id(), "frames/structure");
        across_ = read_unless_old("frames/structure_z");
        yaw_ = read_unless_old("frames/structure_yaw");
        surge_ = hdf5::read_values<double>(file_.id(), "frames/surge_load");
        sway_ = hdf5::read_values<double>(file_.id(), "frames/sway_load");
        heave_ = hdf5::read_values<double>(file_.id(), "frames/heave_load");
        first_contact_ = hdf5::read_values<std::int32_t>(file_.id(), "frames/first_contact");
        contact_count_ = hdf5::read_values<std::int32_t>(file_.id(), "frames/contacts");
        if (subject.scenario.field.endless()) states_.emplace(file_.id());
        if (hdf5::exists(file_.id(), "frames/line_tension")) lines_.emplace(file_.id());
        if (times.empty()) throw InputError(fmt::format("{} has no frames.", path.string()));
        check_sizes();
    }

    PlanarPose structure(std::size_t number) const {
        return {structure_.at(number), across_.at(number), yaw_.at(number)};
    }

    std::vector<FrameLine> lines(std::size_t number) {
        std::vector<FrameLine> held;
        if (!lines_) return held;
        const std::span<const float> fairlead = lines_->fairlead.read(number);
        const std::span<const float> anchor = lines_->anchor.read(number);
        const std::span<const float> tension = lines_->tension.read(number);
        for (std::size_t k = 0; k < tension.size(); ++k) {
            if (std::isnan(tension[k])) continue;
            held.push_back({static_cast<int>(k), vector_at(fairlead, k), vector_at(anchor, k), tension[k]});
        }
        return held;
    }

    void read(std::size_t number, Frame& frame) {
        frame.step = step_.at(number);
        frame.time = times.at(number);
        frame.structure = structure(number);
        frame.load = {-surge_.at(number), heave_.at(number), sway_.at(number)};
        read_elements(number, frame);
        read_contacts(number, frame);
        frame.lines = lines(number);
    }

  private:
    hdf5::QuietErrors quiet_;
    hdf5::Handle file_;

  public:
    const RecordingSubject subject;
    const IceLayout layout;
    RecordingOutcome outcome;
    std::vector<double> times;

  private:
    struct Elements {
        Elements(hid_t file, const std::string& group)
            : position(file, group + "position"),
              orientation(file, group + "orientation"),
              velocity(file, group + "velocity"),
              utilisation(file, group + "utilisation"),
              piece(file, group + "piece") {}
        hdf5::RowReader<float> position;
        hdf5::RowReader<float> orientation;
        hdf5::RowReader<float> velocity;
        hdf5::RowReader<float> utilisation;
        hdf5::RowReader<std::int32_t> piece;
    };

    /// Of a field without end: which rows of the elements are of a frame.
    struct States {
        explicit States(hid_t file)
            : first(hdf5::read_values<std::int32_t>(file, "frames/first_state")),
              count(hdf5::read_values<std::int32_t>(file, "frames/states")),
              element(file, "states/element") {}
        std::vector<std::int32_t> first;
        std::vector<std::int32_t> count;
        hdf5::RowReader<std::int32_t> element;
    };

    struct Contacts {
        explicit Contacts(hid_t file)
            : element(file, "contacts/element"),
              other(file, "contacts/other"),
              point(file, "contacts/point"),
              normal(file, "contacts/normal_force"),
              friction(file, "contacts/friction_force") {}
        hdf5::RowReader<std::int32_t> element;
        hdf5::RowReader<std::int32_t> other;
        hdf5::RowReader<float> point;
        hdf5::RowReader<float> normal;
        hdf5::RowReader<float> friction;
    };

    struct Lines {
        explicit Lines(hid_t file)
            : fairlead(file, "frames/line_fairlead"),
              anchor(file, "frames/line_anchor"),
              tension(file, "frames/line_tension") {}
        hdf5::RowReader<float> fairlead;
        hdf5::RowReader<float> anchor;
        hdf5::RowReader<float> tension;
    };

    static hdf5::Handle opened(const std::filesystem::path& path) {
        hdf5::Handle file = hdf5::open_for_reading(path);
        hdf5::check_kind(file.id(), recording_kind, path);
        return file;
    }

    /// Zeros where the recording is of a version in which structures went straight on only.
    std::vector<double> read_unless_old(const std::string& name) const {
        if (!hdf5::exists(file_.id(), name)) return std::vector<double>(times.size(), 0.0);
        return hdf5::read_values<double>(file_.id(), name);
    }

    void check_sizes() const {
        if (lines_) {
            const std::size_t lines = lines_->tension.width();
            hdf5::check_count(file_.id(), "frames/line_tension", lines, subject.scenario.moorings.lines.size());
            hdf5::check_count(file_.id(), "frames/line_fairlead", lines_->fairlead.width(), 3 * lines);
            hdf5::check_count(file_.id(), "frames/line_anchor", lines_->anchor.width(), 3 * lines);
        }
        const std::size_t count = states_ ? 1 : layout.elements.size();
        if (states_) {
            hdf5::check_count(file_.id(), "frames/first_state", states_->first.size(), times.size());
            hdf5::check_count(file_.id(), "frames/states", states_->count.size(), times.size());
        }
        hdf5::check_count(file_.id(), "frames/position", elements_.position.width(), 3 * count);
        hdf5::check_count(file_.id(), "frames/orientation", elements_.orientation.width(), 4 * count);
        hdf5::check_count(file_.id(), "frames/velocity", elements_.velocity.width(), 3 * count);
        hdf5::check_count(file_.id(), "frames/utilisation", elements_.utilisation.width(), count);
        hdf5::check_count(file_.id(), "frames/piece", elements_.piece.width(), count);
        for (const hdf5::RowReader<float>* one : {&contacts_.point, &contacts_.normal, &contacts_.friction})
            hdf5::check_count(file_.id(), "a vector of contacts", one->width(), 3);
        for (const std::size_t found : {step_.size(), structure_.size(), across_.size(), yaw_.size(), surge_.size(),
                                        sway_.size(), heave_.size(), first_contact_.size(), contact_count_.size()})
            hdf5::check_count(file_.id(), "a number of frames", found, times.size());
    }

    void read_elements(std::size_t number, Frame& frame) {
        std::size_t row = number;
        std::size_t rows = 1;
        frame.ids.clear();
        if (states_) {
            row = static_cast<std::size_t>(states_->first[number]);
            rows = static_cast<std::size_t>(states_->count[number]);
            for (const std::int32_t id : states_->element.read(row, rows)) {
                if (id < 0 || static_cast<std::size_t>(id) >= layout.elements.size())
                    hdf5::refuse_damaged(file_.id(), fmt::format("states/element has the value {}", id));
                frame.ids.push_back(id);
            }
        }
        const std::span<const float> position = elements_.position.read(row, rows);
        const std::span<const float> orientation = elements_.orientation.read(row, rows);
        const std::span<const float> velocity = elements_.velocity.read(row, rows);
        frame.elements.resize(states_ ? rows : layout.elements.size());
        for (std::size_t k = 0; k < frame.elements.size(); ++k) {
            const float* q = &orientation[4 * k];
            frame.elements[k] = {.position = vector_at(position, k),
                                 .rotation = Quat(q[0], q[1], q[2], q[3]).normalized().toRotationMatrix(),
                                 .velocity = vector_at(velocity, k)};
        }
        const std::span<const float> utilisation = elements_.utilisation.read(row, rows);
        const std::span<const std::int32_t> pieces = elements_.piece.read(row, rows);
        frame.utilisation.assign(utilisation.begin(), utilisation.end());
        frame.pieces.assign(pieces.begin(), pieces.end());
    }

    void read_contacts(std::size_t number, Frame& frame) {
        const auto first = static_cast<std::size_t>(first_contact_.at(number));
        const auto count = static_cast<std::size_t>(contact_count_.at(number));
        const std::span<const std::int32_t> element = contacts_.element.read(first, count);
        const std::span<const std::int32_t> other = contacts_.other.read(first, count);
        const std::span<const float> point = contacts_.point.read(first, count);
        const std::span<const float> normal = contacts_.normal.read(first, count);
        const std::span<const float> friction = contacts_.friction.read(first, count);
        frame.contacts.clear();
        for (std::size_t k = 0; k < count; ++k) {
            frame.contacts.push_back(
                {element[k], other[k], vector_at(point, k), vector_at(normal, k), vector_at(friction, k)});
        }
    }

    Elements elements_;
    Contacts contacts_;
    std::optional<States> states_;  ///< of a field without end
    std::optional<Lines> lines_;    ///< of a structure with mooring lines
    std::vector<std::int32_t> step_;
    std::vector<double> structure_;
    std::vector<double> across_;
    std::vector<double> yaw_;
    std::vector<double> surge_;
    std::vector<double> sway_;
    std::vector<double> heave_;
    std::vector<std::int32_t> first_contact_;
    std::vector<std::int32_t> contact_count_;
};

Recording::Recording(const std::filesystem::path& path) : file_(std::make_unique<File>(path)) {}
Recording::~Recording() = default;

const RecordingSubject& Recording::subject() const {
    return file_->subject;
}

const RecordingOutcome& Recording::outcome() const {
    return file_->outcome;
}

const IceLayout& Recording::layout() const {
    return file_->layout;
}

int Recording::frames() const {
    return static_cast<int>(file_->times.size());
}

double Recording::time(int frame) const {
    return file_->times.at(static_cast<std::size_t>(frame));
}

int Recording::nearest(double time) const {
    const auto nearest =
        std::ranges::min_element(file_->times, {}, [time](double one) { return std::abs(one - time); });
    return static_cast<int>(nearest - file_->times.begin());
}

PlanarPose Recording::structure(int frame) const {
    return file_->structure(static_cast<std::size_t>(frame));
}

std::vector<FrameLine> Recording::lines(int frame) const {
    return file_->lines(static_cast<std::size_t>(frame));
}

void Recording::read(int number, Frame& frame) const {
    file_->read(static_cast<std::size_t>(number), frame);
}

Frame Recording::read(int number) const {
    Frame frame;
    read(number, frame);
    return frame;
}

}  // namespace floes
