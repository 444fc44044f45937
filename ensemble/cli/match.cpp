// floes match: which inputs do measured loads not rule out?

#include <algorithm>
#include <cmath>
#include <iostream>
#include <ranges>

#include "campaign/write.hpp"
#include "cli/commands.hpp"
#include "match/matching.hpp"
#include "page/match_page.hpp"

namespace floes {
namespace {

struct MatchOptions {
    std::vector<std::string> files;
    std::string targets;
    int samples = 8192;
    std::string next;
    int points = 40;
    std::vector<std::string> at;
    std::vector<std::string> predicted;
    double exposure_h = 0;  ///< 0: no design load
    DesignLoadRequest design;
    std::string page;
    std::string format = "table";
};

void write_next(const MatchOptions& options, const std::vector<MatchWave>& waves, const MatchData& data,
                const Matching& found) {
    if (found.left == 0)
        throw InputError("There is no next wave: nothing is left. Widen the ranges, or allow the model a discrepancy.");
    const Eigen::MatrixXd points = next_points(found, data, options.points);
    const std::filesystem::path path = options.next;
    write_new(path, write_campaign(next_wave(waves.front(), data.axes, points, path.stem().string(),
                                             waves.front().campaign.seed + waves.size())));
    note("{} has the next wave, {}{}; run it with floes run {}", path.string(), counted(points.rows(), "point"),
         points.rows() < options.points ? fmt::format(" (of {}: no more are left that differ)", options.points) : "",
         shell_word(path.string()));
}

/// The coordinates of a point given by KEY=VALUE pairs, one for each axis.
Eigen::VectorXd point_at(const std::vector<std::string>& pairs, const std::vector<RangedAxis>& axes) {
    Eigen::VectorXd at = Eigen::VectorXd::Constant(static_cast<Eigen::Index>(axes.size()), undefined);
    for (const std::string& pair : pairs) {
        const std::string key = pair.substr(0, pair.find('='));
        const auto axis = std::ranges::find(axes, key, &RangedAxis::key);
        double value = 0;
        char rest = 0;
        const std::string number = pair.find('=') == std::string::npos ? "" : pair.substr(pair.find('=') + 1);
        if (axis == axes.end() || std::sscanf(number.c_str(), "%lf%c", &value, &rest) != 1 || !std::isfinite(value) ||
            (axis->scale == AxisScale::log && value <= 0))
            throw InputError(fmt::format("--at {} is no KEY=NUMBER of an axis; the axes are {}.", pair,
                                         fmt::join(axes | std::views::transform(&RangedAxis::key), ", ")));
        // Beyond, emulators say anything; a rounded end of the range is not beyond.
        constexpr double end = 1 + 1e-6;
        const double coordinate = axis->coordinate(value);
        if (std::abs(coordinate) > end)
            throw InputError(
                fmt::format("--at {} lies outside the range of {} in the design, {:g} to {:g}; nothing "
                            "was run there that could be compared.",
                            pair, key, axis->from, axis->to));
        at[axis - axes.begin()] = coordinate;
    }
    for (std::size_t k = 0; k < axes.size(); ++k)
        if (std::isnan(at[static_cast<Eigen::Index>(k)]))
            throw InputError(fmt::format("--at needs a number for each axis; {} has none.", axes[k].key));
    return at;
}

/// Reads "QUANTITY" or "CASE:QUANTITY".
Section quantities_over(const OverLeft& left, const MatchOptions& options, const std::vector<MatchWave>& waves) {
    std::vector<Target> wanted;
    for (const std::string& word : options.predicted) {
        const std::size_t colon = word.find(':');
        const bool named = colon != std::string::npos;
        wanted.push_back(to_predict(named ? word.substr(colon + 1) : word, named ? word.substr(0, colon) : ""));
    }
    std::vector<Predicted> predicted;
    for (const EmulatedTarget& one : emulate(match_data(waves, wanted))) predicted.push_back(predict(left, one));
    return predicted_section(predicted);
}

Section design_over(const OverLeft& left, const MatchOptions& options, const std::vector<MatchWave>& waves,
                    const MatchData& data, const std::vector<EmulatedTarget>& targets) {
    DesignLoadRequest request = options.design;
    request.exposure = options.exposure_h * unit::hour;
    return design_section(predict_design_load(waves, data, targets, left, request), request);
}

std::vector<Section> predictions(const MatchOptions& options, const std::vector<MatchWave>& waves,
                                 const MatchData& data, const std::vector<EmulatedTarget>& targets,
                                 const Matching& found) {
    std::vector<Section> made;
    if (options.predicted.empty() && options.exposure_h == 0) return made;
    if (found.left == 0)
        return {
            {.title = "Predicted over what is not ruled out", .missing = "Nothing can be predicted: nothing is left."}};
    const OverLeft left(found, targets);
    if (!options.predicted.empty()) made.push_back(quantities_over(left, options, waves));
    if (options.exposure_h > 0) made.push_back(design_over(left, options, waves, data, targets));
    return made;
}

/// What is left after each wave; all of them together leave `share`.
std::vector<MatchTrail> trail_of(const MatchOptions& options, const std::vector<MatchWave>& waves,
                                 const std::vector<Target>& targets, double share) {
    std::vector<MatchTrail> trail;
    for (std::size_t count = 1; count <= waves.size(); ++count) {
        MatchTrail& told = trail.emplace_back(MatchTrail{waves[count - 1].file, 0, share});
        try {
            const MatchData data = match_data(std::span(waves).first(count), targets);
            told.points = static_cast<int>(data.points.size());
            if (count < waves.size())
                told.share = match(data, emulate(data), options.samples, waves.front().campaign.seed).share();
        } catch (const InputError&) {  // a case that only later waves have
            told.share = undefined;
        }
    }
    return trail;
}

std::string command_of(const MatchOptions& options) {
    std::string command = "floes match";
    for (const std::string& file : options.files) command += " " + shell_word(file);
    command += fmt::format(" --targets {} --samples {}", shell_word(options.targets), options.samples);
    for (const std::string& one : options.predicted) command += " --predict " + shell_word(one);
    if (options.exposure_h > 0)
        command += fmt::format(" --exposure-h {:g} --averaging-s {:g} --quantile {:g} --scale {:g}", options.exposure_h,
                               options.design.averaging, options.design.quantiles.front(), options.design.scale);
    return command + " -o " + shell_word(options.page);
}

int run(const MatchOptions& options) {
    std::vector<MatchWave> waves;
    for (const std::string& file : options.files) expect_campaign_file(file);
    for (const std::string& file : options.files) waves.push_back(read_wave(file));
    const std::vector<Target> measured = read_targets(read_text(options.targets), options.targets);
    const MatchData data = match_data(waves, measured);
    const WaitingNote patience(std::cerr, fmt::format("emulating {} at {} points",
                                                      counted(std::ssize(data.targets), "target"), options.samples));
    const std::vector<EmulatedTarget> targets = emulate(data);
    const Matching found = match(data, targets, options.samples, waves.front().campaign.seed);
    std::vector<Section> sections = match_sections(data, targets, found);
    if (!options.at.empty()) sections.push_back(point_section(data, targets, point_at(options.at, data.axes)));
    const std::vector<Section> predicted = predictions(options, waves, data, targets, found);
    sections.insert(sections.end(), predicted.begin(), predicted.end());
    print(sections, options.format);
    if (!options.next.empty()) write_next(options, waves, data, found);
    if (options.page.empty()) return 0;
    write_page(options.page, match_page({data, targets, found, trail_of(options, waves, measured, found.share()),
                                         predicted, command_of(options)}));
    note("{} has the page", options.page);
    return 0;
}

}  // namespace

void add_match(CommandLine& line) {
    auto options = std::make_shared<MatchOptions>();
    Verb verb = line.verb("match", "Which inputs do measured loads not rule out? History matching");
    verb.option("campaigns", options->files, "Campaign files with a [design] over the unknown inputs, wave by wave")
        .required();
    verb.option("--targets", options->targets, "TOML file with a [[target]] for each measured figure").required();
    verb.option("--samples", options->samples, "Points of the inputs' ranges to look at")
        .within(64, 1 << 20)
        .shows_default();
    verb.option("--next", options->next, "Write the next wave, a campaign inside what is left, to this TOML file")
        .writes_file();
    verb.option("--points", options->points, "Points of the next wave").within(1, 10000).shows_default();
    verb.option("--at", options->at, "KEY=VALUE of each axis: what is predicted at this point, and what rules it out")
        .one_each();
    verb.option("--predict", options->predicted,
                "QUANTITY or CASE:QUANTITY, as E60:mean_maximum_1s: what it is over the inputs that are left; may "
                "be repeated")
        .one_each();
    Option exposure =
        verb.option("--exposure-h", options->exposure_h,
                    "Predict the design load: the largest averaged load in this exposure, h at full scale")
            .within(1e-3, 1e6);
    verb.option("--averaging-s", options->design.averaging,
                "Time that the design load is averaged over, s at full scale")
        .positive()
        .shows_default()
        .needs(exposure);
    verb.option("--quantile", options->design.quantiles.front(),
                "Probability that the design load is not exceeded in the exposure")
        .within(0.001, 0.99999)
        .shows_default()
        .needs(exposure);
    verb.option("--scale", options->design.scale,
                "Length at full scale over length in the campaign, for the design load (Froude)")
        .within(1.0, 1000.0)
        .shows_default()
        .needs(exposure);
    verb.option("-o,--output", options->page, "Write a page with figures (.html, .pdf)")
        .file_ending({".html", ".htm", ".pdf"});
    add_format(verb, options->format);
    verb.footer(
        "Emulators predict each target over the design's axes. A point is ruled out when a target is more than three\n"
        "standard deviations from its prediction there (more where the scatter is known from few runs), counting the\n"
        "scatter of single runs, the measurement's uncertainty and the discrepancy that the model is allowed.\n\n"
        "  floes run wave1.toml && floes match wave1.h5 --targets tank.toml --next wave2.toml\n"
        "  floes run wave2.toml && floes match wave1.h5 wave2.h5 --targets tank.toml --exposure-h 3");
    verb.runs([options] { return run(*options); });
}

}  // namespace floes
