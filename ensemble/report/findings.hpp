#pragma once
// All that is found in a campaign file, part by part, and its text: what `floes summarize` prints. A part that was not
// asked for is absent.

#include <optional>
#include <string>
#include <vector>

#include "report/formats.hpp"
#include "report/pairs.hpp"
#include "report/summary.hpp"

namespace floes {

struct Findings {
    Summary summary;
    Reference reference;
    bool show_cases = true;  ///< the summary's figures in table and CSV; JSON always has them
    std::optional<std::vector<PairRow>> pairs;
    PairOptions pair_options;
};

/// For people, no line wider than `width` where that can be: cases, then pairs.
std::string findings_table(const Findings& findings, int width);

/// For programs: summary_json() with "pairs" and so on beside "cases".
std::string findings_json(const Findings& findings);

/// The tables one after the other, each with its own header line, an empty line between two.
std::string findings_csv(const Findings& findings);

}  // namespace floes
