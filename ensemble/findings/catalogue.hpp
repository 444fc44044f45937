#pragma once
// Findings that only the report shows. Those that read the file throw as read_campaign_file() does.

#include <span>
#include <string_view>
#include <vector>

#include "findings/evidence.hpp"
#include "tables/section.hpp"

namespace floes {

/// A row for each case and averaging time.
Results averaged_loads(const Summary& summary);

/// That table with its meaning; empty where nothing was averaged.
Section averaged_section(Evidence& evidence);

/// Table 3 beside the paper's figures, and every arrangement with the mean of its case.
Section table3_section(Evidence& evidence);

/// How many simulations, and every hull and every size of floe to scale.
Section what_was_run(Evidence& evidence);

/// The load over time of the first arrangement that every case has done (the paper's Fig. 6). Reads the file.
Section histories_section(Evidence& evidence);

/// Where on the structure the load acts, and when along the tow, in the most loaded cases. Reads the file.
Section load_map_section(Evidence& evidence);

/// The mean load of the first n arrangements of each case with its 95 % interval, from three on.
Section convergence_section(Evidence& evidence);

/// Failed joints over time as means over arrangements, for each mode in which some joint failed.
Section failures_section(Evidence& evidence);

/// Where the joints of a floe failed, how often and in which modes, in the most loaded cases, except those whose floes
/// differ in shape. Empty where no joint failed.
Section joint_failures_section(Evidence& evidence);

/// How the floes of the member with the largest load lay at the start, and which of them broke. Empty where no member
/// is done, and where the page has pictures of it. Reads the file.
Section largest_load_section(Evidence& evidence);

/// The first case beside the hybrid model (Fig. 8; left out where Lindqvist's formula does not apply to its wall) and
/// plate tests of its ice (Fig. 2; left out where none were made).
Section closed_formulas_section(Evidence& evidence);

// The findings of a campaign file by name, as `floes summarize --parts` takes them and as the report shows them. A new
// finding is a source with its header, and a line in catalogue.cpp.

struct Finding {
    std::string_view name;                        ///< of the part; empty: only the report has it
    std::vector<Section> (*sections)(Evidence&);  ///< may keep in the evidence what other findings need too
    bool (*unasked)(const Campaign&);             ///< whether it is shown for this campaign when no parts are named
    std::string_view page_title = {};             ///< of its section of the report, which may go on in the next finding
    bool (*on_page)(const Campaign&) = nullptr;   ///< whether the report of this campaign has it; with a page_title
    bool for_csv_alone = false;
    bool (*unasked_in_json)(const Campaign&) = nullptr;  ///< where JSON has it in further campaigns
};

/// The part that fits on one screen.
inline constexpr std::string_view overview_part = "overview";

/// In the report, what stands before it is for everybody, what comes after it is its appendix.
inline constexpr std::string_view loads_title = "Loads";

/// In order of output. The first one, the cases, is always part of the JSON.
std::span<const Finding> findings();

}  // namespace floes
