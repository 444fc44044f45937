#include "year/interpolated.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <limits>
#include <span>

#include "core/error.hpp"
#include "match/predict.hpp"

namespace floes {
namespace {

double number_of(const Entry& entry) {
    if (const auto* whole = std::get_if<std::int64_t>(&entry.value.data)) return static_cast<double>(*whole);
    return std::get<double>(entry.value.data);
}

}  // namespace

std::string design_case(const MatchWave& campaign, const Regime& regime) {
    if (!campaign.campaign.design.active())
        throw InputError(fmt::format(
            "{}: the regime {} gives {}, and {} has no design to interpolate; name one of its "
            "cases with case = \"…\", or run a [design] over {}",
            regime.where, regime.name, regime.values.front().path, campaign.file, regime.values.front().path));
    const std::vector<std::string> bases = match_cases({&campaign, 1});
    if (regime.case_name.empty() && bases.size() == 1) return bases.front();
    if (std::ranges::find(bases, regime.case_name) != bases.end()) return regime.case_name;
    if (bases.size() == 1 && bases.front().empty())
        throw InputError(
            fmt::format("{}: the design of {} has no [[case]] named {}; leave case out, or leave out the "
                        "values of axes to name one of its points",
                        regime.where, campaign.file, regime.case_name));
    throw InputError(
        fmt::format("{}: the regime {} has to say which [[case]] of the design it means: case = \"…\", one "
                    "of {}",
                    regime.where, regime.name, fmt::join(bases, ", ")));
}

InterpolatedDesign::InterpolatedDesign(const MatchWave& campaign, const std::string& base,
                                       const DesignLoadRequest& request) {
    const std::span<const MatchWave> waves(&campaign, 1);
    const double time = averaging_time(campaign.table, request);
    const std::array targets{to_predict(fmt::format("mean_maximum_{:g}s", time), base)};
    data_ = match_data(waves, targets);
    index_ = emulate(data_);
    const EmulatedTarget& index = index_.front();
    if (!index.emulated() || !index.mean().fault().empty())
        throw InputError(
            fmt::format("{}: the mean maximum cannot be interpolated between the points of the design: {}; "
                        "run more points, or name points as cases",
                        campaign.file, index.emulated() ? index.mean().fault() : "no point is done"));
    const CaseRuns runs = runs_of(waves, data_, std::vector<bool>(data_.points.size(), true), index, request);
    DividedRows divided = rows_of(runs.runs);
    measured_ = runs.measured;
    measured_.mean = divided.mean;
    rows_ = std::move(divided.rows);
    std::vector<std::size_t> counts(campaign.campaign.cases.size(), 0);
    for (const MemberRow& row : campaign.table.members) {
        const auto of_case = static_cast<std::size_t>(row.case_index);
        if (campaign.campaign.cases[of_case].base != base || row.averaged_over(time) == nullptr) continue;
        members_.push_back(static_cast<int>(&row - campaign.table.members.data()));
        ++counts[of_case];
    }
    fewest_ = std::numeric_limits<std::size_t>::max();
    for (const std::size_t count : counts)
        if (count > 0) fewest_ = std::min(fewest_, count);
}

Emulated InterpolatedDesign::at(const Regime& regime) const {
    constexpr double rounding = 1e-9;
    std::vector<std::string> keys;
    for (const MatchAxis& axis : data_.axes) keys.push_back(axis.key);
    for (const Entry& value : regime.values)
        if (std::ranges::find(keys, value.path) == keys.end())
            throw InputError(fmt::format("{}: {} is no axis of the design; its axes are {}", value.where, value.path,
                                         fmt::join(keys, ", ")));
    Eigen::VectorXd at(static_cast<Eigen::Index>(keys.size()));
    for (std::size_t k = 0; k < keys.size(); ++k) {
        const auto found = std::ranges::find(regime.values, keys[k], &Entry::path);
        if (found == regime.values.end())
            throw InputError(fmt::format("{}: the regime {} has no {}; give a value of each axis of the design: {}",
                                         regime.where, regime.name, keys[k], fmt::join(keys, ", ")));
        const MatchAxis& axis = data_.axes[k];
        const double value = number_of(*found);
        const bool on_scale = axis.scale == AxisScale::linear || value > 0;
        const double coordinate = on_scale ? axis.coordinate(value) : -std::numeric_limits<double>::infinity();
        if (!(std::abs(coordinate) <= 1 + rounding))
            throw InputError(
                fmt::format("{}: {} = {:g} is outside of the design, which has it from {:g} to {:g}; between "
                            "its points loads are interpolated, beyond them nothing is known: run a "
                            "design that reaches there",
                            found->where, keys[k], value, axis.from, axis.to));
        at[static_cast<Eigen::Index>(k)] = coordinate;
    }
    Emulated index = index_.front().mean().at(at);
    index.variance += index_.front().common_variance(at);
    if (!(index.mean > 0))
        throw InputError(
            fmt::format("{}: the emulated mean maximum of the regime {} is {:.3g} N, which is no load; run "
                        "more points of the design near it",
                        regime.where, regime.name, index.mean));
    return index;
}

}  // namespace floes
