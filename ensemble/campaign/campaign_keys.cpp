#include "campaign/campaign_keys.hpp"

#include <algorithm>
#include <limits>
#include <string_view>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "campaign/case_words.hpp"
#include "core/units.hpp"
#include "member/design_of.hpp"
#include "member/quantity.hpp"
#include "scenario/keys.hpp"

namespace floes {

namespace {

/// Of what is asked of the cases one by one.
std::vector<const Case*> named_cases(const Campaign& campaign) {
    std::vector<const Case*> named;
    for (const Case& one : campaign.cases)
        if (campaign.stop.case_name == "all" || campaign.stop.case_name == one.name) named.push_back(&one);
    return named;
}

/// Of a design load: why the case does not measure it.
std::optional<std::string> averaging_fault(const StopRule& stop, const Case& one) {
    const std::vector<double> times = one.scenario.averaging_times();
    if (std::ranges::find(times, stop.averaging) != times.end()) return {};
    const double segment = one.scenario.analysis.window / one.scenario.analysis.segments;
    if (stop.averaging > segment)
        return fmt::format(
            "stop.averaging_s = {:g} is longer than a segment of case {}, {:.6g} s (analysis.window_s, "
            "analysis.segments), so nothing can be averaged over it",
            stop.averaging, one.name, segment);
    return fmt::format(
        "stop.of = \"{}\" wants peaks of the load averaged over stop.averaging_s = {:g} s, which case {} does not "
        "take; {}",
        stop.of, stop.averaging, one.name,
        times.empty() ? std::string{"it averages over no time (analysis.averaging_s)"}
                      : fmt::format("its times are {} s (analysis.averaging_s)", fmt::join(times, ", ")));
}

/// Of another design value: why a case that has it would never tell it.
std::optional<std::string> window_fault(const StopRule& stop, const DesignOf& of, const Case& one) {
    const double period = period_of(one.scenario, of);
    if (period * fewest_periods <= one.scenario.analysis.window) return {};
    return fmt::format(
        "stop.of = \"{}\" would never be known: the window of case {} is shorter than three natural periods of {:.4g} "
        "s; take analysis.window_s = {:.4g} or more",
        stop.of, one.name, period, fewest_periods * period);
}

std::optional<std::string> design_fault(const Campaign& campaign, const DesignOf& of) {
    constexpr double lowest_quantile = 0.001;
    const StopRule& stop = campaign.stop;
    if (stop.contrast != "none")
        return fmt::format(
            "stop.of = \"{}\" has no paired difference, and stop.contrast = \"{}\" asks for one; write "
            "stop.contrast = \"none\" and name a case, or let stop.of be a quantity of members",
            stop.of, stop.contrast);
    if (stop.quantile > 0 && stop.quantile < lowest_quantile)
        return fmt::format(
            "stop.quantile = {:g} is below {:g}; it is the probability that the {} is not exceeded, 0.9 say, or 0 "
            "for the expected largest",
            stop.quantile, lowest_quantile, of.noun);
    bool any = of.value == nullptr;
    for (const Case* one : named_cases(campaign)) {
        if (!of.is_of(one->scenario)) continue;  // "all": that have it
        any = true;
        if (auto fault = of.value == nullptr ? averaging_fault(stop, *one) : window_fault(stop, of, *one)) return fault;
    }
    if (any) return {};
    return fmt::format(
        "stop.of = \"{}\" is the {}, which {}: it is of structures that give way (moorings.mass_t) in {}{}; "
        "write \"{}load\", or name another case in stop.case",
        stop.of, of.largest, stop.case_name == "all" ? "no case has" : fmt::format("case {} has not", stop.case_name),
        of.motion_words(), of.has == nullptr ? "" : " on lines with a break load", design_prefix);
}

/// "mean_load", "design_load" and all others that a rule may be of.
std::vector<std::string> stoppable() {
    std::vector<std::string> known;
    for (const Quantity& one : quantities)
        if (one.stops) known.emplace_back(one.key.view());
    for (const DesignOf& one : design_ofs)
        if (!one.part) known.push_back(fmt::format("{}{}", design_prefix, one.word));
    return known;
}

}  // namespace

std::optional<std::string> stop_quantity_fault(const Campaign& campaign) {
    if (const DesignOf* of = campaign.stop.design_of()) return design_fault(campaign, *of);
    const std::string given = fmt::format("stop.of = \"{}\"", campaign.stop.of);
    const std::optional<Quantity> quantity = any_quantity(campaign.stop.of);
    if (!quantity || !quantity->stops)
        return fmt::format("{} is not allowed; use {}, or one that is averaged, such as \"mean_maximum_0.5s\"", given,
                           fmt::join(stoppable(), ", "));
    for (const Case* one : named_cases(campaign))
        if (quantity->of_moored && !one->scenario.moorings.give_way())
            return fmt::format(
                "{} is of structures that give way (moorings.mass_t), and case {} does not; name another case in "
                "stop.case",
                given, one->name);
    if (quantity->averaging == 0) return {};
    for (const Case& one : campaign.cases) {
        const std::vector<double> times = one.scenario.averaging_times();
        if (std::ranges::find(times, quantity->averaging) == times.end())
            return fmt::format(
                "{} is of a time that case {} does not average over; its times are {} s "
                "(analysis.averaging_s)",
                given, one.name, fmt::join(times, ", "));
    }
    return {};
}

namespace {

constexpr std::pair<std::string_view, std::string_view> shorthands[]{
    {"cfm", "joint.cfm"}, {"elastic_modulus_MPa", "ice.elastic_modulus_MPa"}};

std::string about_stop_of() {
    return fmt::format(
        "What has to be precise, one of {}; sd_load, maximum_load and mean_maximum also averaged over a time of "
        "analysis.averaging_s, as \"mean_maximum_0.5s\". Those that begin with \"{}\" are the largest value in "
        "stop.exposure_h, as floes design gives it by both tails; all but the load are of structures that give way. "
        "floes run --until sets this rule in words.",
        fmt::join(stoppable(), ", "), design_prefix);
}

constexpr const char* about_files =
    "# A configuration of floes. Every key has its unit in its name. A key that is omitted has the value below.\n"
    "# A campaign runs each case with each arrangement. floes config --check FILE checks a file without running it.\n"
    "\n";

constexpr const char* about_cases =
    "\n# Cases to compare, over the same arrangements. Each has a name and any keys of the tables above;\n"
    "# elastic_modulus_MPa is short for ice.elastic_modulus_MPa. Without any [[case]] there is one case, named from "
    "its\n"
    "# elastic modulus.\n"
    "#\n"
    "# [[case]]\n"
    "# name = \"open\"\n"
    "# elastic_modulus_MPa = 30.0\n"
    "# field.far_end = \"open\"\n"
    "\n# Axes of a design, each along a key that a case takes: values for a grid or a list, from and to for\n"
    "# latin_hypercube and sobol; scale is \"linear\" or \"log\".\n"
    "#\n"
    "# [[design.axis]]\n"
    "# key = \"ice.thickness_m\"\n"
    "# from = 0.02\n"
    "# to = 0.04\n"
    "# scale = \"linear\"\n";

}  // namespace

Keys describe(CampaignHead& head) {
    return {text_key("campaign.name", head.name, "the file's name",
                     "Name of the campaign; empty: the configuration file's name."),
            {"campaign.seed",
             IntegerField{[&head] { return static_cast<std::int64_t>(head.seed); },
                          [&head](std::int64_t value) { head.seed = static_cast<std::uint64_t>(value); }, 0,
                          std::numeric_limits<std::int64_t>::max()},
             "any number will do", "Seed of all random numbers. Another seed gives another set of arrangements."},
            integer_key("campaign.arrangements", head.arrangements, 1, most_members, "a quick look",
                        "Number of random arrangements; every case is run with each of them. A larger number only adds "
                        "members: finished members stay valid."),
            switch_key(common_path, head.common_arrangements, "smaller uncertainty of differences",
                       "true: cases whose fields have the same geometry start from the same floes (common random "
                       "numbers), and only such cases are compared in pairs. false: each case draws its own "
                       "arrangements, seeded by its name, and nothing is paired.")};
}

Keys describe(StopRule& stop) {
    const std::string_view source = "Hoad, Robinson and Davies 2010";
    static const std::string stoppable = about_stop_of();
    return {number_key("stop.half_width_percent", stop.half_width, unit::percent, at_least(0).below(100), "off",
                       "The campaign ends when the half-width of the 95 % confidence interval of the mean over "
                       "arrangements is at most this percentage of the mean (of a design load: the longer side of its "
                       "interval, of the load); campaign.arrangements is then the maximum. 0: all arrangements are "
                       "run. Only arrangements in index order count, whatever finishes first."),
            text_key("stop.of", stop.of, "the first of Table 3", stoppable),
            text_key("stop.case", stop.case_name, "every case",
                     "Case to which the rule applies: \"all\", \"none\", or the name of one."),
            text_key("stop.contrast", stop.contrast, "none",
                     "Paired difference to which the rule applies, in percent of the case that is subtracted: "
                     "\"none\", \"all\", or two cases as in \"E200 - E60\"."),
            integer_key("stop.minimum", stop.minimum, 0, 1000000, "trials",
                        "Minimum number of arrangements before the rule is applied: with fewer, the estimate of the "
                        "scatter is itself uncertain. 0: at least 20, and so many that a kind of member in a share of "
                        "half_width_percent of all is among them with 95 % (59 for 5 %): such members with twice the "
                        "load move the mean by that much. Of a design value: at least 59."),
            integer_key("stop.look_ahead", stop.look_ahead, 0, 1000000, source,
                        "Number of further arrangements for which the rule must stay satisfied, so that the campaign "
                        "does not stop by chance."),
            integer_key("stop.batch", stop.batch, 1, 1000000, "a few per core",
                        "Number of arrangements that are handed out together, longest members first. A small batch "
                        "wastes fewer members beyond the stop; a large one leaves fewer cores idle. A design value is "
                        "looked at when a batch ends."),
            number_key("stop.exposure_h", stop.exposure, unit::hour, at_least(1e-3).at_most(1e6), "floes design",
                       "For design values: the time whose largest value it is, at the campaign's scale (that at full "
                       "scale over the square root of the scale)."),
            number_key("stop.averaging_s", stop.averaging, unit::one, above(0), "floes design",
                       "For of = \"design_load\": what the load is averaged over, one of analysis.averaging_s."),
            number_key("stop.quantile", stop.quantile, unit::one, at_least(0).at_most(0.99999), "floes design",
                       "For design values: the probability that the value is not exceeded in the exposure, 0.001 or "
                       "more. 0: the expected largest.")};
}

Key method_key(Design& design) {
    constexpr std::size_t sobol_indices = 5;
    WordField method{{"none", "grid", "list", "latin_hypercube", "sobol", "sobol_indices"},
                     [&design] { return design.indices ? sobol_indices : static_cast<std::size_t>(design.method); },
                     [&design](std::size_t word) {
                         design.indices = word == sobol_indices;
                         design.method = design.indices ? DesignMethod::sobol : static_cast<DesignMethod>(word);
                     }};
    return instead_of(
        {switch_key("design.indices", design.indices, "", "")},
        {"design.method", std::move(method), "off",
         "How the points are chosen at which every case is run: grid is all combinations of the axes' values, list "
         "takes their values side by side, latin_hypercube and sobol place design.points points between the ends of "
         "the axes. sobol_indices: (axes + 2) points for each of design.points, from which first-order and total Sobol "
         "indices are computed (Saltelli et al. 2010)."});
}

Keys describe(Design& design) {
    return {method_key(design),
            integer_key("design.points", design.points, 0, static_cast<int>(most_cases), "none",
                        "Points of latin_hypercube and sobol; a power of 2 suits sobol best."),
            text_key("design.points_file", design.points_file, "none",
                     "Points that another program chose: a CSV file, relative to the configuration file, whose first "
                     "line names keys of a scenario and each other line a point. Only with design.method = \"list\", "
                     "in place of [[design.axis]], as which the points are stored.")};
}

Keys describe(RunRules& rules) {
    return {word_key("run.isolation", rules.isolation, {"none", "process"}, "none is faster for short members",
                     "Where a member is computed. none: in the process of its rank. process: in an isolated process, "
                     "so that a crash, a hang or excessive memory does not affect other members."),
            number_key("run.member_deadline_s", rules.member_deadline, 1, at_least(0), "many times a long member",
                       "Wall time after which an attempt at a member is ended as failed; 0: no limit."),
            number_key("run.member_memory_MiB", rules.member_memory, unit::mebibyte, at_least(0),
                       "many times a large member", "Memory limit of a member in an isolated process; 0: no limit."),
            switch_key("run.nominal_modulus", rules.nominal_modulus, "E is the ice's",
                       "With joint.model = \"cfm\", where a case states both E and joint.cfm: true takes E for a name, "
                       "as in the paper, and does not compare them."),
            text_key("run.base_case", rules.base_case, "none",
                     "The case of which all others are variations, as floes vary writes them: differences are formed "
                     "with this one alone, and summaries say what the variations do together. Empty: every case is "
                     "compared with every other."),
            integer_key("run.attempts", rules.attempts, 1, 100, "one retry",
                        "Number of attempts at a failing member before it is set aside as failed.")};
}

Keys describe(Case& one) {
    Keys keys;
    keys.reserve(100);
    keys.push_back(text_key("name", one.name, "", "Name of the case."));
    keys.push_back(text_key("design.base", one.base, "", "Case that a point of the design was added to."));
    keys.push_back(integer_key("design.point", one.point, 0, static_cast<int>(most_cases), "", "That point, from 0."));
    for (Key& key : describe(one.scenario)) {
        for (const auto& [shorthand, full] : shorthands) {
            if (full != key.path) continue;
            keys.push_back(key);
            keys.back().path = shorthand;
        }
        keys.push_back(std::move(key));
    }
    return keys;
}

std::string full_path(const std::string& path) {
    for (const auto& [shorthand, full] : shorthands)
        if (path == shorthand) return std::string(full);
    return path;
}

TableTitles titles() {
    TableTitles all = scenario_titles();
    all["run"] = "How members are run. These keys do not change any result, so --resume accepts other values.";
    all["campaign"] = "The simulations: each case is run with each arrangement.";
    all["design"] =
        "A design: each [[case]] is run at every point of the design, whose axes are [[design.axis]] blocks.";
    all["stop"] = "The stop rule: ends the campaign when its precision is sufficient.";
    return all;
}

std::string default_configuration() {
    return about_files + write_tables(CampaignTables().keys, titles(), Comments::all) + about_cases;
}

std::string reference_markdown() {
    return reference_markdown(CampaignTables().keys, titles());
}

}  // namespace floes
