#include "replay/record.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "campaign/read.hpp"
#include "core/error.hpp"
#include "hdf5/read.hpp"
#include "hdf5/series.hpp"

namespace floes {
namespace {

FloeGrid grid_of(const RecordSubject& subject) {
    const Floe& floe = subject.scenario.floe;
    return {floe.elements_long(), floe.elements_broad(), floe.element};
}

bool has_filetype(hid_t file) {
    return hdf5::has_attribute(file, "filetype") && hdf5::read_text_attribute(file, "filetype") == record_filetype;
}

void check_kind(hid_t file, const std::filesystem::path& path) {
    if (!has_filetype(file))
        throw InputError(fmt::format("{} is an HDF5 file, but no record of floes replay.", path.string()));
    const std::vector<std::int32_t> version = hdf5::read_int_attribute(file, "version");
    if (version.size() != record_version.size() || version[0] != record_version[0])
        throw InputError(
            fmt::format("{} has layout version {}, and this program reads version {} of records. Use the version of "
                        "floes that wrote it, or replay the member again.",
                        path.string(), version.empty() ? 0 : version[0], record_version[0]));
}

RecordSubject read_subject(hid_t file) {
    RecordSubject subject;
    subject.campaign = hdf5::read_text_attribute(file, "campaign");
    subject.fingerprint = hdf5::read_text_attribute(file, "fingerprint");
    subject.case_name = hdf5::read_text_attribute(file, "case");
    subject.member = hdf5::read_int_attribute(file, "member").at(0);
    subject.arrangement = hdf5::read_int_attribute(file, "arrangement").at(0);
    subject.configuration = hdf5::read_texts(file, "configuration").at(0);
    subject.scenario = read_campaign({subject.configuration, "its configuration", {}}, nullptr).cases.at(0).scenario;
    return subject;
}

RecordOutcome read_outcome(hid_t file, int joints_each) {
    RecordOutcome outcome;
    outcome.history.surge = hdf5::read_values<double>(file, "history/surge_load");
    outcome.history.sway = hdf5::read_values<double>(file, "history/sway_load");
    outcome.history.heave = hdf5::read_values<double>(file, "history/heave_load");
    const auto time = hdf5::read_values<double>(file, "joints/failure_time");
    const auto mode = hdf5::read_values<std::int8_t>(file, "joints/failure_mode");
    for (std::size_t k = 0; k < time.size(); ++k) {
        if (std::isnan(time[k])) continue;
        const auto joint = static_cast<int>(k);
        outcome.breaks.push_back(
            {time[k], joint / joints_each, joint % joints_each, static_cast<FailureMode>(mode.at(k))});
    }
    std::ranges::stable_sort(outcome.breaks, {}, &BreakEvent::time);
    return outcome;
}

Vec3 vector_at(const std::vector<float>& values, std::size_t index) {
    return {values[3 * index], values[3 * index + 1], values[3 * index + 2]};
}

}  // namespace

bool is_record(const std::filesystem::path& path) {
    const hdf5::QuietErrors quiet;
    try {
        return has_filetype(hdf5::open_for_reading(path).id());
    } catch (const InputError&) {
        return false;  // no such file, or no HDF5 file
    }
}

Channel channel_of(const RecordSubject& subject) {
    return make_channel(subject.scenario);
}

int elements_of_a_floe(const RecordSubject& subject) {
    return grid_of(subject).elements();
}

std::vector<RecordJoint> joints_of(const RecordSubject& subject, int floes) {
    const FloeGrid grid = grid_of(subject);
    const std::vector<GridJoint> order = joint_order(grid);
    std::vector<RecordJoint> joints;
    for (int floe = 0; floe < floes; ++floe) {
        const int first = floe * grid.elements();
        for (const GridJoint& joint : order) joints.push_back({first + joint.a, first + joint.b, joint.axis});
    }
    return joints;
}

class Record::File {
  public:
    explicit File(const std::filesystem::path& path) : file_(hdf5::open_for_reading(path)) {
        check_kind(file_.id(), path);
        subject = read_subject(file_.id());
        elements = static_cast<int>(hdf5::read_values<std::int32_t>(file_.id(), "ice/floe").size());
        times = hdf5::read_values<double>(file_.id(), "time");
        outcome = read_outcome(file_.id(), std::max(1, static_cast<int>(joints_of(subject, 1).size())));
        step = hdf5::read_values<std::int32_t>(file_.id(), "frames/step");
        structure = hdf5::read_values<double>(file_.id(), "frames/structure");
        surge = hdf5::read_values<double>(file_.id(), "frames/surge_load");
        sway = hdf5::read_values<double>(file_.id(), "frames/sway_load");
        heave = hdf5::read_values<double>(file_.id(), "frames/heave_load");
        first_contact = hdf5::read_values<std::int32_t>(file_.id(), "frames/first_contact");
        contacts = hdf5::read_values<std::int32_t>(file_.id(), "frames/contacts");
        if (times.empty()) throw InputError(fmt::format("{} has no frames.", path.string()));
    }

