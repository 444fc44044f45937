// floes contour: environmental contours of two inputs, as a table, a picture, or cases to run.

#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <memory>
#include <string>
#include <vector>

#include "campaign/name_list.hpp"
#include "campaign/read.hpp"
#include "campaign/variations.hpp"
#include "cli/commands.hpp"
#include "cli/config_file.hpp"
#include "cli/terminal.hpp"
#include "cli/write_page.hpp"
#include "core/error.hpp"
#include "core/units.hpp"
#include "core/wording.hpp"
#include "keys/literal.hpp"
#include "page/sections_page.hpp"
#include "year/contour_section.hpp"

namespace floes {
namespace {

struct ContourOptions {
    std::string ice;
    double exposure_h = 3;
    ContourRequest request;
    std::string config;
    std::string case_name;
    std::vector<std::string> overrides;
    std::string output;
    std::string format = "table";
};

/// "0.01_deg045".
std::string case_name(const ContourOf& of, const ContourPoint& point) {
    return fmt::format("{:g}_deg{:03.0f}", of.per_year, point.degrees);
}

/// To four digits: fitted inputs are not known better.
std::string value_text(double value) {
    return number_literal(std::stod(fmt::format("{:.4g}", value)));
}

/// What the point's values are refused for, as a case of its own; empty if they can be run.
std::string fault_of(const Campaign& campaign, const Case& of, const Variation& one) {
    try {
        read_campaign({study_text(campaign, of, {one}), one.name, {}}, read_text);
        return "";
    } catch (const InputError& error) {
        return error.what();
    }
}

std::vector<Variation> cases_at(const ContourInputs& inputs, const std::vector<ContourOf>& contours) {
    std::vector<Variation> cases;
    for (const ContourOf& of : contours)
        for (const ContourPoint& point : of.points)
            cases.push_back(
                {case_name(of, point),
                 fmt::format("{:g} a year, at {:.0f} degrees", of.per_year, point.degrees),
                 {{inputs.keys[0], value_text(point.value[0])}, {inputs.keys[1], value_text(point.value[1])}}});
    return cases;
}

std::string study_of(const ContourOptions& options, const ContourInputs& inputs,
                     const std::vector<ContourOf>& contours) {
    const Campaign campaign = load_campaign(options.config, options.overrides);
    const Case& of = chosen_case(campaign, options.case_name);
    std::vector<Variation> cases;
    std::vector<std::string> left_out;
    std::string first_fault;
    for (Variation& one : cases_at(inputs, contours)) {
        const std::string fault = fault_of(campaign, of, one);
        if (fault.empty()) {
            cases.push_back(std::move(one));
            continue;
        }
        if (left_out.empty()) first_fault = fault;
        left_out.push_back(one.name);
    }
    if (cases.empty())
        throw InputError(fmt::format("no point of the contour can be run with {}. {}", options.config, first_fault));
    if (!left_out.empty())
        std::fprintf(stderr, "floes: %s cannot be run and %s left out: %s. The first: %s\n",
                     counted(static_cast<int>(left_out.size()), "point").c_str(), left_out.size() == 1 ? "is" : "are",
                     name_list(left_out).c_str(), first_fault.c_str());
    return fmt::format(
               "# Short-term cases on the environmental contours of {}. Run it, then floes design "
               "--exposure-h {:g}:\n# the largest of a contour's cases is its load (docs/year.md).\n"
               "# Keys that are not here have their defaults.\n\n",
               options.ice, options.exposure_h) +
           study_text(campaign, of, cases);
}

void write_output(const ContourOptions& options, const ContourInputs& inputs, const std::vector<ContourOf>& contours,
                  const std::vector<Section>& sections, const std::string& command) {
    if (options.output.ends_with(".toml"))
        write_page(options.output, study_of(options, inputs, contours));
    else if (options.output.ends_with(".svg"))
        write_page(options.output, figure_file(contour_figure(inputs, contours)));
    else
        write_page(options.output, sections_page("Environmental contours", sections, command));
    std::fprintf(stderr, "floes: %s is written\n", options.output.c_str());
}

void refuse_output(const ContourOptions& options) {
    const std::string& output = options.output;
    if (output.empty()) return;
    if (!output.ends_with(".toml") && !output.ends_with(".svg") && !output.ends_with(".html"))
        throw InputError(fmt::format(
            "{} would be cases, a picture or a page: give a name that ends with .toml, .svg or .html.", output));
    if (output.ends_with(".toml") && options.config.empty())
        throw InputError(fmt::format("{} would have cases of a configuration; say which with --config", output));
}

int tell(const ContourOptions& options, const std::string& program) {
    refuse_output(options);
    ContourRequest request = options.request;
    request.state = options.exposure_h * unit::hour;
    std::ranges::sort(request.per_year, std::ranges::greater{});
    const ContourInputs inputs = read_contour_inputs(read_text(options.ice), options.ice);
    const std::vector<ContourOf> contours = find_contours(inputs, request);
    const std::vector<Section> sections = contour_sections(inputs, request, contours);
    std::fputs(written(sections, options.format).c_str(), stdout);
    if (!options.output.empty())
        write_output(options, inputs, contours, sections,
                     fmt::format("{} contour {} -o {}", program, options.ice, options.output));
    return 0;
}

}  // namespace

void add_contour(CommandLine& line) {
    auto options = std::make_shared<ContourOptions>();
    Verb verb = line.verb("contour", "Environmental contours of two inputs (IFORM), and cases on them to run");
    verb.option("ice", options->ice,
                "A scatter diagram as for design --regimes (.csv, .toml), or TOML with two [[input]] distributions")
        .required();
    verb.option("--per-year", options->request.per_year, "Probabilities of exceedance in a year, comma-separated")
        .comma_separated()
        .within(1e-7, 0.5)
        .shows_default();
    verb.option("--exposure-h", options->exposure_h, "Length of a state, h: as the exposure of floes design")
        .within(1e-3, 1e4)
        .shows_default();
    verb.option("--points", options->request.points, "Points on each contour").within(3, 360).shows_default();
    Option config = verb.option("--config", options->config, "The configuration whose case takes the points' values");
    verb.option("--case", options->case_name, "The case of it, if there are several").needs(config);
    add_overrides(verb, options->overrides).needs(config);
    verb.option("-o,--output", options->output,
                "Write cases to run (.toml, with --config), the picture (.svg) or a page (.html)");
    add_format(verb, options->format);
    verb.footer(
        "The first input has a distribution, the second one that depends on it; a scatter diagram has them fitted.\n"
        "docs/year.md says how, and what a contour leaves open.\n\n"
        "  floes contour scatter.csv\n"
        "  floes contour ice.toml --per-year 0.01 -o contour.svg\n"
        "  floes contour scatter.csv --points 8 --config my.toml -o contour.toml && floes run contour.toml");
    verb.runs([options, &line] { return tell(*options, line.program_name()); });
}

}  // namespace floes
