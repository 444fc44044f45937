#include "findings/sensitivity.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>

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
        const Case& one = campaign.cases[k];
        const auto [place, is_new] = known.emplace(one.base, all.size());
        if (is_new) all.push_back({one.base, {}});
        all[place->second].cases.push_back(k);
    }
    for (Points& points : all)
        std::ranges::sort(points.cases, {}, [&](std::size_t k) { return campaign.cases[k].point; });
    return all;
}

/// Values of a quantity: a row for each arrangement, a column for each point; NaN where no member is done.
std::vector<std::vector<double>> values_of(const Points& points, const Quantity& quantity, const CampaignTable& table) {
    const std::size_t cases = table.cases.size();
    std::vector<std::vector<double>> values(table.members.size() / cases);
    for (std::size_t arrangement = 0; arrangement < values.size(); ++arrangement) {
        for (const std::size_t k : points.cases) {
            const MemberRow& member = table.members[arrangement * cases + k];
            values[arrangement].push_back(member.value(quantity));
        }
    }
    return values;
}

bool finite(const std::vector<double>& values) {
    return std::ranges::all_of(values, [](double value) { return std::isfinite(value); });
}

/// Mean of each point over the arrangements in which it is done; NaN if there is none.
std::vector<double> means_of(const std::vector<std::vector<double>>& values, std::size_t points) {
    std::vector<double> means(points, std::numeric_limits<double>::quiet_NaN());
    for (std::size_t p = 0; p < points; ++p) {
        double sum = 0;
        int count = 0;
        for (const std::vector<double>& arrangement : values) {
            if (!std::isfinite(arrangement[p])) continue;
            sum += arrangement[p];
            ++count;
        }
        if (count > 0) means[p] = sum / count;
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
        SensitivityAxis& one = axes.emplace_back(SensitivityAxis{axis.key, axis.from, axis.to, axis.scale});
        if (campaign.design.has_ranges()) continue;
        one.from = one.to = numeric_value(campaign.cases.front(), axis.key);
        for (const Case& point : campaign.cases) {
            const double value = numeric_value(point, axis.key);
            one.from = std::min(one.from, value);
            one.to = std::max(one.to, value);
        }
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

}  // namespace

bool in_detail(const Campaign& campaign) {
    constexpr std::size_t few = 12;
    return !campaign.design.active() || campaign.cases.size() <= few;
}

Sensitivity find_sensitivity(const Campaign& campaign, const CampaignTable& table) {
    Sensitivity found;
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
    const std::vector<Quantity> known = table.quantities();
    for (const Points& points : by_base(campaign)) {
        const PointCoordinates places = coordinates(campaign, points, found.axes);
        bool fitted = false;
        for (const Quantity& quantity : known) {
            if (!quantity.in_designs) continue;
            const auto values = values_of(points, quantity, table);
            const std::vector<double> means = means_of(values, points.cases.size());
            SensitivityRow& row = found.rows.emplace_back();
            row.quantity = quantity;
            row.base = points.base;
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

}  // namespace floes
