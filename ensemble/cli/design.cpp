// floes design and contour: design loads, the loads of a year, and environmental contours.

#include <algorithm>
#include <functional>
#include <ranges>

#include "campaign/read.hpp"
#include "campaign/write.hpp"
#include "cli/commands.hpp"
#include "findings/design_load.hpp"
#include "findings/evidence.hpp"
#include "findings/moored.hpp"
#include "keys/key.hpp"
#include "match/contour_section.hpp"
#include "match/year.hpp"
#include "page/section_html.hpp"
#include "store/file_calls.hpp"
#include "tables/workbook.hpp"

namespace floes {

namespace {

/// The likeliest first, each once.
void put_in_order(std::vector<double>& per_year) {
    std::ranges::sort(per_year, std::ranges::greater{});
    const auto again = std::ranges::unique(per_year);
    per_year.erase(again.begin(), again.end());
}

Option add_per_year(Verb& verb, std::vector<double>& per_year) {
    return verb.option("--per-year", per_year, "Probabilities of exceedance in a year, comma-separated")
        .comma_separated()
        .within(1e-7, 0.5)
        .shows_default();
}

/// The sentences of the answer, which are lost among numbers: what they are of, warnings, and what to know.
DataRows about_rows(const std::vector<Section>& sections, const std::string& command) {
    Results lines{.columns = program_columns("about")};
    const auto add = [&](const std::string& text) {
        for (std::string& line : filled_lines(text)) lines.add({std::move(line)});
    };
    for (const Section& section : sections) {
        for (const std::string& text : {section.title, section.before, section.missing, section.after}) add(text);
        for (const std::string& note : section.notes) add(note);
    }
    add("Units are SI: N, m, rad; averaging in s. \"of\" says what a value is of.");
    add("Made by: " + command);
    return data_rows(lines);
}

void write_sheets(const std::string& output, const std::vector<Section>& sections, const std::string& command) {
    std::vector<Sheet> sheets{{"about", about_rows(sections, command)}};
    for (const Section& section : sections)
        for (const DataRows& records : records_of(section))
            sheets.push_back({records.place.substr(records.place.find('/') + 1), records});
    const std::string aside = output + ".tmp";
    write_workbook(aside, sheets);
    rename_into_place(aside, output);
}

/// A file that a verb writes beside its answer, of the kind that the ending of its name says.
struct Output {
    const std::string& file;                    ///< empty: none
    const char* title;                          ///< of a page
    const std::vector<Section>& sections;       ///< of a page (.html, .pdf) or a workbook (.xlsx)
    std::string command;                        ///< that makes it
    Units units = {};                           ///< of a page
    std::function<std::string()> picture = {};  ///< .svg
    std::function<std::string()> cases = {};    ///< .toml
};

/// Throws InputError, before any work, for a file with none of the `endings`. `what`: what it would be.
void expect_ending(const std::string& file, const char* what, const std::vector<std::string>& endings,
                   const char* besides = "") {
    if (file.empty() || std::ranges::any_of(endings, [&](const std::string& one) { return file.ends_with(one); }))
        return;
    throw InputError(fmt::format("{} would be {}: give a name that ends with {} or {}{}.", file, what,
                                 fmt::join(endings.begin(), endings.end() - 1, ", "), endings.back(), besides));
}

void write(const Output& output) {
    if (output.file.empty()) return;
    if (output.file.ends_with(".xlsx"))
        write_sheets(output.file, output.sections, output.command);
    else if (output.file.ends_with(".toml"))
        write_new(output.file, output.cases());
    else
        write_page(output.file, output.file.ends_with(".svg")
                                    ? output.picture()
                                    : sections_page(output.title, output.sections, output.command, output.units));
    note("{} is written", output.file);
}

// floes contour: environmental contours of two inputs, as a table, a picture, or cases to run.

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
        note("{} cannot be run and {} left out: {}. The first: {}", counted(std::ssize(left_out), "point"),
             left_out.size() == 1 ? "is" : "are", name_list(left_out), first_fault);
    return fmt::format(
               "# Short-term cases on the environmental contours of {}. Run it, then floes design "
               "--exposure-h {:g}:\n# the largest of a contour's cases is its load (docs/year.md).\n"
               "# Keys that are not here have their defaults.\n\n",
               options.ice, options.exposure_h) +
           study_text(campaign, of, cases);
}

int tell(const ContourOptions& options, const std::string& program) {
    expect_ending(options.output, "cases, a picture or a page", {".toml", ".svg", ".html"});
    if (options.output.ends_with(".toml") && options.config.empty())
        throw InputError(
            fmt::format("{} would have cases of a configuration; say which with --config", options.output));
    ContourRequest request = options.request;
    request.state = options.exposure_h * unit::hour;
    put_in_order(request.per_year);
    const ContourInputs inputs = read_contour_inputs(read_text(options.ice), options.ice);
    const std::vector<ContourOf> contours = find_contours(inputs, request);
    const std::vector<Section> sections = contour_sections(inputs, request, contours);
    print(sections, options.format);
    write({.file = options.output,
           .title = "Environmental contours",
           .sections = sections,
           .command = fmt::format("{} contour {} --per-year {:g} --exposure-h {:g} --points {} -o {}", program,
                                  shell_word(options.ice), fmt::join(request.per_year, ","), options.exposure_h,
                                  request.points, shell_word(options.output)),
           .picture = [&] { return figure_file(contour_figure(inputs, contours)); },
           .cases = [&] { return study_of(options, inputs, contours); }});
    return 0;
}

}  // namespace

