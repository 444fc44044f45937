#include "findings/failures.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <map>

#include "ice/failure_mode.hpp"

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

}  // namespace

std::string mode_name(int mode) {
    return mode == static_cast<int>(FailureMode::in_plane_bending)
               ? "in-plane bending"
               : failure_mode_names.at(static_cast<std::size_t>(mode));
}

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

}  // namespace floes
