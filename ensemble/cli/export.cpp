// floes export: the load of members as files that other programs read, or a member as an FMU that they step.

#include <algorithm>

#include "campaign_file/read.hpp"
#include "cli/commands.hpp"
#include "cli/export_fmu.hpp"
#include "inference/order_quantile.hpp"
#include "load_files/read_loads.hpp"
#include "replay/replay_member.hpp"

namespace floes {

namespace {

struct ExportOptions {
    std::string file;
    std::string format;
    std::string output;
    std::vector<int> numbers;
    MemberChoice member;
    bool all = false;
    std::optional<double> quantile;
    std::string of;                   ///< empty: the load of a step
    std::optional<double> averaging;  ///< s; none: 1
    std::string axes = "earth";
    LoadRequest request;
    FmuOptions fmu;

    const LoadFormat& written() const { return *std::ranges::find(load_formats(), format, &LoadFormat::word); }
    /// What --worst and --quantile compare.
    Asked asked() const {
        if (of.empty() && !quantile) return {};
        return {of.empty() ? AskedOf::load : *asked_of(of), averaging.value_or(1)};
    }
};

struct ChosenMember {
    int number = 0;
    std::string why = {};  ///< a sentence; empty: it was named
};

/// Numbers of the done members that case and arrangement leave, case by case.
std::vector<std::vector<int>> done_members(const CampaignTable& table, const MemberChoice& choice) {
    std::vector<std::vector<int>> found(table.cases.size());
    for (std::size_t k = 0; k < table.members.size(); ++k)
        if (choice.leaves(table, static_cast<int>(k)))
            found[static_cast<std::size_t>(table.members[k].case_index)].push_back(static_cast<int>(k));
    return found;
}

/// Where the quantile of all members that could be drawn lies.
std::string interval_words(const OrderQuantile& found, std::string_view unit) {
    const auto end = [&](double value, int rank) { return fmt::format("{:.4g} {} (rank {})", value, unit, rank); };
    const bool below = found.low_rank > 0;
    const bool above = found.high_rank <= found.count;
    if (below && above)
        return fmt::format("That quantile lies between {} and {} (95 %).", end(found.low, found.low_rank),
                           end(found.high, found.high_rank));
    if (below)
        return fmt::format("That quantile lies above {} (97.5 %); so few members do not bound it from above.",
                           end(found.low, found.low_rank));
    if (above)
        return fmt::format("That quantile lies below {} (97.5 %); so few members do not bound it from below.",
                           end(found.high, found.high_rank));
    return "So few members do not bound that quantile.";
}

std::string quantile_words(const OrderQuantile& found, double quantile, const Asked& asked, const std::string& name) {
    return fmt::format(
        "Chosen: of {} of case {}, its largest {} {}, {:.4g} {}, has rank {} from the least and stands for "
        "the quantile {:g} of such members' largest. {}",
        counted(found.count, "member"), name, asked.words(), asked.within(), found.value, asked.unit(), found.rank,
        quantile, interval_words(found, asked.unit()));
}

/// One of each case, which are not mixed.
std::vector<ChosenMember> at_quantile(const CampaignTable& table, const ExportOptions& options,
                                      const std::vector<double>& values) {
    std::vector<ChosenMember> chosen;
    const std::vector<std::vector<int>> done = done_members(table, options.member);
    for (std::size_t of_case = 0; of_case < done.size(); ++of_case) {
        std::vector<double> own;
        for (const int number : done[of_case]) own.push_back(values[static_cast<std::size_t>(number)]);
        if (std::ranges::all_of(own, [](double value) { return std::isnan(value); })) continue;
        const OrderQuantile found = order_quantile(own, *options.quantile);
        chosen.push_back({done[of_case][found.place],
                          quantile_words(found, *options.quantile, options.asked(), table.cases[of_case].name)});
    }
    return chosen;
}

std::vector<ChosenMember> chosen_members(const CampaignFile& file, const CampaignTable& table,
                                         const ExportOptions& options) {
    std::vector<ChosenMember> chosen;
    for (const int number : options.numbers) chosen.push_back({number});
    if (!chosen.empty()) return chosen;
    const Asked asked = options.asked();
    const bool compares = options.member.worst || options.quantile;
    const std::vector<double> values =
        compares ? largest_values(file, table, asked, options.member.case_name) : std::vector<double>{};
    MemberChoice one = options.member;
    if (options.all || options.quantile) one.worst = true;  // only that case and arrangement are there
    if (!options.all) {
        const int number = chosen_member(table, one, values, asked);
        if (options.quantile) return at_quantile(table, options, values);
        if (!options.member.worst) return {{number}};
        const std::string& name = options.member.case_name;
        const std::string among = name.empty() ? "the campaign" : "case " + name;
        return {{number, fmt::format("Chosen: of {} it has the largest {} {}, {:.4g} {}.", among, asked.words(),
                                     asked.within(), values[static_cast<std::size_t>(number)], asked.unit())}};
    }
    const std::string any = one.case_name.empty() ? table.cases.front().name : one.case_name;
    chosen_member(table, {.case_name = any, .arrangement = one.arrangement.value_or(0)},
                  {});  // refuses what there is not
    for (const std::vector<int>& of_case : done_members(table, options.member))
        for (const int number : of_case) chosen.push_back({number});
    if (chosen.empty()) throw InputError("None of these members is done, so none has a load yet.");
    return chosen;
}

/// "loads.csv", and of several members "loads_12.csv".
std::string path_of(const std::string& output, int member, bool several) {
    if (!several) return output;
    const std::filesystem::path path(output);
    return (path.parent_path() / fmt::format("{}_{}{}", path.stem().string(), member, path.extension().string()))
        .string();
}

void expect_sense(const ExportOptions& options) {
    if (options.format.empty() || options.output.empty())
        throw InputError(
            "Of a campaign file, --for says which program reads the load and -o names the file; of a configuration, "
            "--fmu names the FMU.");
    const LoadFormat& format = options.written();
    if (std::ranges::none_of(format.endings, [&](std::string_view end) { return options.output.ends_with(end); }))
        throw InputError(fmt::format("{} would be a file for {}: give a name that ends with {}.", options.output,
                                     format.word, fmt::join(format.endings, " or ")));
    if (options.axes == "hull" && !format.turns)
        throw InputError(fmt::format("The program of --for {} knows loads in the earth's axes only: leave --axes out.",
                                     format.word));
    if (options.axes == "hull" && options.request.tow_towards != 0)
        throw InputError("--tow-towards turns the earth's axes; loads in the hull's own axes turn with it: give one.");
    if (!options.of.empty() && !options.member.worst && !options.quantile)
        throw InputError(fmt::format("--of {} says what --worst or --quantile compare; give one of them.", options.of));
    const int ways = static_cast<int>(!options.numbers.empty()) + static_cast<int>(options.all) +
                     static_cast<int>(options.member.worst) + static_cast<int>(options.quantile.has_value());
    if (ways > 1) throw InputError("Give one of --member, --worst, --quantile and --all: each chooses members.");
    if (!options.numbers.empty() && (!options.member.case_name.empty() || options.member.arrangement))
        throw InputError("--member names members by number; leave --case and --arrangement out.");
    if (options.averaging && options.of.empty() && !options.quantile)
        throw InputError(
            "--averaging-s is of what --of or --quantile compare; without them --worst takes the load of a step.");
    if (!options.fmu.overrides.empty() || !options.fmu.motion.empty())
        throw InputError("--set and --motion are of an FMU (--fmu); a campaign file has its members.");
}

int make_fmu(const ExportOptions& options) {
    if (!options.format.empty() || !options.output.empty() || !options.numbers.empty() || options.all ||
        options.member.worst || options.quantile)
        throw InputError(
            "--fmu makes an FMU of a configuration: of the options for loads it takes --case and --arrangement alone.");
    const LoadRequest& load = options.request;
    if (load.scale != 1 || load.tow_towards != 0 || load.step || load.from || load.to || options.axes != "earth" ||
        !options.of.empty() || options.averaging)
        throw InputError(
            "An FMU (--fmu) steps at the scale and in the axes of its configuration; --scale, --axes, --tow-towards, "
            "--step, --from, --to, --of and --averaging-s are of loads from a campaign file.");
    FmuOptions fmu = options.fmu;
    fmu.arrangement = options.member.arrangement;
    return write_fmu(fmu, options.file, options.member.case_name);
}

/// Whether the file is there and completed by its reader, as by the place of an OpenFAST load. Throws InputError where
/// it is of another load.
bool is_completed(const WrittenLoad& made) {
    if (made.completed.empty() || !std::filesystem::exists(made.path)) return false;
    const std::string there = read_bytes(made.path);
    if (std::ranges::any_of(made.completed,
                            [&](const std::string& one) { return there.find(one) == std::string::npos; }))
        throw InputError(
            fmt::format("{} is there, and is not of a load in these axes, of this name and for this version; "
                        "move it away, or give another name.",
                        made.path));
    note("{} is there and stays as it is.", made.path);
    return true;
}

int write_loads(const ExportOptions& options) {
    expect_sense(options);
    expect_campaign_file(options.file);
    const CampaignFile file(options.file);
    const CampaignTable table = read_campaign_file(file);
    LoadRequest request = options.request;
    request.axes = options.axes == "hull" ? LoadAxes::hull : LoadAxes::earth;
    const std::vector<ChosenMember> chosen = chosen_members(file, table, options);
    for (const ChosenMember& one : chosen) {
        LoadToWrite load = read_load(file, table, one.number, request);
        load.origin.chosen = one.why;
        if (!one.why.empty()) note("member {}. {}", one.number, one.why);
        for (const WrittenLoad& made :
             options.written().write(load, path_of(options.output, one.number, chosen.size() > 1))) {
            if (!is_completed(made)) write_page(made.path, made.text);
            std::printf("%s\n", made.path.c_str());
        }
    }
    return 0;
}

void add_members(Verb& verb, ExportOptions& options) {
    verb.option("--member", options.numbers, "Members by number, comma-separated").comma_separated().not_negative();
    verb.option("--case", options.member.case_name, "The members of this case ...");
    verb.option("--arrangement", options.member.arrangement, "... and this arrangement").not_negative();
    verb.flag("--worst", options.member.worst, "The member with the largest load, or what --of says");
    verb.option(
            "--quantile", options.quantile,
            "Of each case the member whose largest load stands for this quantile of its members': 0.9 is exceeded by "
            "one window in ten")
        .within(1e-6, 1 - 1e-6);
    verb.flag("--all", options.all, "All done members");
    verb.option("--of", options.of,
                "What --worst and --quantile compare: load or mooring_force, both over --averaging-s; offset; tension, "
                "over "
                "the run; "
                "default: the load, of --worst that of a step")
        .one_of({asked_names.begin(), asked_names.end()});
    verb.option("--averaging-s", options.averaging, "Time that load and mooring force are averaged over, s; default: 1")
        .within(0.0, 1000.0);
}

void add_series(Verb& verb, ExportOptions& options) {
    LoadRequest& request = options.request;
    verb.option("--step", request.step,
                "Each value is the mean over this time, s, which keeps the impulse; default: as stored")
        .positive();
    verb.option("--from", request.from, "t = 0 of the file, s of the run; default: the start");
    verb.option("--to", request.to, "Its end, s of the run; default: the end");
    verb.option("--axes", options.axes, "Of the forces: at rest in the earth, or turning with the hull's yaw")
        .one_of({"earth", "hull"})
        .shows_default();
    verb.option(
            "--tow-towards", request.tow_towards,
            "Direction of the tow in the other program, degrees from its X towards its Y; 180 has the ice come along X")
        .within(-360.0, 360.0)
        .shows_default();
    verb.option("--scale", request.scale,
                "Length there / length in the campaign, by Froude; times of other options are then those there")
        .positive()
        .shows_default();
}

}  // namespace

void add_export(CommandLine& line) {
    auto options = std::make_shared<ExportOptions>();
    Verb verb =
        line.verb("export", "The load of members as files for OpenFAST, SubDyn, OrcaFlex, or as a table; or an FMU");
    verb.option("file", options->file, "The campaign file (CAMPAIGN.h5); for --fmu the configuration").required();
    std::vector<std::string> words;
    std::string help = "What reads it";
    for (const LoadFormat& format : load_formats()) {
        words.emplace_back(format.word);
        help += fmt::format("{} {} ({}), {}", words.size() > 1 ? ";" : ":", format.word,
                            fmt::join(format.endings, ", "), format.words);
    }
    verb.option("--for", options->format, help).one_of(words);
    verb.option("-o,--output", options->output,
                "The file; of several members its name gets their numbers, and what belongs to it stands beside it")
        .writes_file();
    add_members(verb, *options);
    add_series(verb, *options);
    add_fmu_options(verb, options->fmu);
    verb.footer(
        "Each file says which member it is of, axes, signs, point and units. The load is that of the run's own hull:\n"
        "another program's hull cannot move away from it. An FMU is stepped by another program and does. "
        "docs/coupling.md\n"
        "says what each neglects.\n\n"
        "  floes export my.toml --fmu ice.fmu --case E60\n"
        "  floes export my.h5 --worst --for csv -o worst.csv\n"
        "  floes export my.h5 --case E60 --quantile 0.9 --for openfast -o ice.dat --step 0.05\n"
        "  floes export my.h5 --member 3,7 --for subdyn -o ice.csv --tow-towards 180\n"
        "  floes export my.h5 --all --for csv -o ice.csv --from 100 --to 250");
    verb.runs([options] { return options->fmu.file.empty() ? write_loads(*options) : make_fmu(*options); });
}

}  // namespace floes
