#include "findings/report_sections.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <map>
#include <optional>

#include "core/units.hpp"
#include "ice/failure_mode.hpp"
#include "ice/floe_grid.hpp"
#include "scenario/floes.hpp"

namespace floes {
namespace {

struct Stroke {
    const char* style;
    const char* words;
};

/// Of each mode, the same in every report.
constexpr std::array<Stroke, failure_mode_names.size()> strokes{{{"", "solid line"},
                                                                 {" dashed", "dashed"},
                                                                 {" dotted", "dotted"},
                                                                 {" thin", "thin"},
                                                                 {" thin dashed", "thin dashed"},
                                                                 {" thin dotted", "thin dotted"}}};

/// Failures so far over time, as steps up to `end`; `runs` of them are averaged.
Figure::Points steps_of(std::vector<double> times, double end, int runs) {
    std::ranges::sort(times);
    Figure::Points points{{0, 0}};
    for (std::size_t k = 0; k < times.size(); ++k) {
        points.emplace_back(times[k], points.back().second);
        points.emplace_back(times[k], static_cast<double>(k + 1) / runs);
    }
    points.emplace_back(end, points.back().second);
    return points;
}

/// "bending", "in-plane bending"; `mode` as in BreakRow.
std::string mode_name(int mode) {
    return mode == static_cast<int>(FailureMode::in_plane_bending)
               ? "in-plane bending"
               : failure_mode_names.at(static_cast<std::size_t>(mode));
}

/// How often the joints failed in one floe of one member of a case, 0 to 1.
struct CaseFailures {
    std::string name;
    FloeShape floe;
    int floes;
    FloeGrid grid;
    std::vector<GridJoint> joints;
    std::vector<double> of_joint;
    std::map<int, double> of_mode;  ///< sum over the joints
    double total = 0;
};

/// None where floes differ in shape: their joints are not the same.
std::optional<CaseFailures> failures_of(Evidence& evidence, std::size_t of_case) {
    const FloeSet floes = floes_of(evidence.campaign.cases[of_case].scenario);
    if (floes.shapes.size() != 1 || floes.shapes.front().is_polygon()) return std::nullopt;
    const CaseSummary& row = evidence.summary.cases[of_case];
    const FloeShape& floe = floes.shapes.front();
    CaseFailures found{
        evidence.summary.label_of(of_case), floe, static_cast<int>(floes.size()), grid_of(floe), {}, {}, {}};
    found.joints = joint_order(found.grid);
    found.of_joint.resize(found.joints.size(), 0.0);
    const double share = 1.0 / row.done / found.floes;
    for (const BreakRow& one : breaks_of(evidence)) {
        const MemberRow& member = evidence.table.members[static_cast<std::size_t>(one.member)];
        if (member.case_index != static_cast<int>(of_case)) continue;
        found.of_joint.at(static_cast<std::size_t>(one.joint)) += share;
        found.of_mode[one.mode] += share;
        found.total += share;
    }
    return found;
}

/// "soft: 5.2 joints failed in a member: bending 97 %, shear 3 %.", the most frequent mode first.
std::string sentence(const CaseFailures& found) {
    std::vector<std::pair<double, int>> sorted;
    for (const auto& [mode, share] : found.of_mode) sorted.emplace_back(share, mode);
    std::ranges::sort(sorted, std::ranges::greater{});
    std::string words;
    for (const auto& [share, mode] : sorted)
        words += fmt::format("{}{} {:.0f} %", words.empty() ? "" : ", ", mode_name(mode),
                             share / found.total / unit::percent);
    return fmt::format("{}: {:.1f} joints failed in a member: {}.", found.name, found.total * found.floes, words);
}

/// The floe with each joint in the shade of how often it failed; `largest` is the darkest.
Figure panel(const CaseFailures& found, double largest) {
    constexpr std::size_t most_numbers = 40;  // joints; more have no room for them
    constexpr double widest = 188;            // three panels stand side by side
    const FloeShape& floe = found.floe;
    const double half_length = 0.55 * floe.length;
    const double half_breadth = 0.55 * floe.breadth;
    const double scale = widest / 2 / std::max(half_length, half_breadth);
    const double side = found.grid.element;
    Figure figure{
        .description = fmt::format("Case {}: how often each joint of a floe failed", found.name),
        .x = {fmt::format("{}: along the floe, m", found.name), -half_length, half_length, false, {}, floe.length / 2},
        .y = {"across, m", -half_breadth, half_breadth, false, {}, floe.breadth / 2},
        .size = {std::max(268.0, 80 + 2 * scale * half_length), 74 + 2 * scale * half_breadth},
        .heat_scale = fmt::format("up to {:.1f} %", largest / unit::percent)};
    for (int element = 0; element < found.grid.elements(); ++element) {
        const Vec3 at = found.grid.centre(element);
        figure.cell(at.x() - 0.39 * side, at.z() - 0.39 * side, 0.78 * side, 0.78 * side, 1, "ice");
    }
    for (std::size_t k = 0; k < found.joints.size(); ++k) {
        const Vec3 at = found.grid.pivot(found.joints[k]);
        const bool along = found.joints[k].axis == JointAxis::x;
        const double x = (along ? 0.22 : 0.78) * side;
        const double z = (along ? 0.78 : 0.22) * side;
        figure.cell(at.x() - x / 2, at.z() - z / 2, x, z, found.of_joint[k] / largest, "heat");
        if (found.joints.size() <= most_numbers)
            figure.text(at.x(), at.z() - 0.03 * side, fmt::format("{:.1f}", found.of_joint[k] / unit::percent),
                        "middle", "key");
    }
    return figure;
}

}  // namespace

Section failures_section(Evidence& evidence) {
    const auto& cases = evidence.summary.cases;
    std::map<int, std::map<std::size_t, std::vector<double>>> times;  // by mode and case
    for (const BreakRow& row : breaks_of(evidence)) {
        const MemberRow& member = evidence.table.members[static_cast<std::size_t>(row.member)];
        times[row.mode][static_cast<std::size_t>(member.case_index)].push_back(row.time);
    }
    if (times.empty()) return {.before = "No joint failed in any member.\n"};
    Figure figure{.description = "Failed joints over time by mode, mean over arrangements",
                  .x = {"time since the tow began, s", 0, 1},
                  .legend = case_legend(evidence.summary),
                  .caption = "Failed joints so far, mean over arrangements"};
    for (const CaseSummary& row : cases)
        figure.x.high = std::max(figure.x.high, row.about.analysis.steady_start + row.about.analysis.window);
    std::vector<double> counts{1};
    for (auto& [mode, of_cases] : times) {
        const Stroke& stroke = strokes.at(static_cast<std::size_t>(mode));
        for (auto& [of_case, failed] : of_cases) {
            counts.push_back(static_cast<double>(failed.size()) / cases[of_case].done);
            figure.line(steps_of(std::move(failed), figure.x.high, cases[of_case].done),
                        colour(of_case) + stroke.style);
        }
        figure.caption += times.size() == 1 ? fmt::format("; all failed in {}", mode_name(mode))
                                            : fmt::format("{} {} {}", mode == times.begin()->first ? ":" : ",",
                                                          stroke.words, mode_name(mode));
    }
    figure.caption += ".";
    figure.y = axis_around("failed joints per run", counts, true);
    return {.figures = {std::move(figure)}};
}

Section joint_failures_section(Evidence& evidence) {
    std::vector<CaseFailures> cases;
    double largest = 0;
    for (const std::size_t k : drawn_cases(evidence.summary)) {
        std::optional<CaseFailures> found = failures_of(evidence, k);
        if (!found) continue;
        cases.push_back(std::move(*found));
        for (const double share : cases.back().of_joint) largest = std::max(largest, share);
    }
    Section section;
    if (largest == 0) return section;
    for (const CaseFailures& found : cases) {
        section.figures.push_back(panel(found, largest));
        if (found.total > 0) section.notes.push_back(sentence(found));
    }
    section.figures.back().caption =
        "How often each joint failed, % of all floes of all members; floes lie at every angle to the tow. All cases "
        "have the same colours." +
        undrawn_text(evidence.summary);
    return section;
}

}  // namespace floes
