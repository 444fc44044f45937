// floes report: a campaign, complete or not, as one HTML page, with pictures of its worst moments, computed again on
// all cores.

#include <algorithm>
#include <cmath>
#include <iostream>

#include <tbb/parallel_for.h>

#include "cli/commands.hpp"
#include "draw/picture.hpp"
#include "findings/page_one.hpp"
#include "page/page.hpp"
#include "replay/replay_member.hpp"
#include "run/calibrate.hpp"

namespace floes {

namespace {

constexpr double round_worst = 10;  // s of load history beside the largest

/// What is asked of the worst moment: the mooring force where some structure gives way and springs or lines hold it,
/// over 1 s if each window has such means, else the load of a step.
Asked asked_of(const Evidence& evidence) {
    const bool moored = std::ranges::any_of(evidence.campaign.cases, [](const Case& one) {
        const Moorings& moorings = one.scenario.moorings;
        return moorings.give_way() && one.scenario.analysis.keep_history && moorings.stiffness()(0, 0) > 0;
    });
    if (!moored) return {};
    const Asked over_1_s{AskedOf::mooring_force, 1};
    const bool has_means = std::ranges::all_of(evidence.campaign.cases, [&](const Case& one) {
        const Analysis& analysis = one.scenario.analysis;
        const double step = one.scenario.general.time_step * analysis.history_stride;
        return averaging_refusal(over_1_s, step, analysis.window).empty();
    });
    return has_means ? over_1_s : Asked{AskedOf::mooring_force, 0};
}

/// For each case, the member with the largest value or, unless `all`, only that of the campaign.
std::vector<int> pictured_members(const Evidence& evidence, const Asked& asked, bool all) {
    const std::vector<double> values = largest_values(evidence.file, evidence.table, asked);
    std::vector<std::optional<int>> worst(all ? evidence.table.cases.size() : 1);
    for (std::size_t k = 0; k < values.size(); ++k) {
        if (!evidence.table.members[k].done() || std::isnan(values[k])) continue;
        std::optional<int>& of_case = worst[all ? evidence.case_of(static_cast<int>(k)) : 0];
        if (!of_case || values[k] > values[static_cast<std::size_t>(*of_case)]) of_case = static_cast<int>(k);
    }
    std::vector<int> members;
    for (const std::optional<int>& one : worst)
        if (one) members.push_back(*one);
    return members;
}

std::string drawn(const Stage& stage, const Frame& frame, const PictureStyle& style) {
    Canvas canvas(style.width, picture_height(style, stage.subject()));
    draw_picture(canvas, stage, frame, style);
    return canvas.png();
}

std::vector<MomentPicture> pictures_of(const KeyFrames& frames) {
    const Stage stage(frames.about, {frames.history, frames.breaks, frames.hull});
    const PictureStyle plan{.view = View::plan, .width = 1040};
    const double worst = frames.worst.time;
    const PictureStyle near{.width = 1040,
                            .height = 650,
                            .from = std::max(0.0, worst - round_worst),
                            .to = std::min(worst + round_worst, frames.end.time)};
    return {{drawn(stage, frames.worst, near),
             fmt::format(
                 "The largest {}. Arrows are the load on the structure and its surge, sway and heave parts, lines the "
                 "forces on floes at their contacts.",
                 frames.about.asked.words())},
            {drawn(stage, frames.start, plan), "The same floes before the tow."},
            {drawn(stage, frames.end, plan), "And at its end."}};
}

/// Fills data.moments; `all`: of each case, else of the campaign. Costs as much as the members did.
void add_moments(const std::filesystem::path& file, bool all, ReportData& data) {
    const Asked asked = asked_of(data.evidence);
    std::vector<ReplaySubject> subjects;
    std::vector<double> times;  // found one by one: the file is read by one thread
    for (const int member : pictured_members(data.evidence, asked, all)) {
        subjects.push_back(replay_subject(file, data.evidence.table, member));
        subjects.back().about.asked = asked;
        times.push_back(time_of_largest(subjects.back()));
    }
    if (subjects.empty()) return;
    const WaitingNote patience(
        std::cerr, fmt::format("computing {} again for pictures of the largest {}; --pictures none leaves them out",
                               counted(std::ssize(subjects), "member"), asked.words()));
    std::vector<KeyFrames> frames(subjects.size());
    tbb::parallel_for(std::size_t{0}, subjects.size(),
                      [&](std::size_t k) { frames[k] = key_frames(subjects[k], times[k]); });
    for (std::size_t k = 0; k < subjects.size(); ++k)
        data.moments.push_back({.member = subjects[k].about.member,
                                .of = asked == Asked{} ? "" : std::string{name_of(asked.of)},
                                .pictures = pictures_of(frames[k]),
                                .differences = differences(subjects[k], frames[k].result)});
}

struct ReportOptions {
    std::vector<std::string> files;
    std::string output;
    bool skip_plate_tests = false;
    std::string pictures = "worst";
    double exposure_h = 3;
    DesignLoadRequest design;
    bool asks_design = false;
    bool asks_averaging = false;
    std::string title;
    std::string author;
    Inquiry inquiry;
};

/// What is printed: where the page is.
std::string report(const ReportOptions& options) {
    const GivenCampaign given(options.files);
    const std::filesystem::path& file = given.path();
    const std::filesystem::path output = options.output.empty() ? file.stem().string() + ".html" : options.output;
    expect_place(output);  // before a member is computed again for its pictures
    ReportData data{read_evidence(file), {}, ""};
    if (options.asks_design) {
        data.evidence.design_request = options.design;
        data.evidence.design_request->exposure = options.exposure_h * unit::hour;
        if (options.asks_averaging)
            averaging_time(data.evidence.sample, options.design);  // refuses before a member is computed again
        else
            data.evidence.design_request->averaging = usual_averaging(data.evidence.sample);
    }
    data.evidence.safety_factor = options.inquiry.safety_factor;
    data.title = options.title;
    data.author = options.author;
    const Scenario& first = data.evidence.campaign.cases.front().scenario;
    const bool follows_cfm = first.joint.model == JointModel::cfm;  // else there is no curve: E is what it says
    if (!options.skip_plate_tests && follows_cfm) data.evidence.plate_tests = measure_curve(curve_plans(first));
    if (options.pictures != "none") add_moments(file, options.pictures == "all", data);
    data.command = fmt::format("floes run {} -o {}", configuration_word(data.evidence.summary.title),
                               shell_word(data.evidence.summary.title + ".h5"));
    write_page(output, report_page(std::move(data)));
    return output.string() + "\n";
}

}  // namespace

void add_report(CommandLine& line) {
    auto options = std::make_shared<ReportOptions>();
    Verb verb = line.verb("report", "Write one self-contained page with the tables and figures of a campaign");
    verb.option("campaign", options->files, "The campaign file (CAMPAIGN.h5), or the parts of one").required();
    verb.option("-o,--output", options->output,
                "The page; default: CAMPAIGN.html in this folder. With the ending .pdf a browser of Chromium's kind "
                "prints it")
        .file_ending({".html", ".htm", ".pdf"});
    const Option exposure = add_exposure(verb, options->exposure_h);
    const Option quantile = add_quantiles(verb, options->design.quantiles);
    const Option averaging = add_averaging(verb, options->design.averaging);
    verb.option("--safety-factor", options->inquiry.safety_factor,
                "Of mooring lines: break load over design tension; that of ISO 19901-7 for a whole mooring by default")
        .within(1.0, 100.0)
        .shows_default();
    verb.option("--title", options->title, "Of the page; by default the campaign's name");
    verb.option("--author", options->author, "Who is named below the title");
    verb.flag("--no-plate-tests", options->skip_plate_tests,
              "Omit the E-Σ curve of this ice, whose plate tests take some seconds");
    verb.option(
            "--pictures", options->pictures,
            "Pictures of the member with the largest load or, of a moored hull, mooring force, which is computed again "
            "for them: worst, the one of the campaign; all, that of each case; none")
        .one_of({"none", "worst", "all"})
        .shows_default();
    verb.prints([options, exposure, quantile, averaging] {
        options->asks_averaging = averaging.given();
        options->asks_design = exposure.given() || quantile.given() || averaging.given();
        return report(*options);
    });
}

}  // namespace floes
