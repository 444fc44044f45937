#include "replay/recorded_parts.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

#include "campaign/read.hpp"
#include "hdf5/columns.hpp"

namespace floes {
namespace {

constexpr double most_elements = 1e6;  // of a floe; a damaged number is not to ask for all memory

/// Of a field without end, which the file has.
FloeSet read_own_floes(hid_t file, const Scenario& scenario) {
    const auto length = hdf5::read_values<double>(file, "floes/length");
    const std::size_t count = length.size();
    const auto breadth = hdf5::read_column<double>(file, "floes/breadth", count);
    const auto thickness = hdf5::read_column<double>(file, "floes/thickness", count);
    const auto element = hdf5::read_column<double>(file, "floes/element", count);
    std::vector<double> x;
    std::vector<double> z;
    std::size_t corners = 0;
    if (hdf5::exists(file, "floes/corner_x")) {
        x = hdf5::read_table<double>(file, "floes/corner_x", count, corners);
        z = hdf5::read_column<double>(file, "floes/corner_z", x.size());
    }
    std::vector<SingleFloe> floes;
    for (std::size_t i = 0; i < count; ++i) {
        FloeShape shape{length[i], breadth[i], thickness[i], element[i]};
        for (std::size_t k = corners * i; k < corners * (i + 1) && !std::isnan(x[k]); ++k)
            shape.outline.push_back({x[k], z[k]});
        const double elements = shape.element > 0 ? shape.length * shape.breadth / (shape.element * shape.element) : 0;
        if (!(elements >= 0.5 && elements < most_elements) || !(shape.thickness > 0))
            hdf5::refuse_damaged(file, fmt::format("floes has a floe {} that there cannot be", i));
        floes.push_back({{}, std::move(shape), scenario.material()});
    }
    return gathered(floes);
}

void check_floes(hid_t file, const FloeSet& floes, const std::vector<std::int32_t>& floe) {
    const IceLayout layout(floes);
    if (!std::ranges::equal(floe, layout.elements, {}, {}, &IceLayout::LaidElement::floe))
        hdf5::refuse_damaged(file, "ice/floe has other elements than its floes");
}

/// The floes of the scenario, as many as the file has. `floe`: of each element.
FloeSet read_floes(hid_t file, const Scenario& scenario, const Draw& draw, const std::vector<std::int32_t>& floe) {
    FloeSet floes = floes_of(scenario, draw);
    const std::size_t count = floe.empty() || floe.back() < 0 ? 0 : static_cast<std::size_t>(floe.back()) + 1;
    if (!floes_may_differ(scenario) && count <= floe.size()) floes = floes_at(scenario, std::vector<PlanarPose>(count));
    check_floes(file, floes, floe);
    return floes;
}

}  // namespace

RecordingSubject read_subject(hid_t file) {
    RecordingSubject subject;
    subject.campaign = hdf5::read_text_attribute(file, "campaign");
    subject.fingerprint = hdf5::read_text_attribute(file, "fingerprint");
    subject.case_name = hdf5::read_text_attribute(file, "case");
    subject.member = hdf5::read_int_attribute(file, "member").at(0);
    subject.arrangement = hdf5::read_int_attribute(file, "arrangement").at(0);
    subject.configuration = hdf5::read_text(file, "configuration");
    const Campaign campaign = read_campaign({subject.configuration, "its configuration", {}}, nullptr);
    subject.scenario = campaign.cases.at(0).scenario;
    const Draw draw{arrangement_seed(campaign, 0), static_cast<std::uint32_t>(subject.arrangement)};
    const auto floe = hdf5::read_values<std::int32_t>(file, "ice/floe");
    if (!subject.scenario.field.endless()) {
        subject.floes = read_floes(file, subject.scenario, draw, floe);
        return subject;
    }
    subject.floes = read_own_floes(file, subject.scenario);
    check_floes(file, subject.floes, floe);
    const auto way = hdf5::read_values<double>(file, "frames/structure");
    if (!way.empty()) subject.way = {std::ranges::min(way), std::ranges::max(way)};
    return subject;
}

RecordingOutcome read_outcome(hid_t file, const IceLayout& layout) {
    RecordingOutcome outcome;
    outcome.history.surge = hdf5::read_values<double>(file, "history/surge_load");
    const std::size_t steps = outcome.history.surge.size();
    outcome.history.sway = hdf5::read_column<double>(file, "history/sway_load", steps);
    outcome.history.heave = hdf5::read_column<double>(file, "history/heave_load", steps);
    const std::size_t joints = layout.joints.size();
    const auto time = hdf5::read_column<double>(file, "joints/failure_time", joints);
    const auto last_mode = static_cast<std::int8_t>(std::size(failure_mode_names) - 1);
    const auto mode = hdf5::read_numbers<std::int8_t>(file, "joints/failure_mode", joints, -1, last_mode);
    for (std::size_t k = 0; k < joints; ++k) {
        if (std::isnan(time[k])) continue;
        if (mode[k] < 0) hdf5::refuse_damaged(file, "joints/failure_mode has no mode for a joint that failed");
        const std::size_t floe = layout.floe_of_joint(k);
        outcome.breaks.push_back({time[k], static_cast<int>(floe), static_cast<int>(k - layout.first_joint[floe]),
                                  static_cast<FailureMode>(mode[k])});
    }
    std::ranges::stable_sort(outcome.breaks, {}, &BreakEvent::time);
    return outcome;
}

}  // namespace floes
