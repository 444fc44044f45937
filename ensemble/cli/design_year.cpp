#include "cli/design_year.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <functional>

#include "cli/config_file.hpp"
#include "cli/shell_words.hpp"
#include "cli/terminal.hpp"
#include "cli/write_page.hpp"
#include "core/error.hpp"
#include "findings/evidence.hpp"
#include "findings/warnings.hpp"
#include "page/sections_page.hpp"
#include "records/file_calls.hpp"
#include "tables/workbook.hpp"
#include "year/year_section.hpp"

namespace floes {
namespace {

std::string command_of(const YearOptions& options) {
    std::string command = fmt::format("{} design {} --regimes {} --averaging-s {:g} --scale {:g} --peaks {:g}",
                                      typed_program(options.program), options.file, options.regimes,
                                      options.load.averaging, options.load.scale, options.load.share);
    if (options.load.rising) command += " --rising";
    if (options.automatic_window) command += " --window auto";
    return command + " -o " + options.output;
}

void write_sheets(const std::string& output, const std::vector<Section>& sections) {
    std::vector<Sheet> sheets;
    for (const Section& section : sections)
        for (const DataRows& records : section.records)
            sheets.push_back({records.place.substr(records.place.find('/') + 1), records});
    const std::string aside = output + ".tmp";
    write_workbook(aside, sheets);
    rename_into_place(aside, output);
}

void write_output(const YearOptions& options, const std::vector<Section>& sections, const Year& year,
                  const YearRequest& request) {
    if (options.output.ends_with(".xlsx"))
        write_sheets(options.output, sections);
    else if (options.output.ends_with(".svg"))
        write_page(options.output, figure_file(year_figure(year, request)));
    else
        write_page(options.output, sections_page("Loads of a year", sections, command_of(options)));
    std::fprintf(stderr, "floes: %s is written\n", options.output.c_str());
}

}  // namespace

void tell_year(const YearOptions& options) {
    const bool known = options.output.empty() || options.output.ends_with(".html") ||
                       options.output.ends_with(".svg") || options.output.ends_with(".xlsx");
    if (!known)
        throw InputError(
            fmt::format("{} would be a page, a picture or a workbook: give a name that ends with .html, .svg "
                        "or .xlsx.",
                        options.output));
    const bool table = options.regimes.ends_with(".csv");
    const std::string text = read_text(options.regimes);
    const std::vector<Regime> regimes =
        table ? read_regime_table(text, options.regimes) : read_regimes(text, options.regimes);
    YearRequest request{options.load, options.per_year};
    std::ranges::sort(request.per_year, std::ranges::greater{});
    Evidence evidence = read_evidence(CampaignFile(options.file), options.automatic_window);
    const Year year = find_year({options.file, evidence.campaign, evidence.table}, regimes, request);
    std::vector<Section> sections = year_sections(evidence, year, request);
    sections.front().before = warning_lines(warnings_of(evidence.table, evidence.summary)) + sections.front().before;
    if (options.next) sections.push_back(year_next(evidence, year, typed_program(options.program)));
    std::fputs(written(sections, options.format).c_str(), stdout);
    if (options.next && options.format != "table") std::fputs(sections.back().before.c_str(), stderr);
    if (!options.output.empty()) write_output(options, sections, year, request);
}

}  // namespace floes
