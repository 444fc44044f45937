#include "match/design_data.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <optional>
#include <set>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "campaign/identity.hpp"
#include "core/error.hpp"
#include "core/text.hpp"
#include "core/undefined.hpp"
#include "keys/edit_distance.hpp"

namespace floes {

namespace {

double mean_of(const std::vector<double>& values) {
    return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

double squares_about(const std::vector<double>& values, double mean) {
    double sum = 0;
    for (const double value : values) sum += (value - mean) * (value - mean);
    return sum;
}

/// Covariance of single runs of two points on one arrangement. Of two points with m and n runs, c of them on common
/// arrangements, the product of two deviations from the points' means has the expectation
/// (1 - 1/m - 1/n + c/(m n)) times the covariance.
double covariance(std::span<const PointRuns> points, const std::vector<double>& means) {
    std::vector<std::map<int, double>> deviations;
    for (std::size_t p = 0; p < points.size(); ++p) {
        std::map<int, double>& of_point = deviations.emplace_back();
        for (std::size_t k = 0; k < points[p].values.size(); ++k)
            of_point[points[p].arrangements[k]] = points[p].values[k] - means[p];
    }
    double products = 0;
    double weight = 0;
    for (std::size_t p = 0; p < points.size(); ++p) {
        for (std::size_t q = p + 1; q < points.size(); ++q) {
            if (points[p].wave != points[q].wave) continue;
            double common = 0;
            for (const auto& [arrangement, deviation] : deviations[p]) {
                const auto other = deviations[q].find(arrangement);
                if (other == deviations[q].end()) continue;
                products += deviation * other->second;
                common += 1;
            }
            const auto m = static_cast<double>(deviations[p].size());
            const auto n = static_cast<double>(deviations[q].size());
            weight += common * (1 - 1 / m - 1 / n + common / (m * n));
        }
    }
    return weight > 0 ? products / weight : 0;
}

}  // namespace

Scatter scatter_of(std::span<const PointRuns> points, double pooled_weight) {
    Scatter found{{}, {}, {}, undefined, 0};
    double squares = 0;
    double freedom = 0;
    std::vector<double> own_squares;
    for (const PointRuns& point : points) {
        const double own_freedom = static_cast<double>(point.values.size()) - 1;
        found.mean.push_back(mean_of(point.values));
        own_squares.push_back(squares_about(point.values, found.mean.back()));
        found.sample_variance.push_back(own_freedom > 0 ? own_squares.back() / own_freedom : undefined);
        squares += own_squares.back();
        freedom += own_freedom;
    }
    if (freedom > 0) found.pooled = squares / freedom;
    for (std::size_t p = 0; p < points.size(); ++p)
        found.variance.push_back((pooled_weight * found.pooled + own_squares[p]) /
                                 (pooled_weight + static_cast<double>(points[p].values.size()) - 1));
    if (found.pooled > 0) found.shared = std::clamp(covariance(points, found.mean) / found.pooled, 0.0, 1.0);
    return found;
}

namespace {

/// The cases of all waves that are used: by wave and point, then by [[case]].
struct UsedCase {
    int wave;
    int number;  ///< of the point
    std::string base;
    std::size_t index;  ///< in the wave's campaign
};

std::vector<UsedCase> used_cases(std::span<const MatchWave> waves) {
    std::vector<UsedCase> used;
    std::map<std::pair<std::string, std::string>, std::pair<int, std::string>> seen;
    for (std::size_t w = 0; w < waves.size(); ++w) {
        const Campaign& campaign = waves[w].campaign;
        for (std::size_t k = 0; k < campaign.cases.size(); ++k) {
            const Case& one = campaign.cases[k];
            const auto [place, is_new] = seen.try_emplace({one.base, case_fingerprint(campaign, static_cast<int>(k))},
                                                          static_cast<int>(w), one.name);
            if (is_new) {
                used.push_back({static_cast<int>(w), one.point, one.base, k});
                continue;
            }
            const auto& [wave, name] = place->second;
            if (wave == static_cast<int>(w)) continue;
            throw InputError(fmt::format(
                "{} has in its case {} the simulations of {}'s case {}; give each wave once, and a later wave "
                "points or a campaign.seed of its own",
                waves[w].file, one.name, waves[static_cast<std::size_t>(wave)].file, name));
        }
    }
    std::ranges::stable_sort(used, {}, [](const UsedCase& one) { return std::pair(one.wave, one.number); });
    return used;
}

/// Members are arrangement-major.
std::vector<const MemberRow*> done_members(const MatchWave& wave, std::size_t case_index) {
    std::vector<const MemberRow*> members;
    for (std::size_t k = case_index; k < wave.table.members.size(); k += wave.campaign.cases.size())
        if (wave.table.members[k].done()) members.push_back(&wave.table.members[k]);
    return members;
}

/// The name of the [[case]] that the target is about; none where it is held out and no wave has it.
std::optional<std::string> case_of(const Target& target, const std::vector<std::string>& cases) {
    if (target.case_name.empty() && cases.size() == 1) return cases.front();
    if (target.case_name.empty())
        throw InputError(fmt::format("The target {} names no case, and there are {}; give it a case.", target.name(),
                                     name_list(cases)));
    if (std::ranges::find(cases, target.case_name) != cases.end()) return target.case_name;
    if (target.held_out) return {};
    if (cases.size() == 1 && cases.front().empty())
        throw InputError(
            fmt::format("The target {} is about a case, and the design has no [[case]]; take case = \"{}\" "
                        "away from the target, or give the design a [[case]] of that name.",
                        target.name(), target.case_name));
    const auto near = std::ranges::min_element(
        cases, {}, [&](const std::string& one) { return edit_distance(one, target.case_name); });
    throw InputError(
        fmt::format("The target {} is about a case that no campaign has: the cases are {}; did you mean "
                    "{}? A target that is held out may lack its case.",
                    target.name(), name_list(cases), *near));
}

/// Collects the results of all waves, point by point.
class Collector {
  public:
    explicit Collector(std::span<const MatchWave> waves)
        : waves_(waves), axes_(match_axes(waves)), cases_(match_cases(waves)), used_(used_cases(waves)) {
        for (const UsedCase& one : used_) members_.push_back(done_members(wave_of(one), one.index));
    }

