#include "findings/sensitivity.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "campaign/identity.hpp"
#include "findings/cases.hpp"
#include "findings/conditions.hpp"
#include "findings/estimates.hpp"
#include "findings/evidence.hpp"
#include "inference/sobol_indices.hpp"
#include "statistics/load_statistics.hpp"

namespace floes {
namespace {

/// Cases of one [[case]] in order of their points.
struct Points {
    std::string base;
    std::vector<std::size_t> cases;
};

std::vector<Points> by_base(const Campaign& campaign) {
    std::vector<Points> all;
    std::map<std::string, std::size_t> known;
    for (std::size_t k = 0; k < campaign.cases.size(); ++k) {
        const std::string& base = campaign.cases[k].base;
        const auto [place, is_new] = known.emplace(base, all.size());
        if (is_new) all.push_back({base, {}});
        all[place->second].cases.push_back(k);
    }
    for (Points& points : all)
        std::ranges::sort(points.cases, {}, [&](std::size_t k) { return campaign.cases[k].point; });
    return all;
}

/// Values of a quantity: a row for each arrangement, a column for each point; NaN where no member is done.
std::vector<std::vector<double>> values_of(const Points& points, const Quantity& quantity, const Sample& sample) {
    const std::size_t cases = sample.cases();
    std::vector<std::vector<double>> values(sample.members() / cases);
    for (std::size_t arrangement = 0; arrangement < values.size(); ++arrangement)
        for (const std::size_t k : points.cases)
            values[arrangement].push_back(sample.value(arrangement * cases + k, quantity));
    return values;
}

bool finite(const std::vector<double>& values) {
    return std::ranges::all_of(values, [](double value) { return std::isfinite(value); });
}

/// Mean of each point over the arrangements in which it is done; NaN if there is none.
std::vector<double> means_of(const std::vector<std::vector<double>>& values, std::size_t points) {
    std::vector<double> means;
    for (std::size_t p = 0; p < points; ++p) {
        std::vector<double> done;
        for (const std::vector<double>& arrangement : values)
            if (std::isfinite(arrangement[p])) done.push_back(arrangement[p]);
        means.push_back(mean_of(done));
    }
    return means;
}

/// Uses the base points whose points all have a mean. Points are in the order of design_points().
SaltelliValues saltelli_values(const std::vector<double>& means, std::size_t axes) {
    SaltelliValues values;
    values.ab.resize(axes);
    const std::size_t each = axes + 2;
    for (std::size_t first = 0; first + each <= means.size(); first += each) {
        const std::vector<double> base(means.begin() + static_cast<std::ptrdiff_t>(first),
                                       means.begin() + static_cast<std::ptrdiff_t>(first + each));
        if (!finite(base)) continue;
        values.a.push_back(base[0]);
        values.b.push_back(base[1]);
        for (std::size_t axis = 0; axis < axes; ++axis) values.ab[axis].push_back(base[2 + axis]);
    }
    return values;
}

double on_scale(double value, AxisScale scale) {
    return scale == AxisScale::log ? std::log(value) : value;
}

std::vector<SensitivityAxis> axes_of(const Campaign& campaign) {
    std::vector<SensitivityAxis> axes;
    for (const DesignAxis& axis : campaign.design.axes) {
        axes.push_back({axis.key, axis.from, axis.to, axis.scale});
        if (campaign.design.has_ranges()) continue;
        std::vector<double> values;
        for (const Case& point : campaign.cases) values.push_back(numeric_value(point, axis.key));
        const auto [least, most] = std::ranges::minmax(values);
        axes.back().from = least;
        axes.back().to = most;
    }
    return axes;
}

/// Coordinates of the cases, -1 at an axis's beginning and 1 at its end.
PointCoordinates coordinates(const Campaign& campaign, const Points& points, const std::vector<SensitivityAxis>& axes) {
    PointCoordinates all;
    for (const std::size_t k : points.cases) {
        std::vector<double>& row = all.emplace_back();
        for (const SensitivityAxis& axis : axes) {
            const double value = on_scale(numeric_value(campaign.cases[k], axis.key), axis.scale);
            const double low = on_scale(axis.from, axis.scale);
            const double high = on_scale(axis.to, axis.scale);
            row.push_back(high > low ? 2 * (value - low) / (high - low) - 1 : 0);
        }
    }
    return all;
}

std::optional<LinearFit> fit_of(const PointCoordinates& points, const std::vector<std::vector<double>>& values,
                                const std::vector<double>& means) {
    std::vector<std::vector<double>> whole;
    std::ranges::copy_if(values, std::back_inserter(whole), finite);
    if (whole.size() >= 2 && can_fit(points)) return fit_repetitions(points, whole);
    PointCoordinates known;
    std::vector<double> known_means;
    for (std::size_t p = 0; p < points.size(); ++p) {
        if (!std::isfinite(means[p])) continue;
        known.push_back(points[p]);
        known_means.push_back(means[p]);
    }
    if (!can_fit(known)) return {};
    return fit_points(known, known_means);
}

std::string word_axis(const Design& design) {
    const auto found = std::ranges::find(design.axes, false, &DesignAxis::numeric);
    return found == design.axes.end() ? "" : found->key;
}

/// Whether the quantity is one of those that are asked for first.
bool in_front(const Quantity& quantity) {
    return quantity.shown >= Shown::in_headlines;
}

bool has_indices(const Sensitivity& found) {
    return std::ranges::any_of(found.rows, [](const SensitivityRow& row) { return row.indices.has_value(); });
}

/// A row for each quantity and axis, under the name of its quantity.
Results sensitivity_results(const Sensitivity& found) {
    ResultColumn first = estimates("first_order", has_indices(found) ? "first order" : "");
    ResultColumn total = estimates("total", has_indices(found) ? "total" : "");
    first.decimals = total.decimals = 2;
    Results results{.place = "sensitivity/rows",
                    .columns = program_columns("base quantity axis from to scale points centre r_squared "
                                               "arrangements_fitted base_points") +
                               std::vector<ResultColumn>{{.words = "from one end to the other"},
                                                         estimates("slope", ""),
                                                         estimates("change", "change", ""),
                                                         first,
                                                         total}};
    const auto interval = [](const Slope& slope) { return Estimate{slope.estimate, slope.low, slope.high}; };
    const auto share = [](const SobolIndex& of) {
        return Datum(Estimate{of.estimate, of.interval.low, of.interval.high});
    };
    for (const SensitivityRow& row : found.rows) {
        const auto whom = in_front(row.quantity) ? Results::For::everybody : Results::For::folded;
        results.add_heading(fmt::format("{}{}{}", row.base, row.base.empty() ? "" : ": ", row.quantity.label) +
                                (row.fit ? fmt::format(" (R² {:.2f})", row.fit->r_squared) : ""),
                            whom, unit_of(row.quantity));
        for (std::size_t k = 0; k < found.axes.size(); ++k) {
            const SensitivityAxis& axis = found.axes[k];
            const std::string_view scale = axis.scale == AxisScale::log ? "log" : "linear";
            const std::string range = key_words(axis.key).with(fmt::format("{:g} to {:g}", axis.from, axis.to));
            std::vector<Datum> cells{row.base,  row.quantity.key.view(), axis.key, axis.from, axis.to, scale,
                                     row.points};
            if (row.fit)
                cells.insert(cells.end(), {row.fit->centre, row.fit->r_squared, row.fit->repetitions});
            else
                cells.insert(cells.end(), 3, Undefined{});
            cells.emplace_back(row.indices ? Datum(row.base_points) : Datum(Absent{}));
            cells.emplace_back("  " + range + (axis.scale == AxisScale::log ? ", log" : ""));
            cells.emplace_back(row.fit ? Datum(interval(row.fit->slopes[k])) : Datum(Undefined{}));
            cells.emplace_back(row.fit ? Datum(row.change(k)) : Datum(Undefined{}));
            cells.emplace_back(row.indices ? share(row.indices->first[k]) : Datum(Absent{}));
            cells.emplace_back(row.indices ? share(row.indices->total[k]) : Datum(Absent{}));
            results.add(std::move(cells), whom);
        }
    }
    return results;
}

/// The meaning of the columns, then the notes, as sentences.
std::vector<std::string> sensitivity_notes(const Sensitivity& found) {
    std::vector<std::string> notes;
    if (!found.rows.empty()) {
        const auto fitted =
            std::ranges::find_if(found.rows, [](const SensitivityRow& row) { return row.fit.has_value(); });
        notes.push_back(
            "Change: of the plane fitted to all points, from one end of the axis to the other. (The slopes of --format "
            "csv and json are over half of it, from its middle to its end.)");
        if (fitted != found.rows.end())
            notes.push_back(fitted->fit->repetitions > 0
                                ? fmt::format("Its interval: Student's t over {} arrangements, each fitted separately.",
                                              fitted->fit->repetitions)
                                : std::string{"Its interval: from the residuals, since no two arrangements have every "
                                              "point."});
        if (has_indices(found))
            notes.push_back(fmt::format(
                "First order: share of the variance that the axis explains alone; total: including interactions. "
                "Intervals: bootstrap over {} base points.",
                found.rows.front().base_points));
    }
    notes.insert(notes.end(), found.notes.begin(), found.notes.end());
    return notes;
}

/// The cases of the largest group that shares arrangements.
std::vector<std::size_t> largest_group(const Campaign& campaign) {
    const std::vector<int> groups = sharing_groups(campaign);
    std::map<int, std::vector<std::size_t>> cases;
    for (std::size_t k = 0; k < groups.size(); ++k) cases[groups[k]].push_back(k);
    const auto largest = std::ranges::max_element(cases, {}, [](const auto& group) { return group.second.size(); });
    return largest == cases.end() ? std::vector<std::size_t>{} : largest->second;
}

/// Members of each case over the arrangements that all of the cases have done, in the same order.
std::vector<Members> common_members(const Sample& sample, const std::vector<std::size_t>& cases) {
    std::map<int, Members> by_arrangement;
    for (const std::size_t k : cases)
        for (const std::size_t member : sample.done(k)) by_arrangement[sample.arrangement_of(member)].push_back(member);
    std::vector<Members> members(cases.size());
    for (const auto& [arrangement, runs] : by_arrangement)
        if (runs.size() == cases.size())
            for (std::size_t k = 0; k < runs.size(); ++k) members[k].push_back(runs[k]);
    return members;
}

/// The variance of a run's value that its window alone would give, if all that differs between runs went on within
/// them; NaN where nothing says it. `effective`: samples, by member.
double variance_of_time(const Sample& sample, const Quantity& asked, std::size_t member,
                        const std::map<std::size_t, double>& effective) {
    if (asked.key == quantity("mean_load").key) {
        const auto samples = effective.find(member);
        return samples == effective.end() ? std::nan("")
                                          : std::pow(sample.value(member, quantity("sd_load")), 2) / samples->second;
    }
    std::span<const double> maxima = sample.along("members/segment_maximum", member);
    if (const auto place = asked.averaging > 0 ? sample.place_of_time(member, asked.averaging) : std::nullopt)
        maxima = sample.along("averaged/segment_maximum", member, *place);
    if (asked.key == quantity("failure_ratio").key || maxima.size() < 2) return std::nan("");
    const double sd = population_sd(maxima, mean_of(maxima));
    return sd * sd / static_cast<double>(maxima.size() - 1);
}

}  // namespace

bool in_detail(const Campaign& campaign) {
    constexpr std::size_t few = 12;
    return !campaign.design.active() || campaign.cases.size() <= few;
}

Estimate SensitivityRow::change(std::size_t axis) const {
    const Slope& slope = fit->slopes[axis];  // over half the axis
    return {2 * slope.estimate, 2 * slope.low, 2 * slope.high,
            fit->repetitions == 0 || fit->repetitions >= fewest_for_interval};
}

Sensitivity find_sensitivity(const Evidence& evidence) {
    Sensitivity found;
    const Campaign& campaign = evidence.campaign;
    const Design& design = campaign.design;
    if (!design.active()) {
        found.notes.push_back("The campaign has no design: its cases lie on no axes.");
        return found;
    }
    if (const std::string key = word_axis(design); !key.empty()) {
        found.notes.push_back(fmt::format(
            "The axis {} is not numeric; indices and planes need numeric axes. Compare its cases in pairs.", key));
        return found;
    }
    found.axes = axes_of(campaign);
    for (const Points& points : by_base(campaign)) {
        const PointCoordinates places = coordinates(campaign, points, found.axes);
        bool fitted = false;
        for (const Quantity& quantity : evidence.summary.quantities) {
            if (!quantity.in_designs) continue;
            const auto values = values_of(points, quantity, evidence.sample);
            const std::vector<double> means = means_of(values, points.cases.size());
            SensitivityRow& row = found.rows.emplace_back(SensitivityRow{quantity, points.base, 0, 0, {}, {}});
            row.points =
                static_cast<int>(std::ranges::count_if(means, [](double mean) { return std::isfinite(mean); }));
            if (design.indices) {
                const SaltelliValues at = saltelli_values(means, found.axes.size());
                row.base_points = static_cast<int>(at.a.size());
                row.indices = sobol_indices(at);
            }
            row.fit = fit_of(places, values, means);
            fitted = row.fit.has_value();
        }
        if (!fitted)
            found.notes.push_back(fmt::format(
                "{}no plane: it needs more points with a result than axes + 1, and no axis that depends on the others.",
                points.base.empty() ? "" : points.base + ": "));
    }
    if (design.indices)
        found.notes.push_back(
            "Indices are computed from means over arrangements. The scatter that remains in these means counts as "
            "interaction and raises the total indices.");
    return found;
}

Section sensitivity_section(const Sensitivity& found) {
    Results notes{.place = "sensitivity/notes", .columns = program_columns("note"), .in_csv = false};
    for (const std::string& note : found.notes) notes.add({note});
    return {.title = "What decides the load",
            .results = {sensitivity_results(found), std::move(notes)},
            .notes = sensitivity_notes(found)};
}

std::string change_sentence(const Sensitivity& found, const SensitivityRow& row, std::size_t axis, const Units& units) {
    const SensitivityAxis& about = found.axes[axis];
    const KeyWords words = key_words(about.key);
    std::string name = words.name;
    if (row.base.empty() && name.front() >= 'a' && name.front() <= 'z') name.front() += 'A' - 'a';
    return fmt::format("{}{} from {:g} to {:g}{} changes the mean load by {}.", row.base.empty() ? "" : row.base + ": ",
                       name, about.from, about.to, words.unit.empty() ? "" : " " + words.unit,
                       change_text(row.change(axis), units));
}

Results find_scatter(const Evidence& evidence, const SteadyReport& steady) {
    ResultColumn share = estimates("arrangement_share", "arrangement", "share");
    share.decimals = 0;
    Results scatter{.place = "scatter",
                    .columns = {{"quantity", "quantity"},
                                {"cases"},
                                {"arrangements"},
                                {.key = "sd_over_mean", .words = "SD / mean", .unit = "share", .decimals = 1},
                                std::move(share),
                                {.key = "time_share", .words = "window", .unit = "share", .decimals = 0}},
                    .in_csv = false};
    const Sample& sample = evidence.sample;
    const std::vector<Members> cases = common_members(sample, largest_group(evidence.campaign));
    if (cases.size() < 2 || cases.front().size() < 3) return scatter;
    std::map<std::size_t, double> effective;
    for (const MemberSteady& member : steady.members)
        effective[static_cast<std::size_t>(member.member)] = member.effective_samples;
    for (const LoadColumn& column : load_columns(evidence.summary)) {
        const Quantity& asked = column.quantity;
        std::vector<std::vector<double>> values;
        double time = 0;
        bool known = true;
        for (const Members& members : cases) {
            std::vector<double>& own = values.emplace_back(sample.values(members, asked));
            const double mean = mean_of(own);
            for (double& value : own) value /= mean;
            for (const std::size_t member : members)
                time += variance_of_time(sample, asked, member, effective) / (mean * mean);
            known = known && finite(own);
        }
        const ArrangementShare found = arrangement_share(known ? values : std::vector<std::vector<double>>{});
        const double runs = static_cast<double>(cases.size() * cases.front().size());
        scatter.add({Named{std::string{asked.key.view()}, std::string{asked.label.view()}}, found.cases,
                     found.arrangements, found.sd, Estimate{found.share, found.interval.low, found.interval.high},
                     time / runs / (found.sd * found.sd)});
    }
    return scatter;
}

Section scatter_section(Results scatter) {
    if (scatter.empty())
        return {.before =
                    "Where scatter comes from: unknown; it takes two cases over the same arrangements, three of them "
                    "done.\n",
                .results = {std::move(scatter)}};
    return {.title = fmt::format("Where the scatter of single runs comes from, {:g} cases x {:g} arrangements",
                                 scatter.number(0, "cases"), scatter.number(0, "arrangements")),
            .results = {std::move(scatter)},
            .after =
                "\nArrangement: share of the variance of single runs that cases over the same arrangement have in "
                "common (intraclass correlation; below 0: by chance). The rest differs between runs of one "
                "arrangement: pairing does not take it away. Window: share that runs of this length would have if all "
                "their differences passed within a run (mean load: variance of a step over the effective samples; "
                "maxima: variance of the segments' over their number); near what the arrangement leaves, longer runs "
                "are worth as much as more of them.\n"};
}

}  // namespace floes
