#include "findings/load_maps.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numeric>

#include "campaign_file/read_load_map.hpp"

namespace floes {
namespace {

void add(std::vector<double>& sums, const std::vector<double>& values) {
    sums.resize(values.size(), 0.0);
    std::ranges::transform(sums, values, sums.begin(), std::plus{});
}

/// Values of each part of the window, one a member.
using Parts = std::vector<std::vector<double>>;

void finish(CaseLoadMap& found, const Parts& parts) {
    for (std::vector<double>* sums : {&found.mean.surge, &found.mean.normal})
        for (double& value : *sums) value /= found.members;
    for (const std::vector<double>& part : parts) {
        found.along_tow.push_back(mean_interval(part));
        found.mean.along_tow.push_back(found.along_tow.back().estimate);
    }
}

/// Share of the load in the bins for which the function of height and angle is true.
template <class Function>
double share_of(const CaseLoadMap& found, Function counts) {
    double part = 0;
    for (std::size_t h = 0; h < LoadMap::heights; ++h)
        for (std::size_t a = 0; a < LoadMap::angles; ++a)
            if (counts(middle_height(h), middle_angle(a))) part += found.mean.surge[h * LoadMap::angles + a];
    return part / found.load();
}

}  // namespace

double CaseLoadMap::load() const {
    return std::accumulate(mean.surge.begin(), mean.surge.end(), 0.0);
}

double CaseLoadMap::share_within(double angle) const {
    return share_of(*this, [&](double, double middle) { return std::abs(middle) < angle; });
}

double CaseLoadMap::share_between(double low, double high) const {
    return share_of(*this, [&](double middle, double) { return low <= middle && middle < high; });
}

std::vector<CaseLoadMap> find_load_maps(const CampaignFile& file, const CampaignTable& table) {
    std::vector<CaseLoadMap> of_cases(table.cases.size());
    std::vector<Parts> parts(table.cases.size(), Parts(LoadMap::parts));
    for_each_load_map(file, [&](int member, const LoadMap& map) {
        const auto index = static_cast<std::size_t>(table.members.at(static_cast<std::size_t>(member)).case_index);
        CaseLoadMap& found = of_cases.at(index);
        found.case_index = index;
        ++found.members;
        add(found.mean.surge, map.surge);
        add(found.mean.normal, map.normal);
        for (std::size_t part = 0; part < LoadMap::parts; ++part) parts[index][part].push_back(map.along_tow.at(part));
    });
    for (std::size_t k = 0; k < of_cases.size(); ++k)
        if (of_cases[k].members > 0) finish(of_cases[k], parts[k]);
    std::erase_if(of_cases, [](const CaseLoadMap& found) { return found.members == 0; });
    return of_cases;
}

}  // namespace floes
