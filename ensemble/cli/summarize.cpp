// floes summarize: the findings of a campaign file as a table, JSON, CSV or the sheets of a workbook, of incomplete
// campaigns too.

#include <algorithm>
#include <array>
#include <ranges>
#include <string_view>
#include <utility>

#include "cli/commands.hpp"
#include "findings/catalogue.hpp"
#include "findings/evidence.hpp"
#include "findings/overview.hpp"
#include "store/file_calls.hpp"
#include "store/session.hpp"
#include "tables/workbook.hpp"

namespace floes {

namespace {

/// What a sheet is called: the points of a design are its sheet "design", and design loads say that they are loads.
std::string sheet_name(std::string_view part) {
    if (part == "points") return "design";
    return part == "design" ? "design loads" : std::string(part);
}

/// Parts in the order of their sheets; others follow.
constexpr auto sheet_order = std::to_array<std::string_view>(
    {"cases", "answer", "members", "pairs", "points", "long", "design", "sensitivity", "extremes", "exceedance",
     "fatigue", "moored", "lines", "steady", "energy", "hull", "model", "control", "pieces"});

struct SummarizeOptions {
    std::vector<std::string> files;
    std::string format = "table";
    std::string output;
    bool long_lines = false;
    std::string reference;
    std::vector<std::string> parts;
    double resolve_percent = 10;
    std::string window = "given";
    bool full = false;
    MooringOptions mooring;
    double scale = 1;
};

/// What is shown unless parts are named: one screen as a table, with --full and as JSON the parts suited to the
/// campaign, the cases as CSV, and in a workbook these, members, pairs, the points of a design and hulls that give way.
bool is_wanted(const Finding& finding, const SummarizeOptions& options, const Campaign& campaign) {
    if (!options.parts.empty()) return std::ranges::find(options.parts, finding.name) != options.parts.end();
    if (options.format == "table" && !options.full) return finding.name == overview_part;
    if (options.format == "csv") return finding.name == findings().front().name;
    const auto holds = [&](When when) { return when != nullptr && when(campaign); };
    if (options.format == "xlsx") return holds(finding.unasked_in_workbook);
    return holds(finding.unasked) || (options.format == "json" && holds(finding.unasked_in_json));
}

/// The overview of the screen.
FrontSheet front_sheet(Evidence& evidence) {
    Section overview = overview_section(evidence);
    FrontSheet front{.name = "overview", .above = filled_lines(overview.before), .table = {}, .below = overview.notes};
    if (!overview.results.empty()) front.table = std::move(overview.results.front());
    for (std::string& line : filled_lines(overview.after)) front.below.push_back(std::move(line));
    return front;
}

/// The first one says what the others hold.
std::vector<Sheet> workbook_sheets(const SummarizeOptions& options, Evidence& evidence) {
    using Line = std::pair<std::string, std::string>;
    std::vector<Line> contents{{"campaign", evidence.sample.title}, {"made by", "floes " + floes_version()}};
    std::vector<Sheet> sheets;
    std::vector<Finding> wanted;
    for (const Finding& finding : findings())
        if (!finding.name.empty() && is_wanted(finding, options, evidence.campaign)) wanted.push_back(finding);
    std::ranges::stable_sort(wanted, {}, [](const Finding& one) { return std::ranges::find(sheet_order, one.name); });
    for (const Finding& finding : wanted) {
        std::size_t of_this = 0;
        for (Section& section : finding.sections(evidence))
            for (DataRows& records : records_of(section)) {
                if (!records.in_csv) continue;
                const std::string name = sheet_name(finding.name);
                sheets.push_back({++of_this == 1 ? name : fmt::format("{} {}", name, of_this), std::move(records)});
                contents.emplace_back(sheets.back().name, of_this == 1 ? finding.holds : "");
            }
    }
    contents.emplace_back("units", "SI: N, m, s, Pa; shares are not in percent");
    sheets.insert(sheets.begin(),
                  {"contents", data_rows(list("", "sheet holds", contents, [](const Line& one) -> std::vector<Datum> {
                       return {one.first, one.second};
                   }))});
    return sheets;
}

std::vector<Section> find(const SummarizeOptions& options, Evidence& evidence) {
    std::vector<Section> sections;
    for (const Finding& finding : findings()) {
        const bool wanted = is_wanted(finding, options, evidence.campaign);
        if (wanted && finding.for_csv_alone && options.format != "csv")
            throw InputError(
                fmt::format("--parts {0} has lines for each member and needs --format csv, or xlsx.", finding.name));
        const bool always = options.format == "json" && finding.name == findings().front().name;
        if (!wanted && !always) continue;
        for (Section& section : finding.sections(evidence)) {
            if (wanted && options.format != "table" && !section.missing.empty())
                std::fputs(fmt::format("floes: {}", section.missing).c_str(), stderr);
            sections.push_back(std::move(section));
        }
    }
    return sections;
}

void write(const SummarizeOptions& options, Evidence& evidence, const std::string& program) {
    if (options.format != "xlsx") {
        std::vector<Section> sections = find(options, evidence);
        if (options.format == "table" && !options.full && options.parts.empty() && options.files.size() == 1)
            sections.push_back(next_commands(evidence, program));
        const std::string text = written(sections, options.format, evidence.units);
        if (options.output.empty()) {
            std::fputs(text.c_str(), stdout);
        } else {
            write_page(options.output, text);
        }
        return;
    }
    const std::string aside = options.output + ".tmp";
    const FrontSheet front = front_sheet(evidence);
    write_workbook(aside, workbook_sheets(options, evidence), evidence.units, &front);
    rename_into_place(aside, options.output);
}

int answer(SummarizeOptions options, const std::string& program) {
    if (options.format == "xlsx" && options.output.empty())
        throw InputError("A workbook is a file: give its name, which ends with .xlsx, with -o.");
    if (!options.output.empty()) {
        std::string by_ending = std::filesystem::path(options.output).extension().string();
        if (by_ending.empty())
            throw InputError(fmt::format("{} is an ending without a name: give the file a name.", options.output));
        by_ending.erase(0, 1);
        if (by_ending == "txt") by_ending = "table";
        if (options.format != "table" && options.format != by_ending)
            throw InputError(fmt::format("{} would hold --format {}, which its name denies; give another name.",
                                         options.output, options.format));
        options.format = by_ending;
    }
    if (options.long_lines) options.parts = {"long"};
    const std::optional<Oscillator> hull = options.mooring.hull();
    if (hull && options.parts.empty()) options.parts = {"moored"};
    if (options.scale != 1 && !hull && std::ranges::find(options.parts, "hull") == options.parts.end())
        throw InputError(
            "--scale is for pressures on parts (--parts hull) and for a moored hull (--mooring-kN-m); other findings "
            "are at the scale of the campaign.");
    const GivenCampaign given(options.files);
    Evidence evidence = read_evidence(CampaignFile(given.path()), options.window == "auto", options.reference);
    evidence.scale = options.scale;
    if (hull) evidence.moored = MooredRequest{*hull, options.scale};
    evidence.resolve = options.resolve_percent * unit::percent;
    write(options, evidence, program);
    if (!options.output.empty()) std::printf("%s\n", options.output.c_str());
    return 0;
}

std::vector<std::string> part_names() {
    std::vector<std::string> names;
    for (const Finding& finding : findings())
        if (!finding.name.empty()) names.emplace_back(finding.name);
    return names;
}

}  // namespace

void add_summarize(CommandLine& line) {
    auto options = std::make_shared<SummarizeOptions>();
    Verb verb = line.verb("summarize", "Statistics of a campaign: one screen, or all of them");
    verb.option("campaign", options->files, "The campaign file (CAMPAIGN.h5), or the parts of one").required();
    verb.flag("--full", options->full,
              "All statistics: cases with every interval, pairs, extremes; of a design its axes");
    verb.option("--format", options->format,
                "table, json, csv, or xlsx: a workbook with sheets for cases, members, pairs and the design, with -o")
        .one_of({"table", "json", "csv", "xlsx"})
        .shows_default();
    verb.option("-o,--output", options->output,
                "Write a file instead, by its ending: .txt a table, .csv, .json, or .xlsx, a workbook")
        .file_ending({".txt", ".csv", ".json", ".xlsx"});
    verb.option("--reference", options->reference, "Reference case: the others are compared with it, in percent");
    Option parts = verb.option(
        "--parts", options->parts,
        "Parts to show, comma-separated: answer is the report's first page, points and sensitivity are of a design, "
        "model of floes vary; members and long are for CSV and xlsx only");
    parts.comma_separated().one_of(part_names());
    verb.flag("--long", options->long_lines,
              "With --format csv: a line for each value of each simulation: case, arrangement, quantity, unit, value")
        .excludes(parts);
    verb.option("--resolve", options->resolve_percent,
                "Report the number of arrangements needed to resolve this difference of a pair, in percent of the "
                "first case")
        .positive()
        .shows_default();
    add_mooring(verb, options->mooring);
    verb.option("--scale", options->scale,
                "Of the moored hull and of pressures on parts: length at full scale over length in the campaign "
                "(Froude)")
        .within(1.0, 1000.0)
        .shows_default();
    add_window(verb, options->window);
    verb.runs([options, &line] { return answer(*options, line.typed_program()); });
}

}  // namespace floes
