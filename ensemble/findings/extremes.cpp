#include "findings/extremes.hpp"

namespace floes {

std::vector<CaseExtremes> find_extremes(const CampaignTable& table) {
    std::vector<CaseExtremes> all;
    for (std::size_t index = 0; index < table.cases.size(); ++index) {
        std::vector<std::vector<double>> maxima;
        std::vector<double> pooled;
        for (const MemberRow& row : table.members) {
            if (row.case_index != static_cast<int>(index) || row.status != RowStatus::done) continue;
            maxima.push_back(row.segment_maximum);
            pooled.insert(pooled.end(), row.segment_maximum.begin(), row.segment_maximum.end());
        }
        const Analysis& analysis = table.cases[index].analysis;
        CaseExtremes found;
        found.case_index = index;
        found.segment = analysis.window / analysis.segments;
        found.maxima = pooled.size();
        found.gumbel = fit_extremes(maxima, ExtremeKind::gumbel, return_periods);
        found.gev = fit_extremes(maxima, ExtremeKind::gev, return_periods);
        found.exceedance = exceedance_curve(std::move(pooled));
        all.push_back(std::move(found));
    }
    return all;
}

}  // namespace floes
