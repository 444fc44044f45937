#pragma once
// The columns of /members that are numbers of a done member: one list for writing and reading. For this room only.

#include <array>

#include "campaign_file/campaign_file.hpp"

namespace floes {

/// A column of doubles.
struct RealColumn {
    const char* name;
    const char* unit;
    const char* long_name;
    double& (*field)(MemberRow&);
    bool later = false;  ///< files before layout 1.3 do not have it
};

inline constexpr std::array real_columns{
    RealColumn{"mean_load", "N", "mean surge load over the window",
               [](MemberRow& row) -> double& { return row.mean_load; }},
    RealColumn{"sd_load", "N", "population standard deviation of the surge load over the window",
               [](MemberRow& row) -> double& { return row.sd_load; }},
    RealColumn{"maximum_load", "N", "largest surge load in the window",
               [](MemberRow& row) -> double& { return row.maximum_load; }},
    RealColumn{"skewness", "1", "skewness of the surge load over the window",
               [](MemberRow& row) -> double& { return row.skewness; }, true},
    RealColumn{"excess_kurtosis", "1", "excess kurtosis of the surge load over the window",
               [](MemberRow& row) -> double& { return row.excess_kurtosis; }, true},
    RealColumn{"mean_maximum", "N", "mean of the segment maxima of the surge load",
               [](MemberRow& row) -> double& { return row.mean_maximum; }},
    RealColumn{"sd_maximum", "N", "population standard deviation of the segment maxima of the surge load",
               [](MemberRow& row) -> double& { return row.sd_maximum; }},
    RealColumn{"failure_ratio", "1", "broken floes over all floes at the end of the run",
               [](MemberRow& row) -> double& { return row.failure_ratio; }},
    RealColumn{"mean_sway", "N", "mean sway load over the window",
               [](MemberRow& row) -> double& { return row.mean_sway; }},
    RealColumn{"mean_heave", "N", "mean heave load over the window",
               [](MemberRow& row) -> double& { return row.mean_heave; }},
    RealColumn{"trend", "N s-1", "slope of the surge load over the window",
               [](MemberRow& row) -> double& { return row.trend; }},
    RealColumn{"trend_p", "1", "probability of a slope at least so far from zero if there were none",
               [](MemberRow& row) -> double& { return row.trend_p; }},
    RealColumn{"peak_compression", "N", "largest axial compression in any joint over the run",
               [](MemberRow& row) -> double& { return row.peaks.compression; }},
    RealColumn{"peak_tension", "N", "largest axial tension in any joint over the run",
               [](MemberRow& row) -> double& { return row.peaks.tension; }},
    RealColumn{"peak_shear", "N", "largest resultant shear in any joint over the run",
               [](MemberRow& row) -> double& { return row.peaks.shear; }},
    RealColumn{"peak_bending", "N m", "largest bending moment in any joint over the run",
               [](MemberRow& row) -> double& { return row.peaks.bending; }},
    RealColumn{"peak_torsion", "N m", "largest torsion in any joint over the run",
               [](MemberRow& row) -> double& { return row.peaks.torsion; }},
    RealColumn{"peak_in_plane_bending", "N m", "largest in-plane bending moment in any joint over the run",
               [](MemberRow& row) -> double& { return row.peaks.in_plane_bending; }},
};

/// A column of counts, stored as doubles so that every reader sees NaN where there is no count.
struct CountColumn {
    const char* name;
    const char* long_name;
    int MemberRow::*field;
};

inline constexpr std::array count_columns{
    CountColumn{"failures_bending", "joints that failed in bending", &MemberRow::failures_bending},
    CountColumn{"failures_shear", "joints that failed in shear", &MemberRow::failures_shear},
    CountColumn{"failures_compression", "joints that failed in compression", &MemberRow::failures_compression},
};

}  // namespace floes
