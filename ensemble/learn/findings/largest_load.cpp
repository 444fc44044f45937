#include "findings/report_sections.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "core/units.hpp"
#include "scenario/floes.hpp"

namespace floes {
namespace {

Figure::Points corners(const PlanarPose& pose, const FloeShape& floe) {
    Figure::Points points;
    const double c = std::cos(pose.yaw);
    const double s = std::sin(pose.yaw);
    for (const Corner& own : floe.outline)
        points.emplace_back(pose.x + c * own.x + s * own.z, pose.z - s * own.x + c * own.z);
    if (floe.is_polygon()) return points;
    for (const auto& [a, b] : {std::pair{-1, -1}, {1, -1}, {1, 1}, {-1, 1}}) {
        const double along = a * floe.length / 2;
        const double across = b * floe.breadth / 2;
        points.emplace_back(pose.x + c * along + s * across, pose.z - s * along + c * across);
    }
    return points;
}

Figure plan_view(const Scenario& scenario, const FloeSet& floes, const std::vector<PlanarPose>& poses,
                 const std::set<int>& broken) {
    const Field& field = scenario.field;
    const double radius = scenario.structure.shape.largest_radius();
    const double low = std::min(scenario.structure.start - radius, field.begin) - 0.3;
    const double high = scenario.field_end() + std::min(field.sheet_width, 0.5);
    const double inner = field.half_width;
    const double half = inner + std::min(field.sheet_width, 0.5);
    Figure figure{.description = "The floes at the start, from above; floes that broke are marked",
                  .x = {"along the tow, m", low, high},
                  .y = {"across, m", -half, half},
                  .size = to_scale(high - low, 2 * half, 720)};
    for (const double sign : {-1.0, 1.0})
        figure.area(
            {{field.begin, sign * inner}, {high, sign * inner}, {high, sign * half}, {field.begin, sign * half}},
            "sheet");
    if (field.far_end == FarEnd::ice_sheet)
        figure.area({{scenario.field_end(), -inner}, {high, -inner}, {high, inner}, {scenario.field_end(), inner}},
                    "sheet");
    for (std::size_t i = 0; i < poses.size(); ++i)
        figure.area(corners(poses[i], floes.shape(i)), broken.contains(static_cast<int>(i)) ? "ice broken" : "ice");
    for (const std::vector<Vec2>& piece : scenario.structure.shape.waterlines()) {
        Figure::Points outline;
        for (const Vec2& point : piece) outline.emplace_back(scenario.structure.start + point.x(), point.y());
        figure.area(std::move(outline), "structure");
    }
    return figure;
}

}  // namespace

Section largest_load_section(Evidence& evidence) {
    const std::optional<int> number = most_loaded_member(evidence);
    if (!number || evidence.pictured) return {};
    const MemberRow& member = evidence.table.members[static_cast<std::size_t>(*number)];
    const auto of_case = static_cast<std::size_t>(member.case_index);
    std::set<int> broken;
    for (const BreakRow& row : breaks_of(evidence))
        if (row.member == *number) broken.insert(row.floe);
    const Scenario& scenario = evidence.campaign.cases[of_case].scenario;
    const FloeSet floes =
        floes_of(scenario, {arrangement_seed(evidence.campaign, member.case_index),
                            static_cast<std::uint32_t>(member_key(evidence.campaign, *number).arrangement)});
    Figure figure = plan_view(scenario, floes, read_poses(evidence.file, *number), broken);
    figure.caption = fmt::format(
        "Member {}, case {}: largest load {:.1f} N, mean {:.1f} N, {:.1f} % of the floes broke (marked).", *number,
        evidence.summary.name_of(of_case), member.load.maximum, member.load.mean, member.failure_ratio / unit::percent);
    return {.notes = {"To watch it: " + replay_command(evidence, *number)}, .figures = {std::move(figure)}};
}

}  // namespace floes
