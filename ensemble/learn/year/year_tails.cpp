#include "year/year_tails.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "core/error.hpp"
#include "core/units.hpp"
#include "findings/case_peaks.hpp"
#include "keys/edit_distance.hpp"
#include "year/interpolated.hpp"

namespace floes {
namespace {

/// At least one, so that a nearest one exists.
std::string nearest(const std::vector<std::string>& names, const std::string& name) {
    return *std::ranges::min_element(names, {}, [&](const std::string& one) { return edit_distance(one, name); });
}

void refuse_rising(const JointTrend& trend, const std::string& who, const YearRequest& request) {
    if (trend.rises() && !request.load.rising)
        throw InputError(fmt::format(
            "{}: {}, so it is not known how high it gets later; measure later (--window auto, or run with a later "
            "analysis.steady_start_s), or give --rising to extrapolate as if it stayed as in the window",
            who, trend_text(trend)));
}

/// Makes each source once.
class TailFinder {
  public:
    TailFinder(const MatchWave& campaign, const YearRequest& request)
        : campaign_(campaign),
          request_(request),
          time_(averaging_time(campaign.table, request.load)),
          trends_(joint_trends(campaign.table)) {}

    YearRegimeRow row(const Regime& regime) {
        YearRegimeRow row{regime, {}};
        row.tail.time = regime.time / std::sqrt(request_.load.scale);
        if (regime.values.empty())
            row.tail.source = source_of_case(regime);
        else
            interpolate(row);
        return row;
    }

    YearTails made;

  private:
    std::size_t source_of_case(const Regime& regime) {
        std::vector<std::string> names;
        for (const CaseRow& one : campaign_.table.cases) names.push_back(one.name);
        const auto found = std::ranges::find(names, regime.case_name);
        if (found == names.end())
            throw InputError(fmt::format("{}: case = \"{}\" is no case of {}; did you mean {}?", regime.where,
                                         regime.case_name, campaign_.file, nearest(names, regime.case_name)));
        const auto of_case = static_cast<std::size_t>(found - names.begin());
        const auto known = std::ranges::find(made.sources, std::optional(of_case), &TailSource::of_case);
        if (known != made.sources.end()) return static_cast<std::size_t>(known - made.sources.begin());
        refuse_rising(trends_[of_case], fmt::format("{}: case {}", regime.where, regime.case_name), request_);
        const CasePeaks peaks = case_peaks(campaign_.table, of_case, time_);
        add({regime.case_name, of_case, peaks.members, peaks.rows.size(), 0, {}}, peaks.rows, peaks.measured, regime);
        return made.sources.size() - 1;
    }

    void interpolate(YearRegimeRow& row) {
        const Regime& regime = row.regime;
        const std::string base = design_case(campaign_, regime);
        auto known =
            std::ranges::find_if(made.sources, [&](const TailSource& one) { return !one.of_case && one.name == base; });
        if (known == made.sources.end()) {
            for (std::size_t k = 0; k < trends_.size(); ++k)
                if (campaign_.campaign.cases[k].base == base)
                    refuse_rising(trends_[k], fmt::format("{}: point {}", regime.where, campaign_.table.cases[k].name),
                                  request_);
            indices_.push_back(std::make_unique<InterpolatedDesign>(campaign_, base, request_.load));
            const InterpolatedDesign& design = *indices_.back();
            add({base, std::nullopt, design.members(), design.fewest_arrangements(), 0, {}}, design.rows(),
                design.measured(), regime);
            design_of_.resize(made.sources.size(), 0);
            design_of_.back() = indices_.size() - 1;
            known = made.sources.end() - 1;
        }
        row.tail.source = static_cast<std::size_t>(known - made.sources.begin());
        const Emulated index = indices_[design_of_[row.tail.source]]->at(regime);
        row.tail.factor = index.mean;
        row.tail.factor_sd = std::sqrt(index.variance) / index.mean;
    }

    void add(TailSource source, const std::vector<PeakRow>& rows, const Measured& measured, const Regime& regime) {
        if (rows.size() < fewest_members)
            throw InputError(
                fmt::format("{}: {} has {} of the {} members that a tail needs; 8 or more are a beginning, "
                            "50 say something of rare loads",
                            regime.where, source.words(), rows.size(), fewest_members));
        std::vector<std::span<const double>> peaks;
        for (const PeakRow& one : rows) peaks.emplace_back(one.peaks);
        source.unlike = unlike_members(peaks, request_.load.share);
        source.time_run = measured.window * static_cast<double>(rows.size());
        auto posterior = std::make_unique<const PosteriorLoad>(
            peaks, source.unlike.out,
            PosteriorAsked{measured.window, measured.separation, measured.mean,
                           averaged_shares(request_.load.share, campaign_.table.cases.size() > most_averaged_cases)});
        if (!posterior->valid())
            throw InputError(
                fmt::format("{}: {} has too few peaks for a tail in its {:.3g} h (a fit needs {}); run more "
                            "arrangements or longer windows",
                            regime.where, source.words(), source.time_run / unit::hour, fewest_peaks));
        made.sources.push_back(std::move(source));
        made.posteriors.push_back(std::move(posterior));
    }

    const MatchWave& campaign_;
    const YearRequest& request_;
    double time_;
    std::vector<JointTrend> trends_;
    std::vector<std::unique_ptr<InterpolatedDesign>> indices_;
    std::vector<std::size_t> design_of_;  ///< for each source its place in indices_
};

}  // namespace

std::string TailSource::words() const {
    if (of_case) return "case " + name;
    return name.empty() ? "the design" : fmt::format("the design's case {}", name);
}

YearTails year_tails(const MatchWave& campaign, const std::vector<Regime>& regimes, const YearRequest& request) {
    TailFinder finder(campaign, request);
    for (const Regime& regime : regimes) {
        YearRegimeRow row = finder.row(regime);
        finder.made.regimes.push_back(std::move(row));
    }
    return std::move(finder.made);
}

}  // namespace floes
