#include "cli/report_moments.hpp"

#include <fmt/format.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <iostream>

#include "cli/waiting_note.hpp"
#include "core/wording.hpp"
#include "picture/picture.hpp"
#include "replay/replay_member.hpp"

namespace floes {
namespace {

constexpr double round_worst = 10;  // s of load history beside the largest

/// Of each case the member with the largest load or, unless `all`, only that of the campaign.
std::vector<int> pictured_members(const Evidence& evidence, bool all) {
    if (!all) {
        const std::optional<int> worst = most_loaded_member(evidence);
        return worst ? std::vector{*worst} : std::vector<int>{};
    }
    std::vector<int> members;
    for (int k = 0; k < std::ssize(evidence.table.cases); ++k) {
        const auto worst =
            member_with_largest_load(evidence.table, [k](const MemberRow& row) { return row.case_index == k; });
        if (worst) members.push_back(*worst);
    }
    return members;
}

std::string drawn(const Stage& stage, const Frame& frame, const PictureStyle& style) {
    Canvas canvas(style.width, picture_height(style, stage.subject()));
    draw_picture(canvas, stage, frame, style);
    return canvas.png();
}

std::vector<MomentPicture> pictures_of(const KeyFrames& frames) {
    const Stage stage(frames.about, {frames.history, frames.breaks});
    const PictureStyle plan{.view = View::plan, .width = 1040};
    const double worst = frames.worst.time;
    const PictureStyle near{.width = 1040,
                            .height = 650,
                            .from = std::max(0.0, worst - round_worst),
                            .to = std::min(worst + round_worst, frames.end.time)};
    return {
        {drawn(stage, frames.worst, near),
         "The largest load of a step. Arrows are the load on the structure and its surge, sway and heave parts, lines "
         "the forces on floes at their contacts (the paper's Fig. 5)."},
        {drawn(stage, frames.start, plan), "The same floes before the tow."},
        {drawn(stage, frames.end, plan), "And at its end."}};
}

}  // namespace

void add_moments(const std::filesystem::path& file, bool all, ReportData& data) {
    std::vector<ReplaySubject> subjects;
    for (const int member : pictured_members(data.evidence, all))
        subjects.push_back(replay_subject(file, data.evidence.table, member));
    if (subjects.empty()) return;
    const WaitingNote patience(std::cerr,
                               fmt::format("computing {} again for pictures of the largest loads; --pictures none "
                                           "leaves them out",
                                           counted(std::ssize(subjects), "member")));
    std::vector<KeyFrames> frames(subjects.size());
    tbb::parallel_for(std::size_t{0}, subjects.size(), [&](std::size_t k) { frames[k] = key_frames(subjects[k]); });
    for (std::size_t k = 0; k < subjects.size(); ++k)
        data.moments.push_back({.member = subjects[k].about.member,
                                .pictures = pictures_of(frames[k]),
                                .differences = differences(subjects[k], frames[k].result)});
}

}  // namespace floes
