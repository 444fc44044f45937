#include "match/divided_runs.hpp"

namespace floes {

DividedRows rows_of(std::span<const DividedRun> runs) {
    DividedRows made;
    for (const DividedRun& run : runs) {
        made.rows.push_back(run.row);
        made.mean += run.mean / static_cast<double>(runs.size());
    }
    return made;
}

CaseRuns runs_of(std::span<const MatchWave> waves, const MatchData& data, const std::vector<bool>& left,
                 const EmulatedTarget& mean_maximum, const DesignLoadRequest& request) {
    CaseRuns made;
    for (std::size_t k = 0; k < data.points.size(); ++k) {
        const MatchPoint& point = data.points[k];
        const MatchWave& wave = waves[static_cast<std::size_t>(point.wave)];
        const double time = averaging_time(wave.table, request);
        const double index = mean_maximum.mean().at(coordinates_of(point)).mean;
        for (const MemberRow& row : wave.table.members) {
            const auto number = static_cast<std::size_t>(row.case_index);
            const Case& about = wave.campaign.cases[number];
            if (about.point != point.number || about.base != mean_maximum.target().case_name) continue;
            const AveragedLoad* averaged = row.averaged_over(time);
            if (averaged == nullptr) continue;
            DividedRun run{index, left[k], row.load.mean / index, {averaged->peaks, averaged->segment_maximum}};
            for (double& peak : run.row.peaks) peak /= index;
            for (double& maximum : run.row.segment_maxima) maximum /= index;
            made.runs.push_back(std::move(run));
            const Analysis& analysis = wave.table.cases[number].analysis;
            made.measured = {analysis.window, analysis.window / analysis.segments, analysis.peak_separation, 0};
        }
    }
    return made;
}

}  // namespace floes
