#include "findings/steady.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "core/error.hpp"
#include "core/units.hpp"
#include "inference/interval.hpp"
#include "statistics/load_statistics.hpp"

namespace floes {

std::string steady_text(const std::string& name, const JointTrend& trend, const CaseRow& about) {
    if (trend.steadiness != Steadiness::steady) return "";
    const std::string beyond =
        about.far_end == FarEnd::never ? "Ice comes as long as the run lasts."
        : about.far_end == FarEnd::ice_sheet
            ? "The field ends at an ice sheet, so a longer exposure is taken as one such passage after another."
            : "The field ends in open water, so a longer exposure is taken as one such passage after another.";
    return fmt::format("{}: {}. {}", name, trend_text(trend), beyond);
}

std::string end_text(const CaseRow& about) {
    if (about.far_end == FarEnd::never) return "";
    if (about.far_end == FarEnd::open) return " The field ends in open water; field.far_end = \"never\" has no end.";
    return " The tow comes nearer to the ice sheet at the field's end; field.far_end = \"never\" has no end.";
}

namespace {

double median(std::vector<double> values) {
    values = measured(std::move(values));
    if (values.empty()) return std::nan("");
    std::ranges::sort(values);
    return quantile_of_sorted(values, 0.5);
}

/// Number of history values in a batch of at least correlation_batch steps.
std::size_t batch_of(const Analysis& analysis) {
    const auto stride = static_cast<std::size_t>(analysis.history_stride);
    return (correlation_batch + stride - 1) / stride;
}

/// The histories of a case, of each member in equal parts, and their sum.
struct Histories {
    std::vector<double> sum;
    std::vector<std::vector<double>> parts;
    double step = 0;

    void add(const StoredHistory& history) {
        step = history.step;
        sum.resize(std::max(sum.size(), history.values.size()));
        for (std::size_t i = 0; i < history.values.size(); ++i) sum[i] += history.values[i];
        if (history.values.size() >= steady_batches) parts.push_back(part_means(history.values, steady_batches));
    }

    /// Whether the members' loads are seen to rise or fall together from that part on.
    bool trend_from(std::size_t first) const {
        std::vector<double> changes;
        double mean = 0;
        for (const std::vector<double>& one : parts) {
            const std::span<const double> rest = std::span(one).subspan(first);
            changes.push_back(change_over(rest));
            mean += mean_of(rest) / static_cast<double>(parts.size());
        }
        return steadiness_of(mean_change(changes), mean) >= Steadiness::falls;
    }

    /// MSER's start, or the first part after it from which there is no trend.
    std::optional<double> start() const {
        const auto by_mean = steady_start(sum);  // of the sum as of the mean
        if (!by_mean || parts.empty())
            return by_mean ? std::optional(static_cast<double>(*by_mean) * step) : std::nullopt;
        const double part = static_cast<double>(sum.size()) / static_cast<double>(steady_batches);
        const auto first = static_cast<std::size_t>(std::ceil(static_cast<double>(*by_mean) / part - 1e-9));
        if (!trend_from(first)) return static_cast<double>(*by_mean) * step;
        for (std::size_t k = first + 1; k < steady_batches / 2; ++k)
            if (!trend_from(k)) return static_cast<double>(k) * part * step;
        return {};
    }

