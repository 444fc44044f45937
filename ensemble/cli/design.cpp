// floes design: the largest load in an exposure, with its uncertainty.

#include <cstdio>
#include <memory>
#include <string>
#include <vector>

#include "cli/commands.hpp"
#include "cli/given_file.hpp"
#include "cli/terminal.hpp"
#include "core/units.hpp"
#include "findings/design_load_section.hpp"
#include "findings/evidence.hpp"
#include "findings/warnings.hpp"

namespace floes {
namespace {

struct DesignOptions {
    std::string file;
    double exposure_h = 3;
    DesignLoadRequest request;
    std::string format = "table";
    std::string window = "given";
};

std::string answer(const DesignOptions& options) {
    DesignLoadRequest request = options.request;
    request.exposure = options.exposure_h * unit::hour;
    expect_campaign_file(options.file);
    const Evidence evidence = read_evidence(CampaignFile(options.file), options.window == "auto");
    const std::vector<CaseDesignLoad> designs = find_design_loads(evidence.table, request);
    std::vector<Section> sections = design_load_sections(evidence.summary, designs, request);
    sections.front().before = warning_lines(warnings_of(evidence.table, evidence.summary)) + sections.front().before;
    return written(sections, options.format);
}

}  // namespace

void add_design(CommandLine& line) {
    auto options = std::make_shared<DesignOptions>();
    Verb verb = line.verb("design", "Design load: the largest load in an exposure, with its uncertainty");
    verb.option("campaign", options->file, "The campaign file (CAMPAIGN.h5)").required();
    verb.option("--exposure-h", options->exposure_h, "Exposure, h at full scale").within(1e-3, 1e6).shows_default();
    verb.option("--quantile", options->request.quantiles,
                "Probabilities that the load is not exceeded in the exposure, comma-separated")
        .comma_separated()
        .within(0.001, 0.99999)
        .shows_default();
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
    add_window(verb, options->window);
    add_format(verb, options->format);
    verb.footer(
        "The exposure passes through many arrangements, so the members of a case are pieces of it. Loads of single\n"
        "steps depend on the time step and are no design loads; averaged ones do not (docs/convergence.md).\n\n"
        "  floes design table3_physical.h5\n"
        "  floes design table3_physical.h5 --exposure-h 10 --quantile 0.5,0.9,0.99 --averaging-s 2\n"
        "  floes design table3_physical.h5 --scale 36 --averaging-s 6 --exposure-h 3      loads at full scale");
    verb.runs([options] {
        std::fputs(answer(*options).c_str(), stdout);
        return 0;
    });
}

}  // namespace floes
