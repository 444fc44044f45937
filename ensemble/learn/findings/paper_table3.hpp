#pragma once
// Table 3 of the paper (one simulation for each modulus) and the experiment that it quotes.

#include <array>

#include "findings/summary.hpp"
#include "scenario/scenario.hpp"

namespace floes {

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

/// The paper's run of this case; nullptr if there is none.
const PaperRow* paper_row(const Case& one);

/// A row for each case with confidence and prediction intervals. Rows of the paper and of the experiment follow the
/// case that they belong to.
Table table3(const Campaign& campaign, const Summary& summary);

}  // namespace floes