    void read(std::size_t number, Frame& frame) const {
        frame.step = step.at(number);
        frame.time = times.at(number);
        frame.structure = structure.at(number);
        frame.load = {-surge.at(number), heave.at(number), sway.at(number)};
        read_elements(number, frame);
        read_contacts(number, frame);
    }

    RecordSubject subject;
    RecordOutcome outcome;
    int elements = 0;
    std::vector<double> times;

  private:
    template <class Value>
    std::vector<Value> rows(const char* name, hsize_t first, hsize_t count) const {
        std::vector<Value> values;
        hdf5::read_block(file_.id(), name, first, count, values);
        return values;
    }

    void read_elements(std::size_t number, Frame& frame) const {
        const auto position = rows<float>("frames/position", number, 1);
        const auto orientation = rows<float>("frames/orientation", number, 1);
        const auto velocity = rows<float>("frames/velocity", number, 1);
        const auto utilisation = rows<float>("frames/utilisation", number, 1);
        const auto pieces = rows<std::int32_t>("frames/piece", number, 1);
        frame.elements.resize(static_cast<std::size_t>(elements));
        for (std::size_t k = 0; k < frame.elements.size(); ++k) {
            const float* q = &orientation[4 * k];
            frame.elements[k] = {.position = vector_at(position, k),
                                 .rotation = Quat(q[0], q[1], q[2], q[3]).normalized().toRotationMatrix(),
                                 .velocity = vector_at(velocity, k)};
        }
        frame.utilisation.assign(utilisation.begin(), utilisation.end());
        frame.pieces.assign(pieces.begin(), pieces.end());
    }

    void read_contacts(std::size_t number, Frame& frame) const {
        const auto first = static_cast<hsize_t>(first_contact.at(number));
        const auto count = static_cast<hsize_t>(contacts.at(number));
        const auto element = rows<std::int32_t>("contacts/element", first, count);
        const auto other = rows<std::int32_t>("contacts/other", first, count);
        const auto point = rows<float>("contacts/point", first, count);
        const auto normal = rows<float>("contacts/normal_force", first, count);
        const auto friction = rows<float>("contacts/friction_force", first, count);
        frame.contacts.clear();
        for (std::size_t k = 0; k < count; ++k) {
            frame.contacts.push_back(
                {element[k], other[k], vector_at(point, k), vector_at(normal, k), vector_at(friction, k)});
        }
    }

    hdf5::QuietErrors quiet_;
    hdf5::Handle file_;
    std::vector<std::int32_t> step;
    std::vector<double> structure;
    std::vector<double> surge;
    std::vector<double> sway;
    std::vector<double> heave;
    std::vector<std::int32_t> first_contact;
    std::vector<std::int32_t> contacts;
};

Record::Record(const std::filesystem::path& path) : file_(std::make_unique<File>(path)) {}
Record::~Record() = default;

const RecordSubject& Record::subject() const {
    return file_->subject;
}

const RecordOutcome& Record::outcome() const {
    return file_->outcome;
}

int Record::elements() const {
    return file_->elements;
}

int Record::floes() const {
    return file_->elements / elements_of_a_floe(file_->subject);
}

int Record::frames() const {
    return static_cast<int>(file_->times.size());
}

double Record::time(int frame) const {
    return file_->times.at(static_cast<std::size_t>(frame));
}

int Record::nearest(double time) const {
    const auto nearest =
        std::ranges::min_element(file_->times, {}, [time](double one) { return std::abs(one - time); });
    return static_cast<int>(nearest - file_->times.begin());
}

void Record::read(int number, Frame& frame) const {
    file_->read(static_cast<std::size_t>(number), frame);
}

Frame Record::read(int number) const {
    Frame frame;
    read(number, frame);
    return frame;
}

}  // namespace floes
