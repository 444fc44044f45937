#pragma once
// Table 3 of the paper, one simulation a modulus, and the experiment that it quotes.

#include <array>

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
    double mean = 38.8;
    double maximum = 102.7;
    double failure_ratio = 0.22;
};

}  // namespace floes
