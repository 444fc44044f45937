#include "findings/case_peaks.hpp"

#include <algorithm>

namespace floes {

CasePeaks case_peaks(const CampaignTable& table, std::size_t of_case, double time) {
    CasePeaks made;
    double mean = 0;
    for (const MemberRow& row : table.members) {
        const AveragedLoad* averaged = row.averaged_over(time);
        if (row.case_index != static_cast<int>(of_case) || averaged == nullptr) continue;
        made.rows.push_back({averaged->peaks, averaged->segment_maximum});
        made.arrangements.push_back(row.arrangement);
        made.members.push_back(static_cast<int>(&row - table.members.data()));
        mean += row.load.mean;
    }
    mean /= std::max(1.0, static_cast<double>(made.rows.size()));
    const Analysis& analysis = table.cases[of_case].analysis;
    made.measured = {analysis.window, analysis.window / analysis.segments, analysis.peak_separation, mean};
    return made;
}

}  // namespace floes
