// floes design: the largest load in an exposure, or the loads of a year, with their uncertainty.

#include <cstdio>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "cli/commands.hpp"
#include "cli/design_year.hpp"
#include "cli/given_file.hpp"
#include "cli/mooring_options.hpp"
#include "cli/terminal.hpp"
#include "core/units.hpp"
#include "findings/design_load_section.hpp"
#include "findings/evidence.hpp"
#include "findings/moored_cases.hpp"
#include "findings/warnings.hpp"

namespace floes {
namespace {

struct DesignOptions {
    std::string file;
    double exposure_h = 3;
    DesignLoadRequest request;
    std::string format = "table";
    std::string window = "given";
    std::string of = "load";
    YearOptions year;
    MooringOptions mooring;
};

/// Design mooring forces instead of loads, and what they come from.
std::vector<Section> moored(const Evidence& evidence, DesignLoadRequest request, const Oscillator& hull) {
    request.force = DesignLoadRequest::Force::k_x;
    const MooredRequest asked{hull, request.scale, request.averaging};
    const std::vector<MooredCase> found = find_moored(evidence, asked);
    const std::vector<CasePeaks> peaks = moored_peaks(evidence.table, found);
    std::vector<Section> sections =
        design_load_sections(evidence.summary, find_design_loads(evidence.table, request, peaks), request);
    sections.push_back(moored_section(evidence.summary, found, asked));
    return sections;
}

/// Design mooring forces of structures that gave way in the simulation, and how those moved.
std::vector<Section> simulated(const Evidence& evidence, DesignLoadRequest request) {
    request.force = DesignLoadRequest::Force::moorings;
    const std::vector<CasePeaks> peaks = simulated_mooring_peaks(evidence);
    std::vector<Section> sections =
        design_load_sections(evidence.summary, find_design_loads(evidence.table, request, peaks), request);
    sections.front().before = mooring_notes(evidence) + sections.front().before;
    if (std::optional<Section> moved = moored_runs_section(evidence)) sections.push_back(std::move(*moved));
    return sections;
}

std::vector<Section> sections_of(const DesignOptions& options, const Evidence& evidence,
                                 const DesignLoadRequest& request) {
    if (options.of == "mooring_force") return simulated(evidence, request);
    if (const std::optional<Oscillator> hull = options.mooring.hull()) return moored(evidence, request, *hull);
    return design_load_sections(evidence.summary, find_design_loads(evidence.table, request), request);
}

std::string answer(const DesignOptions& options) {
    DesignLoadRequest request = options.request;
    request.exposure = options.exposure_h * unit::hour;
    expect_campaign_file(options.file);
    const Evidence evidence = read_evidence(CampaignFile(options.file), options.window == "auto");
    std::vector<Section> sections = sections_of(options, evidence, request);
    sections.front().before = warning_lines(warnings_of(evidence.table, evidence.summary)) + sections.front().before;
    return written(sections, options.format);
}

void answer_of_year(const DesignOptions& options, const std::string& program) {
    YearOptions year = options.year;
    year.file = options.file;
    year.load = options.request;
    year.format = options.format;
    year.automatic_window = options.window == "auto";
    year.program = program;
    expect_campaign_file(year.file);
    tell_year(year);
}

void add_year(Verb& verb, YearOptions& year, const Option& exposure, const Option& quantile, const Option& mooring,
              const Option& of) {
    Option regimes = verb.option(
        "--regimes", year.regimes,
        "The loads of a year instead: TOML file with a [[regime]] for each kind of ice, its hours a year and "
        "its case or place in the design; or a scatter diagram (.csv)");
    regimes.excludes(exposure).excludes(quantile).excludes(mooring).excludes(of);
    verb.option("--per-year", year.per_year, "Probabilities of exceedance in a year, comma-separated")
        .comma_separated()
        .within(1e-7, 0.5)
        .shows_default()
        .needs(regimes);
    verb.flag("--next", year.next, "Of a year: the command that runs what its loads are least certain of")
        .needs(regimes);
    verb.option("-o,--output", year.output,
                "Of a year: write a page (.html), the exceedance curve (.svg) or a workbook (.xlsx)")
        .needs(regimes);
}

}  // namespace

void add_design(CommandLine& line) {
    auto options = std::make_shared<DesignOptions>();
    Verb verb = line.verb("design", "Design load: the largest load in an exposure, or in a year, with its uncertainty");
    verb.option("campaign", options->file, "The campaign file (CAMPAIGN.h5)").required();
    Option exposure = verb.option("--exposure-h", options->exposure_h, "Exposure, h at full scale");
    exposure.within(1e-3, 1e6).shows_default();
    Option quantile = verb.option("--quantile", options->request.quantiles,
                                  "Probabilities that the load is not exceeded in the exposure, comma-separated");
    quantile.comma_separated().within(0.001, 0.99999).shows_default();
    verb.option("--averaging-s", options->request.averaging,
                "Time that the load is averaged over, s at full scale: one of the campaign's analysis.averaging_s")
        .positive()
        .shows_default();
    verb.option("--scale", options->request.scale,
                "Length at full scale over length in the campaign: loads grow with its cube, times with its square "
                "root (Froude)")
        .within(1.0, 1000.0)
        .shows_default();
    verb.option("--peaks", options->request.share, "Share of the peaks, the highest, that the tails are fitted to")
        .within(0.01, 0.9)
        .shows_default();
    verb.flag("--rising", options->request.rising, "Extrapolate also a load that still rises in the measured window");
    Option mooring = add_mooring(verb, options->mooring);
    Option of = verb.option("--of", options->of,
                            "load, or mooring_force: what springs and lines bear of the surge load, of structures that "
                            "give way in the simulation");
    of.one_of({"load", "mooring_force"}).shows_default().excludes(mooring);
    add_year(verb, options->year, exposure, quantile, mooring, of);
    add_window(verb, options->window);
    add_format(verb, options->format);
    verb.footer(
        "The exposure passes through many arrangements, so the members of a case are pieces of it. Loads of single\n"
        "steps depend on the time step and are no design loads; averaged ones do not (docs/convergence.md).\n\n"
        "  floes design table3_physical.h5\n"
        "  floes design table3_physical.h5 --exposure-h 10 --quantile 0.5,0.9,0.99 --averaging-s 2\n"
        "  floes design table3_physical.h5 --scale 36 --averaging-s 6 --exposure-h 3      loads at full scale\n"
        "  floes design full_scale.h5 --mooring-kN-m 2600 --mass-t 42000 --damping-percent 10    of a moored hull\n"
        "  floes design moored_free.h5 --scale 57 --of mooring_force                      of one that gives way\n"
        "  floes design table3_physical.h5 --regimes year.toml                            10^-2 and 10^-4 a year");
    verb.runs([options, &line] {
        if (!options->year.regimes.empty()) {
            answer_of_year(*options, line.program_name());
            return 0;
        }
        std::fputs(answer(*options).c_str(), stdout);
        return 0;
    });
}

}  // namespace floes
