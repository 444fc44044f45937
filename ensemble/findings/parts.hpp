#pragma once
// The parts of what is found in a campaign file, by name: what `floes summarize --parts` takes. A new finding is a file
// of its own and a line in parts.cpp.

#include <filesystem>
#include <optional>
#include <span>
#include <string_view>

#include "findings/steady.hpp"
#include "findings/summary.hpp"

namespace floes {

/// What parts are made from.
struct Evidence {
    std::filesystem::path file;
    Campaign campaign;  ///< as the file's own configuration has it
    CampaignTable table;
    Summary summary;                          ///< of the table
    std::optional<SteadyReport> steady = {};  ///< where it was needed already: of the window as it was given
    Reference reference;                      ///< case that the others are compared with
    double resolve = 0.1;  ///< difference that pairs are to resolve, as a part of the first case's mean
};

/// Reads the file. `automatic_window`: loads are measured anew where they are steady. Throws InputError as
/// read_campaign_file() and with_automatic_window() do, and when there is no case `reference` (empty: none).
Evidence read_evidence(const std::filesystem::path& file, bool automatic_window = false,
                       std::string_view reference = {});

struct Part {
    std::string_view name;
    Section (*section)(const Evidence&);
    bool (*unasked)(const Campaign&);  ///< whether it is shown of this campaign when no parts are named
    std::string_view page_title = {};  ///< of its section on the page; empty: the page has it in a place of its own
    bool for_csv_alone = false;
};

/// In the order in which they are told. The first one, the cases, stands in JSON whatever is asked for.
std::span<const Part> parts();

}  // namespace floes
