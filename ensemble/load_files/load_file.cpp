#include "load_files/load_file.hpp"

#include <array>
#include <cmath>
#include <string>

#include <fmt/format.h>

#include "core/text.hpp"

namespace floes {

namespace {

constexpr std::string_view csv_endings[]{".csv"};
constexpr std::string_view text_endings[]{".dat", ".txt"};
constexpr std::string_view python_endings[]{".py"};

constexpr LoadFormat formats[]{
    {"csv", "a table of means with a legend, for every other program", csv_endings, true, csv_files},
    {"openfast", "a structural control on the platform, of OpenFAST 5.0 and later", text_endings, true, openfast_files},
    {"openfast4", "the same of OpenFAST 3.1 to 4.2", text_endings, true, openfast_4_files},
    {"subdyn", "an applied load of SubDyn's own driver", csv_endings, false, subdyn_files},
    {"orcaflex", "an external function of OrcaFlex, in Python", python_endings, true, orcaflex_files},
};

std::string hull_words(const LoadOrigin& origin) {
    return fmt::format("The hull of that run {}. How the hull of another program moves does not change this load.",
                       origin.hull_went);
}

std::string axes_words(const LoadToWrite& load) {
    if (load.axes == LoadAxes::hull)
        return "Axes: X towards the bow, Y to port, Z up, turning with the hull's yaw. Ice ahead of the hull pushes it "
               "to "
               "-X.";
    if (load.tow_towards == 0)
        return "Axes: X along the channel as the tow goes, Y to port, Z up, at rest in the earth. Ice ahead of the "
               "hull pushes it to -X.";
    return fmt::format(
        "Axes: Z up, X and Y at rest in the earth; the tow goes {:g} degrees from X towards Y. Ice ahead of the hull "
        "pushes it against the tow.",
        load.tow_towards);
}

std::string value_words(const LoadToWrite& load, bool held) {
    std::string text =
        held ? fmt::format(
                   "Values: each is the mean over {0:.9g} s and stands in the middle of them. Linear in between, "
                   "with the first and the last one held, the impulse from t = 0 to {1:.9g} s is that of the run. "
                   "End there: the last value is held after it.",
                   load.series.step, load.series.length())
             : fmt::format("Values: means over {:.9g} s each, from from_s to to_s.", load.series.step);
    if (load.origin.averaged_steps > 1)
        text += fmt::format(" The run kept means over {} time steps, so that shorter peaks are not in them.",
                            load.origin.averaged_steps);
    return text;
}

std::string mean_text(double value) {
    return std::isnan(value) ? "unknown" : fmt::format("{:.6g}", value);
}

/// `zero`: the file has columns for what is not known.
std::string moment_words(const LoadToWrite& load, bool zero) {
    const double power = std::pow(load.scale, 4);
    const bool has = !load.series.moment.empty();
    std::string text = fmt::format(
        "Missing: the moments about X and Y are not kept step by step{}{}. Means in the window about the hull's own X "
        "and Y: "
        "{} and {} N m",
        has ? "" : ", and nor is that about Z, which is kept of hulls that turn or give way",
        zero ? "; they are zero here" : "", mean_text(power * load.origin.mean_roll),
        mean_text(power * load.origin.mean_pitch));
    if (!has) text += fmt::format("; about Z: {} N m", mean_text(power * load.origin.mean_yaw));
    return text + ".";
}

}  // namespace

std::span<const LoadFormat> load_formats() {
    return formats;
}

std::vector<std::string> legend(const LoadToWrite& load, bool held, std::string_view force, std::string_view moment) {
    const LoadOrigin& origin = load.origin;
    std::vector<std::string> lines{
        fmt::format("Load of ice on a structure, written by {}.", origin.program),
        fmt::format("Campaign {} (fingerprint {}), case {}, arrangement {}, member {}.", origin.campaign,
                    origin.fingerprint, origin.case_name, origin.arrangement, origin.member)};
    if (!origin.chosen.empty()) lines.push_back(origin.chosen);
    lines.emplace_back(
        "Load: the contact force of the ice on the hull. Water, wind, weight, thrusters and moorings are not in it.");
    lines.push_back(hull_words(origin));
    lines.push_back(axes_words(load));
    if (load.tilts)
        lines.emplace_back(
            "But the forces are along axes that pitch and roll with the hull, because the campaign file does not say "
            "how it pitched and rolled.");
    lines.emplace_back("Point: the structure's axis in the calm waterline, where the hull has come to.");
    lines.push_back(fmt::format("Units: s, {}, {}.", force, moment));
    lines.push_back(value_words(load, held));
    lines.push_back(fmt::format("Time: t = 0 is {:.9g} s of the run.", load.begin));
    if (load.scale != 1)
        lines.push_back(
            fmt::format("Scale: by Froude, lengths {0:g} times those of the campaign, times {1:.6g}, forces {2:.6g}; "
                        "times here are so.",
                        load.scale, std::sqrt(load.scale), std::pow(load.scale, 3)));
    const std::array<double, 4> sums = impulse(load.series);
    lines.push_back(fmt::format("Impulse of all, N s: X {:.9g}, Y {:.9g}, Z {:.9g}{}.", sums[0], sums[1], sums[2],
                                load.series.moment.empty() ? "" : fmt::format("; about Z {:.9g} N m s", sums[3])));
    lines.push_back(moment_words(load, held));
    // Names come from other people, and a line of its own would be read as values, or as a program.
    for (std::string& line : lines) line = in_one_line(std::move(line));
    return lines;
}

std::string commented(const std::vector<std::string>& lines) {
    std::string text;
    for (const std::string& line : lines) text += "# " + line + "\n";
    return text;
}

std::vector<WrittenLoad> csv_files(const LoadToWrite& load, const std::string& path) {
    const LoadSeries& series = load.series;
    const bool moment = !series.moment.empty();
    std::string text = commented(legend(load, false, "N", "N m"));
    text += moment ? "from_s,to_s,FX_N,FY_N,FZ_N,MZ_N_m\n" : "from_s,to_s,FX_N,FY_N,FZ_N\n";
    for (std::size_t k = 0; k < series.cells(); ++k) {
        const auto number = static_cast<double>(k);
        text += fmt::format("{:.9g},{:.9g},{:.9g},{:.9g},{:.9g}", series.step * number, series.step * (number + 1),
                            series.force[0][k], series.force[1][k], series.force[2][k]);
        text += moment ? fmt::format(",{:.9g}\n", series.moment[k]) : "\n";
    }
    return {{path, text}};
}

}  // namespace floes
