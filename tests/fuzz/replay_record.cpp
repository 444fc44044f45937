// The record of a replayed member, damaged.

#include "campaign/write.hpp"
#include "fuzz/edited_file.hpp"
#include "replay/recording.hpp"
#include "support/synthetic.hpp"

namespace {

using namespace floes;

constexpr int frames = 2;

void write_recording(const std::filesystem::path& path) {
    const Campaign campaign = synthetic::campaign(1);
    RecordingSubject subject;
    subject.campaign = campaign.name;
    subject.configuration = write_campaign(campaign);
    subject.case_name = campaign.cases.front().name;
    subject.scenario = campaign.cases.front().scenario;
    subject.floes = floes_at(subject.scenario, std::vector<PlanarPose>(2));
    const std::size_t elements = IceLayout(subject.floes).elements.size();
    RecordingWriter writer(path, subject);
    for (int k = 0; k < frames; ++k) {
        Frame frame;
        frame.step = k;
        frame.time = 0.02 * k;
        frame.load = {1.0 + k, 2, 3};
        frame.elements.resize(elements);
        frame.pieces.assign(elements, 0);
        frame.utilisation.assign(elements, 0.5);
        frame.contacts.resize(2);
        writer.add(frame);
    }
    writer.finish({{{1, 2}, {3, 4}, {5, 6}, {0.5, 0.6}, {0.01, 0.02}, {0.1, 0.2}}, {{0.02, 1, 2, FailureMode::shear}}});
}

void put(const Vec3& vector, ByteWriter& out) {
    for (int axis = 0; axis < 3; ++axis) out.f64(vector[axis]);
}

void put(const Frame& frame, ByteWriter& out) {
    out.i32(frame.step);
    out.f64(frame.time);
    for (const double part : {frame.structure.position.x(), frame.structure.position.z(), frame.structure.yaw})
        out.f64(part);
    put(frame.load, out);
    for (const BodyState& one : frame.elements) {
        put(one.position, out);
        for (int row = 0; row < 3; ++row) put(one.rotation.row(row), out);
        put(one.velocity, out);
    }
    for (const int piece : frame.pieces) out.i32(piece);
    out.doubles(frame.utilisation);
    for (const FrameContact& one : frame.contacts) {
        out.i32(one.element);
        out.i32(one.other);
        for (const Vec3& vector : {one.point, one.normal, one.friction}) put(vector, out);
    }
}

/// All that is read of a record.
Bytes record_read(const std::filesystem::path& path) {
    const Recording record(path);
    ByteWriter out;
    const RecordingSubject& subject = record.subject();
    for (const std::string& text : {subject.campaign, subject.fingerprint, subject.configuration, subject.case_name})
        out.text(text);
    for (const int number : {subject.member, subject.arrangement, record.layout().floes(), record.frames()})
        out.i32(number);
    const RecordingOutcome& outcome = record.outcome();
    for (const std::vector<double>* loads : {&outcome.history.surge, &outcome.history.sway, &outcome.history.heave})
        out.doubles(*loads);
    for (const BreakEvent& one : outcome.breaks) {
        out.f64(one.time);
        for (const int number : {one.floe, one.joint, static_cast<int>(one.mode)}) out.i32(number);
    }
    Frame frame;
    for (int k = 0; k < std::min(frames, record.frames()); ++k) {
        record.read(record.nearest(record.time(k)), frame);
        put(frame, out);
        for (const std::uint8_t broken : broken_floes(outcome.breaks, record.layout().floes(), frame.time))
            out.u8(broken);
    }
    return out.take();
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    static fuzz::DamagedFiles files(write_recording, write_campaign(synthetic::campaign(1)));
    static const Bytes right = record_read(files.whole());
    if (size < 2) return 0;
    const fuzz::FileInput input(std::span(data, size));
    const std::filesystem::path path = files.damaged(input);
    if (path.empty()) return 0;
    const auto read = fuzz::taken([&] { return record_read(path); });
    fuzz::require(!read || input.damage == fuzz::Damage::values || *read == right, "damaged bytes are numbers");
    return 0;
}
