#pragma once
// The findings of a campaign file by name, as `floes summarize --parts` takes them and as the report shows them. A new
// finding is a source, the declaration of its section in sections.hpp, and a line in catalogue.cpp: nothing else lists
// them. Those that read the file throw as read_campaign_file() does.

#include <span>
#include <string_view>
#include <vector>

#include "findings/sections.hpp"

namespace floes {

/// Whether a finding is shown for this campaign; null: for none.
using When = bool (*)(const Campaign&);

struct Finding {
    std::string_view name;                        ///< of the part; empty: only the report has it
    std::vector<Section> (*sections)(Evidence&);  ///< may keep in the evidence what other findings need too
    std::string_view page_title = {};             ///< of its section of the report, which may go on in the next finding
    When on_page = nullptr;                       ///< in the report; with a page_title
    std::string_view holds = {};                  ///< what its sheet of a workbook holds
    When unasked = nullptr;                       ///< as text and JSON when no parts are named
    When unasked_in_json = nullptr;               ///< where JSON has it in further campaigns
    When unasked_in_workbook = nullptr;           ///< in a workbook when no parts are named
    bool for_csv_alone = false;
};

/// The part that fits on one screen.
inline constexpr std::string_view overview_part = "overview";

/// In the report, what stands before it is for everybody, what comes after it is its appendix.
inline constexpr std::string_view loads_title = "Loads";

/// In order of output. The first one, the cases, is always part of the JSON.
std::span<const Finding> findings();

}  // namespace floes