void add_contour(CommandLine& line) {
    auto options = std::make_shared<ContourOptions>();
    Verb verb = line.verb("contour", "Environmental contours of two inputs (IFORM), and cases on them to run");
    verb.option("ice", options->ice,
                "A scatter diagram as for design --regimes (.csv, .toml), or TOML with two [[input]] distributions")
        .required();
    add_per_year(verb, options->request.per_year);
    verb.option("--exposure-h", options->exposure_h, "Length of a state, h: as the exposure of floes design")
        .within(1e-3, 1e4)
        .shows_default();
    verb.option("--points", options->request.points, "Points on each contour").within(3, 360).shows_default();
    Option config = verb.option("--config", options->config, "The configuration whose case takes the points' values");
    verb.option("--case", options->case_name, "The case of it, if there are several").needs(config);
    add_overrides(verb, options->overrides).needs(config);
    verb.option("-o,--output", options->output,
                "Write cases to run (.toml, with --config), the picture (.svg) or a page (.html)")
        .writes_file();
    add_format(verb, options->format);
    verb.footer(
        "The first input has a distribution, the second one that depends on it; a scatter diagram has them fitted.\n"
        "docs/year.md says how, and what a contour leaves open.\n\n"
        "  floes contour scatter.csv\n"
        "  floes contour ice.toml --per-year 0.01 -o contour.svg\n"
        "  floes contour scatter.csv --points 8 --config my.toml -o contour.toml && floes run contour.toml");
    verb.runs([options, &line] { return tell(*options, line.typed_program()); });
}

// floes design: the largest load in an exposure, or the loads of a year, with their uncertainty.

namespace {

struct DesignOptions {
    std::vector<std::string> files;
    double exposure_h = 3;
    DesignLoadRequest request;
    std::string format = "table";
    std::string window = "given";
    std::string of = "load";
    std::string output;
    std::string program;
    MooringOptions mooring;
    std::string regimes;  ///< TOML, or CSV by its name; empty: loads in an exposure
    std::vector<double> per_year{1e-2, 1e-4};
    bool next = false;
    bool averaged = false;  ///< --averaging-s is given

