#pragma once
// The cases of a campaign: the few figures that everybody asks for first, Table 3 beside the paper's, and every
// quantity.

#include <array>
#include <string>
#include <utility>
#include <vector>

#include "findings/summary.hpp"
#include "scenario/scenario.hpp"

namespace floes {

struct LoadColumn {
    Quantity quantity{};
    std::string words;  ///< "mean load"

    /// Its column for people: "23.4 ± 6.2"; "0.0 in all" where all runs gave the same; "23.4 ± –" where the interval
    /// says nothing otherwise; "–" without a result.
    ResultColumn column() const;
};

/// Mean load, largest load and broken floes.
std::vector<LoadColumn> load_columns(const Summary& summary);

/// A quantity of a case as a cell.
Estimate estimate_of(const CaseSummary& row, const Quantity& quantity);

/// What the columns mean, as sentences.
std::string load_columns_text(const Summary& summary);

/// Cases that are shown one by one; of a design with more of them, its axes and its extreme points are.
inline constexpr std::size_t most_overview_rows = 12;

/// The points with the least and the largest mean load, in words; none without a result.
std::vector<std::pair<std::string, std::size_t>> extreme_points(const Summary& summary);

// Table 3 of the paper (one simulation for each modulus) and the experiment that it quotes.

struct PaperRow {
    double elastic_modulus_mpa;
    double cfm;  ///< Σ of Table 1
    double mean;
    double sd;
    double mean_maximum;
    double sd_maximum;
    double failure_ratio;  ///< 0-1
};

inline constexpr std::array<PaperRow, 3> paper_table3{{
    {30, 0.03, 26.50, 15.52, 93.39, 34.00, 0.106},
    {60, 0.016, 30.28, 18.43, 117.94, 31.39, 0.101},
    {200, 1e-10, 28.32, 18.67, 121.38, 26.39, 0.175},
}};

/// Hasegawa et al. (2019b) at 60 MPa: mean and maximum load, N; failure ratio (Hasegawa et al., 2018).
struct Experiment {
    double elastic_modulus_mpa = 60;
    double mean = 38.8;
    double maximum = 102.7;
    double failure_ratio = 0.22;
};

/// Whether the scenario is the paper's: everything that the paper states has the stated value, except E and Σ. What it
/// leaves open (wall below the waterline, far end, contact Γ, iterations) may differ.
bool is_the_papers(const Scenario& scenario);

/// Two rows for each case: means with their intervals, and what one further run gives. Rows of the paper and of the
/// experiment follow the case that they belong to.
Results table3(const Campaign& campaign, const Summary& summary);

/// Conditions, counts, every quantity with its intervals, failures by mode, members set aside; for people one column
/// for each case. CSV and JSON: for each case its counts and conditions; for each quantity KEY with KEY_low and
/// KEY_high, KEY_prediction_…; of loads KEY_standing_out, the members that the intervals count as a kind of
/// their own; of counts KEY_total; with a reference KEY_difference_percent. JSON also has the hulls, as "profiles".
Section summary_section(const Summary& summary, Reference reference = {});

}  // namespace floes
