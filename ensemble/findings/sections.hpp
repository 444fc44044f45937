#pragma once
// The sections that findings consist of, where their sources need no other door, with the results that they show.

#include <cstddef>
#include <functional>
#include <map>
#include <span>
#include <utility>
#include <vector>

#include "findings/evidence.hpp"
#include "inference/interval.hpp"
#include "statistics/averaged_load.hpp"
#include "statistics/load_map.hpp"
#include "tables/section.hpp"

namespace floes {

// Sections that only the report shows.

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

// Means corrected for what is known of the arrangements before they are run: their local order and the coverage ahead.

/// The quantities of the headlines for each case: the mean, the share of its variance that the covariates explain of
/// arrangements left out (r_squared_left_out), and the corrected mean, which is the mean itself unless `used`.
/// Arrangements of a geometry are drawn once, those after the campaign's last; cases with poses from a file have no
/// rows.
Results find_control(const Evidence& evidence);

Section control_section(Evidence& evidence);

// Where the work of the tow goes: the mean load as a sum of what ice, water and structure do with it.

/// Each share of the load over a case's arrangements: its work over the distance towed, N. By case, in the order of the
/// list of quantities; cases whose members did not measure it have none.
Results find_energy(const Sample& sample, const Summary& summary);

Section energy_section(Evidence& evidence);

// One line for each member, for further analysis of the values themselves.

/// In CSV: member,case,arrangement,status,…: the quantities of a case's summary under the same names, the maximum of
/// each segment, and whether the load was steady. Fields are empty where a member failed or is missing.
Section members_section(const Evidence& evidence);

/// In CSV: case,arrangement,quantity,unit,value: a line for each quantity of each done member, as far as it is known.
Section long_section(const Evidence& evidence);

// The pressure of ice over the area of each part of a hull.
//
// A part's normal force, averaged over a time, over the area of the part that the ice can lie against: its surface
// between the lower and the upper side of floating ice of the case's thickness, along the wall. What acts on the part
// above or below that is counted as if it acted there, so the pressure is not below that of the ice at the waterline.

/// By case, part and averaging time, at full scale: evidence.scale is the length there over that in the campaign;
/// lengths grow with it, pressures likewise, times with its square root. Largest pressure over that time: mean over
/// segments and arrangements; undefined where no ice lies against the part. iso_19906: pressure_of_area(); undefined
/// where there is no pressure, or the ice is a tank's. Nothing of members that were computed without normal forces.
Results find_pressures(const Evidence& evidence);

Section pressure_section(const Evidence& evidence);

// Loads on the parts of a hull and moments on the whole of it, over the arrangements of each case.

/// Parts, pressures on them, then moments.
std::vector<Section> parts_sections(Evidence& evidence);

// Where on the structure and when along the tow the load acts, over the members of each case. Needs no histories.

struct CaseLoadMap {
    std::size_t case_index = 0;
    int members = 0;                  ///< done members with a map, at least 1
    LoadMap mean;                     ///< over them
    std::vector<Interval> along_tow;  ///< of the mean over members in each part of the window, N

    double load() const;  ///< N: the sum over the structure

    /// Share of the load that acts within `angle` degrees of straight ahead, a multiple of 10; NaN of no load.
    double share_within(double angle) const;

    /// Share of the load in the heights from `low` to `high`, shares of the depth, by their middles; NaN of no load.
    double share_between(double low, double high) const;
};

/// Cases without a map are left out. Throws as read_campaign_file() does.
std::vector<CaseLoadMap> find_load_maps(const CampaignFile& file, const Sample& sample);

// What fatigue and operation ask of a load: its cycles, and how long it lasts above a level.

/// Slopes of S-N curves: 3, of welded steel, and 5, of its part for many cycles and of other details.
inline constexpr double fatigue_slopes[]{3, 5};

/// For one case, over its members with a stored history.
struct CaseFatigue {
    std::size_t case_index = 0;
    int runs = 0;
    double averaging = 0;  ///< s, that the load is averaged over
    double cycles = 0;     ///< per hour, of any range
    /// The range that, met once a second, does the damage of all cycles: (Σ count range^m / s)^(1/m), N, one of each
    /// slope. Damage adds up over a long exposure, so it is that of the mean damage over members, with its 95 %
    /// interval (t).
    std::vector<Interval> equivalent;
    std::vector<double> cycles_above;  ///< per hour, with a range of at least each of Fatigue::edges
    std::vector<double> time_above;    ///< share of the time with a load above each of them
};

struct Fatigue {
    std::vector<double> edges;  ///< N, rising from 0
    std::vector<CaseFatigue> cases;
};

/// The load of one member in its window.
struct LoadWindow {
    std::size_t case_index = 0;
    double step = 0;            ///< s
    double averaging = 0;       ///< s; a step or less: as it is
    std::vector<double> loads;  ///< N
};

/// Twelve edges of a round width up to the largest load or range.
Fatigue find_fatigue(std::span<const LoadWindow> windows);

/// For the stored histories, averaged over the shortest of analysis.averaging_s; of the mooring force that they make,
/// where Evidence::moored has a hull. Reads the file.
std::vector<Section> fatigue_sections(Evidence& evidence);

// How large the ice is before and after the structure: floes at the start, floes and pieces at the end. The size of ice
// is D, the side of the square with its area.

/// Area by size.
class IceSizes {
  public:
    /// Adds ice of one area, m²; a negative share takes it away again.
    void add(double area, double share = 1);

    double area() const;   ///< of all, m²
    double count() const;  ///< of all floes and pieces

    /// D below which this share (0 to 1) of the area is, m; NaN without ice.
    double quantile(double share) const;

    /// D and the share of the area in ice of at most this size, rising, as steps.
    std::vector<std::pair<double, double>> steps() const;

  private:
    struct Sum {
        double count = 0, area = 0;
    };
    std::map<long long, Sum> by_area_;  // in 10⁻⁹ m²: a floe is as large as its pieces together
};

struct SizesOfCase {
    std::size_t case_index = 0;
    int runs = 0;
    double split = 0;        ///< floes that cracked through, mean over members
    double pieces = 0;       ///< of one of them, mean
    double in_pieces = 0;    ///< share of the area that is in pieces, 0 to 1
    IceSizes before, after;  ///< sums over members
};

/// Areas of the floes of a member, by its number, m²; of a field without end those of a part, of which as many count as
/// entered.
using FloeAreas = std::function<std::vector<double>(int member)>;

/// For every case with done members. `pieces`: in order of member and floe.
std::vector<SizesOfCase> find_piece_sizes(const Sample& sample, std::span<const PieceRow> pieces,
                                          const FloeAreas& floes);

/// Part "pieces" of floes summarize.
Section piece_sizes_section(Evidence& evidence);

}  // namespace floes
