#include "campaign_file/array_places.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace floes {
namespace {

std::vector<const ArrayAxis*> all_axes() {
    std::vector<const ArrayAxis*> axes;
    for (const ArrayOutput& array : array_outputs)
        for (const ArrayAxis* axis : array.axes)
            if (axis != nullptr && std::ranges::find(axes, axis) == axes.end()) axes.push_back(axis);
    return axes;
}

std::vector<double> united(const std::vector<std::vector<double>>& of_cases) {
    std::vector<double> all;
    for (const std::vector<double>& own : of_cases) all.insert(all.end(), own.begin(), own.end());
    std::ranges::sort(all);
    all.erase(std::ranges::unique(all).begin(), all.end());
    return all;
}

FiledAxis filed(const ArrayAxis& axis, const Campaign& campaign) {
    FiledAxis filed;
    if (axis.places == nullptr) return filed;
    std::vector<std::vector<double>> of_cases;
    for (const Case& one : campaign.cases) of_cases.push_back(axis.places(one.scenario));
    for (const std::vector<double>& own : of_cases) filed.own_sizes.push_back(own.size());
    if (axis.kind == AxisKind::placed) {
        filed.places = united(of_cases);
        for (const std::vector<double>& own : of_cases) {
            std::vector<std::size_t>& positions = filed.positions.emplace_back();
            for (const double place : own)
                positions.push_back(
                    static_cast<std::size_t>(std::ranges::lower_bound(filed.places, place) - filed.places.begin()));
        }
        return filed;
    }
    filed.places = *std::ranges::max_element(of_cases, {}, &std::vector<double>::size);
    filed.alike = std::ranges::all_of(of_cases, [&](const std::vector<double>& own) {
        return std::equal(own.begin(), own.end(), filed.places.begin());
    });
    return filed;
}

}  // namespace

ArrayPlaces::ArrayPlaces(const Campaign& campaign) {
    for (const ArrayAxis* axis : all_axes()) axes_.emplace(axis, filed(*axis, campaign));
}

std::vector<std::size_t> ArrayPlaces::own_sizes(const ArrayOutput& array, int case_index) const {
    std::vector<std::size_t> sizes;
    for (const ArrayAxis* one : array.axes) {
        if (one == nullptr) break;
        const std::vector<std::size_t>& of_cases = axis(*one).own_sizes;
        sizes.push_back(of_cases.empty() ? 0 : of_cases.at(static_cast<std::size_t>(case_index)));
    }
    return sizes;
}

/// Calls use(index in own values, index in the row) for each value, in order.
template <class Use>
void ArrayPlaces::for_each_place(const ArrayOutput& array, int case_index, std::span<const std::size_t> own,
                                 std::span<const std::size_t> sizes, const Use& use) const {
    const auto position = [&](std::size_t k, std::size_t index) {
        const auto& positions = axis(*array.axes[k]).positions;
        return positions.empty() ? index : positions.at(static_cast<std::size_t>(case_index)).at(index);
    };
    std::size_t count = 1;
    for (const std::size_t size : own) count *= size;
    std::vector<std::size_t> index(own.size(), 0);
    for (std::size_t value = 0; value < count; ++value) {
        std::size_t place = 0;
        bool inside = true;
        for (std::size_t k = 0; k < own.size(); ++k) {
            const std::size_t at = position(k, index[k]);
            inside = inside && at < sizes[k];
            place = place * sizes[k] + at;
        }
        if (inside) use(value, place);
        for (std::size_t k = own.size(); k-- > 0 && ++index[k] == own[k];) index[k] = 0;
    }
}

std::vector<double> ArrayPlaces::row(const ArrayOutput& array, int case_index, const ArrayValues& own,
                                     std::span<const std::size_t> sizes) const {
    std::size_t width = 1;
    for (const std::size_t size : sizes) width *= size;
    std::vector<double> row(width, std::numeric_limits<double>::quiet_NaN());
    if (!own.empty())
        for_each_place(array, case_index, own.sizes, sizes,
                       [&](std::size_t value, std::size_t place) { row[place] = own.values[value]; });
    return row;
}

ArrayValues ArrayPlaces::own(const ArrayOutput& array, int case_index, std::span<const double> row,
                             std::span<const std::size_t> sizes) const {
    ArrayValues own{own_sizes(array, case_index), {}};
    for (std::size_t k = 0; k < own.sizes.size(); ++k)
        if (array.axes[k]->kind == AxisKind::longest) own.sizes[k] = sizes[k];
    std::size_t count = 1;
    for (const std::size_t size : own.sizes) count *= size;
    own.values.resize(count, std::numeric_limits<double>::quiet_NaN());
    for_each_place(array, case_index, own.sizes, sizes,
                   [&](std::size_t value, std::size_t place) { own.values[value] = row[place]; });
    if (std::ranges::all_of(own.values, [](double value) { return std::isnan(value); })) own.values.clear();
    return own;
}

}  // namespace floes
