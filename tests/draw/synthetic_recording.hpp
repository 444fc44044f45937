#pragma once
// A recording of a small field whose frames are formulas: floes drift, turn through more than half a turn and tilt, one
// falls into pieces, and contacts come and go.

#include <cmath>
#include <filesystem>
#include <string>

#include "campaign/write.hpp"
#include "replay/recording.hpp"
#include "support/synthetic.hpp"

namespace floes::synthetic {

inline constexpr int break_frame = 7;

inline RecordingSubject record_subject() {
    Campaign one = campaign();
    one.cases.resize(1);
    return {.campaign = "synthetic </script>",
            .fingerprint = "0123456789abcdef",
            .configuration = write_campaign(one),
            .case_name = "soft",
            .member = 3,
            .arrangement = 1,
            .scenario = one.cases.front().scenario,
            .floes = floes_of(one.cases.front().scenario)};
}

inline Frame frame(int number, int elements) {
    Frame made;
    made.step = 5 * number;
    made.time = 0.02 * made.step;
    made.structure.position.x() = 2 + 1.75 * made.time;
    made.load = Vec3(-10.0 * number, 2.5, -0.125 * number);
    for (int e = 0; e < elements; ++e) {
        const double phase = 0.7 * e + 0.05 * number;
        BodyState state;
        state.position = Vec3(3 + 0.2 * e + 0.01 * number, 0.02 * std::sin(phase), 2 * std::cos(phase));
        state.rotation = (Eigen::AngleAxisd(0.25 * number + e, Vec3::UnitY()) *
                          Eigen::AngleAxisd(0.3 * std::sin(phase), Vec3::UnitX()))
                             .toRotationMatrix();
        made.elements.push_back(state);
        made.pieces.push_back(number >= break_frame && e > 20 ? e : 9 * (e / 9));
        made.utilisation.push_back(0.5 + 0.5 * std::sin(phase));
    }
    for (int c = 0; c < number % 4; ++c) {
        const int other = c == 1 ? 5 : touches_structure;
        made.contacts.push_back(
            {c, other, Vec3(3 + c, -0.1, 0.5), Vec3(100.0 * c, 20, -number), Vec3(0, -5, 0.25 * number)});
    }
    return made;
}

/// `moored`: a hull that gives way without lines, whose worst mooring force is asked for.
inline void write_recording(const std::filesystem::path& path, int frames, bool moored = false) {
    RecordingSubject subject = record_subject();
    if (moored) subject.asked = {AskedOf::mooring_force, 0};
    const int elements = static_cast<int>(IceLayout(subject.floes).elements.size());
    RecordingWriter writer(path, subject);
    for (int i = 0; i < frames; ++i) writer.add(frame(i, elements));
    RecordingOutcome outcome;
    for (int step = 0; step < subject.scenario.step_count(); ++step) {
        outcome.history.surge.push_back(2.0 * step);
        outcome.history.sway.push_back(1);
        outcome.history.heave.push_back(-1);
        if (!moored) continue;
        outcome.hull.mooring_force.push_back(3.0 * step);
        outcome.hull.offset.push_back(0.1 * step);
        outcome.hull.yaw.push_back(0);
    }
    outcome.breaks.push_back({0.1 * break_frame, 2, 3, FailureMode::shear});
    writer.finish(outcome);
}

}  // namespace floes::synthetic
