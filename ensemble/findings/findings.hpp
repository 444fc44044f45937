#pragma once
// All that is found in a campaign file, part by part, and its text: what `floes summarize` prints. A part that was not
// asked for is absent.

#include <optional>
#include <string>
#include <vector>

#include "findings/extremes.hpp"
#include "findings/formats.hpp"
#include "findings/levels.hpp"
#include "findings/pairs.hpp"
#include "findings/points.hpp"
#include "findings/sensitivity.hpp"
#include "findings/steady.hpp"
#include "findings/summary.hpp"

namespace floes {

struct Findings {
    CampaignTable table;
    Summary summary;  ///< of the table
    Reference reference;
    bool show_cases = true;  ///< the summary's figures in table and CSV; JSON always has them
    std::optional<std::vector<PairRow>> pairs;
    PairOptions pair_options;
    std::optional<DesignPoints> points;
    std::optional<Sensitivity> sensitivity;
    std::optional<std::vector<CaseExtremes>> extremes;
    bool show_extremes = true;  ///< fits and return levels; the exceedance curve alone where not
    bool exceedance = false;    ///< the curve too; in a table it is too long
    std::optional<std::vector<LevelRow>> levels;
    std::optional<SteadyReport> steady;
    bool members = false;  ///< a line for each member; CSV alone
};

/// For people, no line wider than `width` where that can be: cases, points, sensitivity, pairs, extremes, steady
/// states.
std::string findings_table(const Findings& findings, int width);

/// For programs: summary_json() with "pairs" and so on beside "cases".
std::string findings_json(const Findings& findings);

/// The tables one after the other, each with its own header line, an empty line between two.
std::string findings_csv(const Findings& findings);

}  // namespace floes