    bool automatic_window() const { return window == "auto"; }
};

struct Answer {
    DesignLoads designs;
    std::vector<Section> sections;
};

/// Design mooring forces instead of loads, and what they come from.
Answer moored(const Evidence& evidence, DesignLoadRequest request, const Oscillator& hull) {
    request.of = design_of_k_x;
    const MooredRequest asked{hull, request.scale, request.averaging};
    const std::vector<MooredCase> found = find_moored(evidence, asked);
    const std::vector<CasePeaks> peaks = moored_peaks(evidence.sample, found);
    DesignLoads designs = find_design_loads(evidence.sample, request, peaks);
    for (CaseDesignLoad& one : designs.of_cases)
        if (!evidence.sample.done(one.case_index).empty())
            one.lacks = {"its members keep no load histories (analysis.history_steps)"};
    for (const MooredCase& one : found) designs.of_cases[one.case_index].lacks = {one.refused};
    std::vector<Section> sections = design_load_sections(evidence.summary, designs);
    sections.push_back(moored_section(evidence.summary, found, asked));
    return {std::move(designs), std::move(sections)};
}

Answer sections_of(const DesignOptions& options, const Evidence& evidence, const DesignLoadRequest& request) {
    if (options.of != "load") {
        DesignLoads designs = find_simulated_designs(evidence, request);
        std::vector<Section> sections = design_load_sections(evidence.summary, designs);
        if (options.of == "mooring_force") sections.front().before = mooring_notes(evidence) + sections.front().before;
        // Those are at the scale of the campaign.
        if (std::optional<Section> moved = moored_runs_section(evidence); moved && request.scale == 1)
            sections.push_back(std::move(*moved));
        return {std::move(designs), std::move(sections)};
    }
    if (const std::optional<Oscillator> hull = options.mooring.hull()) return moored(evidence, request, *hull);
    DesignLoads designs = find_design_loads(evidence.sample, request);
    std::vector<Section> sections = design_load_sections(evidence.summary, designs);
    return {std::move(designs), std::move(sections)};
}

/// The command that repeats the answer. `asked`: what it is of, "--regimes year.toml".
std::string command_of(const DesignOptions& options, const GivenCampaign& given, const std::string& asked) {
    const DesignLoadRequest& load = options.request;
    const std::string averaging = options.of == "load" ? fmt::format(" --averaging-s {:g}", load.averaging) : "";
    return fmt::format("{} design {} {}{} --scale {:g} --peaks {:g}{}{} -o {}", options.program, given.words(), asked,
                       averaging, load.scale, load.share, load.rising ? " --rising" : "",
                       options.automatic_window() ? " --window auto" : "", shell_word(options.output));
}

void add_warnings(const Evidence& evidence, std::vector<Section>& sections) {
    std::string& before = sections.front().before;
    before = warning_lines(warnings_of(evidence.sample, evidence.summary)) + before;
}

int answer(const DesignOptions& options) {
    DesignLoadRequest request = options.request;
    request.exposure = options.exposure_h * unit::hour;
    request.of = *std::ranges::find(design_ofs, options.of, &DesignOf::word);
    if (options.averaged && options.of != "load")
        throw InputError(
            "--averaging-s is of the load, and --of {} is extrapolated as it is in each step; leave it out",
            options.of);
    expect_ending(options.output, "a page or a workbook", {".html", ".pdf", ".xlsx"},
                  "; the curve (.svg) is of a year, with --regimes");
    const GivenCampaign given(options.files);
    const Evidence evidence = read_evidence(CampaignFile(given.path()), options.automatic_window());
    Answer found = sections_of(options, evidence, request);
    add_warnings(evidence, found.sections);
    const Units units = design_units(found.designs, evidence.units);
    print(found.sections, options.format, units);
    const std::string asked =
        fmt::format("--exposure-h {:g} --quantile {:g}{}{}", options.exposure_h, fmt::join(request.quantiles, ","),
                    options.of == "load" ? "" : " --of " + options.of, options.mooring.text());
    write({.file = options.output,
           .title = "Design values",
           .sections = found.sections,
           .command = command_of(options, given, asked),
           .units = units});
    return found.designs.known() ? 0 : 1;
}

std::string picture_of(const DesignOptions& options, const Year& year, const YearRequest& request) {
    if (const std::optional<Figure> figure = year_figure(year, request))
        return figure_file(*figure, year_units(year, request));
    throw InputError(fmt::format("{} is not written: it would have no line, because the tails say no load of a year.",
                                 options.output));
}

/// The loads of a year. Throws InputError as find_year() and read_regimes() do.
int answer_of_year(const DesignOptions& options) {
    if (options.of != "load")
        throw InputError(fmt::format(
            "The loads of a year (--regimes) are of the ice load alone, and --of {0} is not. Leave out --regimes for "
            "the largest {0} in an exposure (--exposure-h), or leave out --of.",
            options.of));
    const GivenCampaign given(options.files);
    expect_ending(options.output, "a page, a picture or a workbook", {".html", ".pdf", ".svg", ".xlsx"});
    const bool table = has_ending(options.regimes, ".csv");
    const std::string text = read_text(options.regimes);
    const std::vector<Regime> regimes =
        table ? read_regime_table(text, options.regimes) : read_regimes(text, options.regimes);
    YearRequest request{options.request, options.per_year};
    put_in_order(request.per_year);
    Evidence evidence = read_evidence(CampaignFile(given.path()), options.automatic_window());
    const Year year = find_year({given.path(), evidence.campaign, evidence.table}, regimes, request);
    std::vector<Section> sections = year_sections(evidence, year, request);
    add_warnings(evidence, sections);
    if (options.next)
        sections.push_back(year_next(evidence, year, options.program, options.files.size() == 1 ? given.words() : ""));
    const Units units = year_units(year, request);
    print(sections, options.format, units);
    if (options.next && options.format != "table") std::fputs(sections.back().before.c_str(), stderr);
    write({.file = options.output,
           .title = "Loads of a year",
           .sections = sections,
           .command = command_of(options, given,
                                 fmt::format("--regimes {} --per-year {:g}", shell_word(options.regimes),
                                             fmt::join(request.per_year, ","))),
           .units = units,
           .picture = [&] { return picture_of(options, year, request); }});
    return says_some_load(year) ? 0 : 1;
}

void add_year(Verb& verb, DesignOptions& year, const Option& exposure, const Option& quantile, const Option& mooring) {
    Option regimes = verb.option(
        "--regimes", year.regimes,
        "The loads of a year instead: TOML file with a [[regime]] for each kind of ice, its hours a year and "
        "its case or place in the design; or a scatter diagram (.csv)");
    regimes.excludes(exposure).excludes(quantile).excludes(mooring);
    add_per_year(verb, year.per_year).needs(regimes);
    verb.flag("--next", year.next, "Of a year: the command that runs what its loads are least certain of")
        .needs(regimes);
}

std::vector<std::string> words_of() {
    std::vector<std::string> words;
    for (const DesignOf& of : design_ofs) words.emplace_back(of.word);
    return words;
}

}  // namespace

