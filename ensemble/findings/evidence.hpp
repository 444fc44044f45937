#pragma once
// What findings are computed from: a campaign file as read, what is asked of it, and what several findings need. All of
// them include this, and it includes none of them.

#include <any>
#include <cmath>
#include <filesystem>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>
#include <typeindex>
#include <utility>
#include <vector>

#include "campaign_file/campaign_table.hpp"
#include "campaign_file/read.hpp"
#include "core/units.hpp"
#include "findings/summary.hpp"
#include "member/design_of.hpp"
#include "simulation/laboratory.hpp"
#include "statistics/oscillator.hpp"
#include "tables/units.hpp"

namespace floes {

/// What is asked of design loads, at full scale. Froude: times and speeds grow with the square root of the scale,
/// forces with its cube.
struct DesignLoadRequest {
    double exposure = 3 * unit::hour;    ///< s
    std::vector<double> quantiles{0.9};  ///< probabilities of not being exceeded, each in (0, 1)
    double averaging = 1;                ///< s, that the load is averaged over
    double scale = 1;                    ///< length at full scale / length in the campaign
    bool rising = false;                 ///< extrapolate a load that still rises in the measured window
    double share = 0.25;                 ///< of the peaks, the highest, that the tails are fitted to
    DesignOf of = design_ofs.front();

    double model_exposure() const { return exposure / std::sqrt(scale); }    ///< s
    double model_averaging() const { return averaging / std::sqrt(scale); }  ///< s
    double factor() const { return std::pow(scale, of.power()); }  ///< value at full scale / value in the campaign
};

/// A hull that the stored loads of a fixed one move.
struct MooredRequest {
    Oscillator hull;       ///< at full scale
    double scale = 1;      ///< length at full scale / length in the campaign
    double averaging = 1;  ///< s at full scale: the load that the mooring force is compared with

    /// The hull at the scale of the campaign: stiffness over λ², mass over λ³, the same damping ratio.
    Oscillator model() const;
    double model_averaging() const { return averaging / time_factor(); }  ///< s
    double time_factor() const { return std::sqrt(scale); }               ///< of times and speeds
    double force_factor() const { return scale * scale * scale; }
};

/// What is asked of a campaign, beside the names of findings.
struct Inquiry {
    Reference reference = {};                              ///< case that the others are compared with
    std::optional<DesignLoadRequest> design_request = {};  ///< none: by default
    double resolve = 0.1;  ///< difference that pairs are to resolve, of the first case's mean
    /// Of mooring lines against their break load: of a whole mooring, its dynamic analysis, by ISO 19901-7.
    double safety_factor = 1.67;
    double scale = 1;                          ///< length at full scale / length in the campaign
    std::optional<MooredRequest> moored = {};  ///< none: nobody asks
    std::vector<CurvePoint> plate_tests = {};  ///< of the first case's ice; empty: not made
    bool pictured = false;                     ///< the page has pictures of the member with the largest load
};

/// What several findings need, each kind made when the first one asks.
class MadeOnce {
  public:
    /// What `make` gives, or gave before.
    template <class Make>
    const std::invoke_result_t<Make>& once(const Make& make) {
        std::any& made = made_[typeid(std::invoke_result_t<Make>)];
        if (!made.has_value()) made = make();
        return *std::any_cast<std::invoke_result_t<Make>>(&made);
    }
    template <class Made>
    void set(Made made) {
        made_[typeid(Made)] = std::move(made);
    }

  private:
    std::map<std::type_index, std::any> made_;
};

struct Evidence : Inquiry {
    std::size_t case_of(int member) const { return sample.case_of(static_cast<std::size_t>(member)); }
    /// The case that the others are compared with, and whether there are others: a design has none.
    std::size_t base() const { return reference.value_or(0); }
    bool compared() const { return summary.cases.size() > 1 && (!campaign.design.active() || reference); }

    std::filesystem::path file;  ///< empty: the members are in no file yet
    CampaignOrigin origin;
    Campaign campaign;  ///< from the configuration in the file
    CampaignTable table;
    Sample sample;     ///< of the table
    Summary summary;   ///< of the sample
    Units units = {};  ///< of all that people are shown of this campaign
    MadeOnce kept = {};
};

/// Reads the file. `automatic_window`: loads are recomputed over the steady finding. Throws InputError as
/// read_campaign_file() and with_automatic_window() do, and if there is no case `reference` (empty: no reference).
Evidence read_evidence(const CampaignFile& file, bool automatic_window = false, std::string_view reference = {});

/// For members that are in no file yet; findings that read the file must not be asked.
Evidence evidence_of(Campaign campaign, CampaignTable table);

/// All joints that failed; none where the file keeps none.
const std::vector<BreakRow>& breaks_of(Evidence& evidence);
/// The pieces of all floes that cracked through; none where the file keeps none.
const std::vector<PieceRow>& pieces_of(Evidence& evidence);

/// Cases that have a panel of their own: at most six with done members, the most loaded, in file order. `which`: of
/// those that may have one; empty: of all.
using Which = std::function<bool(std::size_t)>;
std::vector<std::size_t> drawn_cases(const Summary& summary, const Which& which = {});
/// A sentence on the cases that have none; empty where all have.
std::string undrawn_text(const Summary& summary, const Which& which = {});

/// What plays the worst moment of a member in a browser; `of`: as floes replay --of, empty: the load of a step.
std::string replay_command(const Evidence& evidence, int member, std::string_view of = {});

/// The done member with the largest load of a step in its window; none where none is done.
std::optional<int> most_loaded_member(const Evidence& evidence);

}  // namespace floes