    /// The slope of a straight line through the values, times their number.
    static double change_over(std::span<const double> values) {
        const double count = static_cast<double>(values.size()), middle = (count - 1) / 2;
        double product = 0, squares = 0;
        for (std::size_t k = 0; k < values.size(); ++k) {
            const double at = static_cast<double>(k) - middle;
            product += at * values[k];
            squares += at * at;
        }
        return product / squares * count;
    }
};

CaseSteady case_steady(const Sample& sample, std::size_t index, const std::vector<MemberSteady>& members,
                       const Histories& histories) {
    CaseSteady found;
    found.start = histories.start();
    std::vector<double> starts;
    std::vector<double> times;
    std::vector<double> effective;
    for (const MemberSteady& member : members) {
        if (sample.case_of(static_cast<std::size_t>(member.member)) != index) continue;
        if (member.start) starts.push_back(*member.start);
        found.without_start += member.start ? 0 : 1;
        times.push_back(member.decorrelation_time);
        effective.push_back(member.effective_samples);
    }
    if (!starts.empty()) found.median_start = median(starts);
    found.median_decorrelation_time = median(times);
    found.median_effective_samples = median(effective);
    return found;
}

}  // namespace

SteadyReport find_steady(const CampaignFile& file, const Sample& sample) {
    SteadyReport report;
    std::vector<Histories> histories(sample.cases.size());
    for_each_history(file, [&](const StoredHistory& history) {
        const auto number = static_cast<std::size_t>(history.member);
        const std::size_t of_case = sample.case_of(number);
        histories.at(of_case).add(history);
        MemberSteady member{history.member, {}, 0, 0};
        const Analysis& analysis = sample.cases[of_case].analysis;
        if (const auto start = steady_start(history.values)) member.start = static_cast<double>(*start) * history.step;
        std::optional<double> variance;  // of single steps: means over several steps underestimate it
        const double sd = sample.value(number, quantity("sd_load"));
        if (analysis.history_stride > 1) variance = sd * sd;
        const Autocorrelation found =
            autocorrelation(in_window(history, analysis), history.step, batch_of(analysis), variance);
        member.decorrelation_time = found.time;
        member.effective_samples = found.effective_samples;
        report.members.push_back(member);
    });
    for (std::size_t index = 0; index < histories.size(); ++index)
        report.cases.push_back(case_steady(sample, index, report.members, histories[index]));
    return report;
}

CampaignTable with_automatic_window(const CampaignFile& file, CampaignTable table, const SteadyReport& steady) {
    if (steady.members.empty())
        throw InputError("--window auto measures the loads anew, and the file has no load histories to do it from.");
    std::vector<Analysis> windows;
    for (std::size_t index = 0; index < table.cases.size(); ++index) {
        Analysis& analysis = windows.emplace_back(table.cases[index].analysis);
        const double end = analysis.steady_start + analysis.window;
        const double segment = analysis.window / analysis.segments;
        table.cases[index].window = CaseRow::Window::none_steady;
        if (!steady.cases[index].start) continue;
        // The tolerance keeps a segment that would be lost by rounding.
        const int segments = static_cast<int>(std::floor((end - *steady.cases[index].start) / segment + 1e-9));
        if (segments < 1) continue;
        analysis.steady_start = end - segments * segment;
        analysis.window = segments * segment;
        analysis.segments = segments;
        table.cases[index].window = CaseRow::Window::steady;
    }
    return measured_anew(file, std::move(table), windows);
}

const SteadyReport& steady_of(Evidence& evidence) {
    return evidence.kept.once([&] { return find_steady(evidence.file, evidence.sample); });
}

Section steady_section(Evidence& evidence) {
    const Summary& summary = evidence.summary;
    const SteadyReport& steady = steady_of(evidence);
    const auto seconds = [](const std::optional<double>& time) { return time ? Datum(*time) : Named{"", "none"}; };
    Results cases{
        .place = "steady/cases",
        .columns = {{"case", "case"},
                    {.key = "window_start", .words = "window from", .unit = "s", .decimals = 1},
                    {.key = "steady_start", .words = "steady from", .unit = "s", .decimals = 1},
                    {.key = "median_member_start", .words = "single runs", .unit = "s", .decimals = 1},
                    {"members_without_start", "without"},
                    {.key = "median_decorrelation_time", .words = "decorrelation", .unit = "s", .decimals = 2},
                    {.key = "median_effective_samples", .words = "effective samples", .decimals = 0}},
        .in_csv = false};
    Results members{.place = "steady/members",
                    .columns = program_columns("member case steady_start decorrelation_time effective_samples")};
    for (std::size_t k = 0; k < steady.cases.size(); ++k) {
        const CaseSteady& one = steady.cases[k];
        cases.add({summary.named(k), summary.cases[k].about.analysis.steady_start, seconds(one.start),
                   seconds(one.median_start), one.without_start, one.median_decorrelation_time,
                   one.median_effective_samples});
    }
    for (const MemberSteady& one : steady.members)
        members.add({one.member, summary.name_of(evidence.case_of(one.member)), seconds(one.start),
                     one.decorrelation_time, one.effective_samples});
    if (steady.members.empty()) {
        cases.view = Results::View::none;
        return {.results = {std::move(cases), std::move(members)},
                .missing = "Steady state: unknown, because the file has no load histories (/history/surge_load).\n"};
    }
    return {.title = "Steady state",
            .results = {std::move(cases), std::move(members)},
            .after =
                "\nSteady from: MSER of the mean history of the case, or later, where the load of the members has no "
                "trend to the end; none: not in the first half. Single runs: median over its members' own histories; "
                "without: members in which no steady part was found. Decorrelation: duration of load that counts as "
                "one independent value; effective samples: of the window. Both are medians over the members.\n"};
}

}  // namespace floes