void add_design(CommandLine& line) {
    auto options = std::make_shared<DesignOptions>();
    Verb verb = line.verb("design", "Design load: the largest load in an exposure, or in a year, with its uncertainty");
    verb.option("campaign", options->files, "The campaign file (CAMPAIGN.h5), or the parts of one").required();
    Option exposure = add_exposure(verb, options->exposure_h);
    Option quantile = add_quantiles(verb, options->request.quantiles);
    Option averaging = add_averaging(verb, options->request.averaging);
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
                            "What is extrapolated. All but the load are of structures that give way in the simulation: "
                            "mooring_force, the horizontal resultant of springs, lines and turret, and its parts "
                            "along the tow and across it, surge_mooring and sway_mooring; offset, horizontally, of the "
                            "turret, or of the hull's axis without one; surge_offset and sway_offset of the axis; "
                            "heave and angles; line_tension, of the line nearest to its break load, over that");
    of.one_of(words_of()).shows_default().excludes(mooring);
    add_year(verb, *options, exposure, quantile, mooring);
    add_window(verb, options->window);
    verb.option("-o,--output", options->output,
                "Write a page (.html, .pdf) or a workbook (.xlsx) too; of a year also the exceedance curve (.svg)")
        .writes_file();
    add_format(verb, options->format);
    verb.footer(
        "The exposure passes through many arrangements, so the members of a case are pieces of it. Loads of single\n"
        "steps depend on the time step and are no design loads; averaged ones do not (docs/convergence.md).\n"
        "Exit status 1: no case has a design load, or no load of the year is known.\n\n"
        "  floes design table3_physical.h5\n"
        "  floes design table3_physical.h5 --exposure-h 10 --quantile 0.5,0.9,0.99 --averaging-s 2\n"
        "  floes design table3_physical.h5 --scale 36 --averaging-s 6 --exposure-h 3      loads at full scale\n"
        "  floes design full_scale.h5 --mooring-kN-m 2600 --mass-t 42000 --damping-percent 10    of a moored hull\n"
        "  floes design moored_free.h5 --scale 57 --of mooring_force                      of one that gives way\n"
        "  floes design floating.h5 --of pitch -o pitch.html                              how far it pitches\n"
        "  floes design table3_physical.h5 --regimes year.toml                            10^-2 and 10^-4 a year");
    verb.runs([options, averaging, &line] {
        options->program = line.typed_program();
        options->averaged = averaging.given();
        return options->regimes.empty() ? answer(*options) : answer_of_year(*options);
    });
}

}  // namespace floes