    MatchData collect(std::span<const Target> targets) {
        MatchData data{axes_, points(), {}};
        for (const Target& target : targets) data.targets.push_back(of_target(target));
        return data;
    }

  private:
    const MatchWave& wave_of(const UsedCase& one) const { return waves_[static_cast<std::size_t>(one.wave)]; }

    /// Numbers the points that have a done member in some case.
    std::vector<MatchPoint> points() {
        std::vector<MatchPoint> made;
        for (std::size_t k = 0; k < used_.size(); ++k) {
            const UsedCase& one = used_[k];
            if (members_[k].empty()) continue;
            const auto [place, is_new] =
                numbers_.try_emplace(std::pair(one.wave, one.number), static_cast<int>(made.size()));
            if (!is_new) continue;
            MatchPoint& point = made.emplace_back(MatchPoint{{}, one.wave, one.number});
            for (const MatchAxis& axis : axes_)
                point.coordinates.push_back(
                    axis.coordinate(numeric_value(wave_of(one).campaign.cases[one.index], axis.key)));
        }
        return made;
    }

    TargetData of_target(const Target& target) const {
        TargetData data;
        data.target = target;
        std::vector<PointRuns> all;
        const std::optional<std::string> name = case_of(target, cases_);
        for (std::size_t k = 0; name && k < used_.size(); ++k) {
            const UsedCase& one = used_[k];
            if (one.base != *name) continue;
            PointRuns point{one.wave, {}, {}};
            for (const MemberRow* member : members_[k]) {
                const double value = member->value(target.quantity);
                if (!std::isfinite(value)) continue;
                point.arrangements.push_back(member->arrangement);
                point.values.push_back(value);
            }
            if (point.values.empty()) continue;
            data.point.push_back(numbers_.at({one.wave, one.number}));
            data.runs.push_back(static_cast<int>(point.values.size()));
            all.push_back(std::move(point));
        }
        if (all.empty() && !target.held_out) throw no_data(target);
        const Scatter scatter = scatter_of(all, pooled_runs);
        if (!all.empty() && std::isnan(scatter.pooled))
            throw InputError(
                fmt::format("The target {} has one run at every point, which says nothing of the scatter; "
                            "run two arrangements or more.",
                            target.name()));
        data.mean = scatter.mean;
        data.sample_variance = scatter.sample_variance;
        data.variance = scatter.variance;
        data.shared = scatter.shared;
        return data;
    }

    InputError no_data(const Target& target) const {
        std::set<double> times;
        for (const MatchWave& wave : waves_)
            times.insert(wave.table.averaging_times.begin(), wave.table.averaging_times.end());
        const double time = target.quantity.averaging;
        if (time > 0 && !times.contains(time))
            return InputError(fmt::format(
                "The target {} is of a time that no campaign averages the load over; {} (analysis.averaging_s).",
                target.name(),
                times.empty() ? "they average over none" : fmt::format("the times are {} s", fmt::join(times, ", "))));
        return InputError(
            fmt::format("The target {} has no member that is done and measured it in any campaign.", target.name()));
    }

    std::span<const MatchWave> waves_;
    std::vector<MatchAxis> axes_;
    std::vector<std::string> cases_;
    std::vector<UsedCase> used_;
    std::vector<std::vector<const MemberRow*>> members_;  ///< done ones of each used case
    std::map<std::pair<int, int>, int> numbers_;          ///< wave and point -> index of the point
};

}  // namespace

MatchData match_data(std::span<const MatchWave> waves, std::span<const Target> targets) {
    return Collector(waves).collect(targets);
}

}  // namespace floes
