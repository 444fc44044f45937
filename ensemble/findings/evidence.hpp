#pragma once
// What findings are computed from: a campaign file as read, and what several findings need, computed once.

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "campaign_file/campaign_table.hpp"
#include "campaign_file/read.hpp"
#include "findings/design_load.hpp"
#include "findings/extremes.hpp"
#include "findings/moored.hpp"
#include "findings/points.hpp"
#include "findings/steady.hpp"
#include "findings/summary.hpp"
#include "simulation/laboratory.hpp"
#include "tables/units.hpp"

namespace floes {

struct DesignLoads {
    DesignLoadRequest asked;
    std::vector<CaseDesignLoad> of_cases;  ///< empty where the members did not average their load
};

struct Evidence {
    Evidence() : sample(table) {}

    std::size_t case_of(int member) const { return sample.case_of(static_cast<std::size_t>(member)); }

    std::filesystem::path file;  ///< empty: the members are in no file yet
    CampaignOrigin origin;
    Campaign campaign;  ///< from the configuration in the file
    CampaignTable table;
    Sample sample;                            ///< of the table
    Summary summary;                          ///< of the table
    Units units = {};                         ///< of all that people are shown of this campaign
    std::optional<SteadyReport> steady = {};  ///< for the window as given; none until a finding asks, like the next
    std::optional<std::vector<CaseExtremes>> extremes = {};
    std::optional<Sensitivity> sensitivity = {};
    std::optional<DesignLoads> designs = {};
    std::optional<std::vector<SimulatedDesign>> simulated = {};
    std::optional<std::vector<BreakRow>> breaks = {};
    std::optional<std::vector<PieceRow>> pieces = {};
    Reference reference;                                   ///< case that the others are compared with
    std::optional<DesignLoadRequest> design_request = {};  ///< none: by default
    double resolve = 0.1;  ///< difference that pairs are to resolve, of the first case's mean
    /// Of mooring lines against their break load: of a whole mooring, its dynamic analysis, by ISO 19901-7.
    double safety_factor = 1.67;
    double scale = 1;                          ///< length at full scale / length in the campaign
    std::optional<MooredRequest> moored = {};  ///< hull that the loads move; none: nobody asks
    std::vector<CurvePoint> plate_tests = {};  ///< of the first case's ice; empty: not made
    bool pictured = false;                     ///< the page has pictures of the member with the largest load
};

/// Reads the file. `automatic_window`: loads are recomputed over the steady finding. Throws InputError as
/// read_campaign_file() and with_automatic_window() do, and if there is no case `reference` (empty: no reference).
Evidence read_evidence(const CampaignFile& file, bool automatic_window = false, std::string_view reference = {});

/// For members that are in no file yet; findings that read the file must not be asked.
Evidence evidence_of(Campaign campaign, CampaignTable table);

const std::vector<CaseExtremes>& extremes_of(Evidence& evidence);
const Sensitivity& sensitivity_of(Evidence& evidence);
/// As requested, else as `floes design` has them by default, over the longest averaging time where the members did not
/// take 1 s. Throws InputError if the members did not take the averaging time that is requested.
const DesignLoads& designs_of(Evidence& evidence);
/// All joints that failed; none where the file keeps none.
const std::vector<BreakRow>& breaks_of(Evidence& evidence);
/// The pieces of all floes that cracked through; none where the file keeps none.
const std::vector<PieceRow>& pieces_of(Evidence& evidence);

/// Cases that have a panel of their own: at most six with done members, the most loaded, in file order.
std::vector<std::size_t> drawn_cases(const Summary& summary);
/// A sentence on the cases that have none; empty where all have.
std::string undrawn_text(const Summary& summary);

/// What plays the worst moment of a member in a browser; `of`: as floes replay --of, empty: the load of a step.
std::string replay_command(const Evidence& evidence, int member, std::string_view of = {});

/// The done member with the largest load of a step in its window; none where none is done.
std::optional<int> most_loaded_member(const Evidence& evidence);

}  // namespace floes
