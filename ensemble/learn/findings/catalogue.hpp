#pragma once
// The findings of a campaign file by name, as `floes summarize --parts` takes them. A new finding is a file of its own
// and a line in parts.cpp.

#include <filesystem>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "campaign_file/read_details.hpp"
#include "findings/extremes.hpp"
#include "findings/steady.hpp"
#include "findings/summary.hpp"

namespace floes {

/// What parts are computed from.
struct Evidence {
    std::filesystem::path file;
    CampaignOrigin origin;
    Campaign campaign;  ///< from the configuration in the file
    CampaignTable table;
    Summary summary;                                         ///< of the table
    std::optional<SteadyReport> steady = {};                 ///< set if already computed; for the window as given
    std::optional<std::vector<CaseExtremes>> extremes = {};  ///< set if already computed: the fits take long
    Reference reference;                                     ///< case that the others are compared with
    double resolve = 0.1;  ///< difference that pairs are to resolve, as a fraction of the first case's mean
};

/// Reads the file. `automatic_window`: loads are recomputed over the steady finding. Throws InputError as
/// read_campaign_file() and with_automatic_window() do, and if there is no case `reference` (empty: no reference).
Evidence read_evidence(const CampaignFile& file, bool automatic_window = false, std::string_view reference = {});

struct Finding {
    std::string_view name;
    Section (*section)(Evidence&);     ///< may keep in the evidence what other parts need too
    bool (*unasked)(const Campaign&);  ///< whether it is shown for this campaign when no parts are named
    std::string_view page_title = {};  ///< of its section on the page; empty: the page places it elsewhere
    bool for_csv_alone = false;
};

/// In order of output. The first one, the cases, is always part of the JSON.
std::span<const Finding> findings();

}  // namespace floes
