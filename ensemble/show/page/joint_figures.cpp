// Where floes fail: a floe with its joints.

#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "core/units.hpp"
#include "ice/failure_mode.hpp"
#include "ice/floe_grid.hpp"
#include "page/plot.hpp"
#include "page/where_section.hpp"

namespace floes {
namespace {

const Scenario& scenario_of(const ReportData& data, std::size_t of_case) {
    return data.campaign.cases[of_case].scenario;
}

/// How often each joint failed in one floe of one member, 0 to 1, by joint and mode.
using Failures = std::vector<std::map<int, double>>;

Failures failures_of(const ReportData& data, std::size_t of_case, std::size_t joints) {
    const double floes = 1.0 * data.summary.cases[of_case].done * scenario_of(data, of_case).field.floes;
    Failures found(joints);
    for (const BreakRow& row : data.breaks) {
        if (data.table.members[static_cast<std::size_t>(row.member)].case_index != static_cast<int>(of_case)) continue;
        found.at(static_cast<std::size_t>(row.joint))[row.mode] += 1 / floes;
    }
    return found;
}

double total(const std::map<int, double>& by_mode) {
    double sum = 0;
    for (const auto& [mode, share] : by_mode) sum += share;
    return sum;
}

/// "bending 97 %, shear 3 %", the most frequent first.
std::string mode_words(const Failures& failures) {
    std::map<int, double> of_mode;
    double all = 0;
    for (const std::map<int, double>& joint : failures) {
        for (const auto& [mode, share] : joint) of_mode[mode] += share;
        all += total(joint);
    }
    std::vector<std::pair<double, int>> sorted;
    for (const auto& [mode, share] : of_mode) sorted.emplace_back(share, mode);
    std::ranges::sort(sorted, std::ranges::greater{});
    std::string words;
    for (const auto& [share, mode] : sorted)
        words += fmt::format("{}{} {:.0f} %", words.empty() ? "" : ", ",
                             failure_mode_names.at(static_cast<std::size_t>(mode)), share / all / unit::percent);
    return words;
}

std::string joint_panel(const ReportData& data, std::size_t of_case, const Failures& failures, double largest) {
    constexpr std::size_t most_numbers = 40;  // joints; more have no room for them
    constexpr double widest = 188;            // three panels stand side by side
    const FloeShape& floe = scenario_of(data, of_case).floe;
    const FloeGrid grid = grid_of(floe);
    const double half_length = 0.55 * floe.length;
    const double half_breadth = 0.55 * floe.breadth;
    const double scale = widest / 2 / std::max(half_length, half_breadth);
    const std::string name = data.summary.cases[of_case].about.name;
    Plot plot(fmt::format("Case {}: how often each joint of a floe failed", name),
              {fmt::format("{}: along the floe, m", name), -half_length, half_length, false, {}, floe.length / 2},
              {"across, m", -half_breadth, half_breadth, false, {}, floe.breadth / 2},
              {std::max(268.0, 80 + 2 * scale * half_length), 74 + 2 * scale * half_breadth});
    const double side = grid.element;
    for (int element = 0; element < grid.elements(); ++element) {
        const Vec3 at = grid.centre(element);
        plot.cell(at.x() - 0.39 * side, at.z() - 0.39 * side, 0.78 * side, 0.78 * side, 1, "ice");
    }
    const std::vector<GridJoint> joints = joint_order(grid);
    for (std::size_t k = 0; k < joints.size(); ++k) {
        const Vec3 at = grid.pivot(joints[k]);
        const bool along = joints[k].axis == JointAxis::x;
        const double x = (along ? 0.22 : 0.78) * side;
        const double z = (along ? 0.78 : 0.22) * side;
        plot.cell(at.x() - x / 2, at.z() - z / 2, x, z, total(failures[k]) / largest, "heat");
        if (joints.size() <= most_numbers)
            plot.text(at.x(), at.z() - 0.03 * side, fmt::format("{:.1f}", total(failures[k]) / unit::percent), "middle",
                      "key");
    }
    plot.colour_bar("heat", fmt::format("up to {:.1f} %", largest / unit::percent));
    return plot.svg();
}

}  // namespace

std::vector<std::string> joint_failure_figures(const ReportData& data) {
    std::vector<std::pair<std::size_t, Failures>> of_cases;
    double largest = 0;
    for (const std::size_t k : data.drawn_cases) {
        const FloeGrid grid = grid_of(scenario_of(data, k).floe);
        of_cases.emplace_back(k, failures_of(data, k, joint_order(grid).size()));
        for (const std::map<int, double>& joint : of_cases.back().second) largest = std::max(largest, total(joint));
    }
    std::vector<std::string> figures;
    if (largest == 0) return figures;
    for (const auto& [of_case, failures] : of_cases) figures.push_back(joint_panel(data, of_case, failures, largest));
    return figures;
}

std::vector<std::string> joint_failure_sentences(const ReportData& data) {
    std::vector<std::string> sentences;
    for (const std::size_t k : data.drawn_cases) {
        const Failures failures = failures_of(data, k, joint_order(grid_of(scenario_of(data, k).floe)).size());
        double in_a_floe = 0;
        for (const std::map<int, double>& joint : failures) in_a_floe += total(joint);
        if (in_a_floe == 0) continue;
        sentences.push_back(fmt::format("{}: {:.1f} joints failed in a member: {}.", data.summary.cases[k].about.name,
                                        in_a_floe * scenario_of(data, k).field.floes, mode_words(failures)));
    }
    return sentences;
}

}  // namespace floes
