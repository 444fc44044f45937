#pragma once
// Keys of [moorings] from the files of other programs: added mass and damping, mooring lines; and whether a file of
// hydrostatics means the same hull.

#include <optional>
#include <string>
#include <vector>

#include "scenario/scenario.hpp"

namespace floes {

struct MooringKeysRequest {
    std::string file;                    ///< its name, for messages
    std::string hull_name;               ///< of the configuration of the hull
    std::optional<Scenario> hull{};      ///< its water, its waterplane, and each motion at its natural period
    std::optional<double> period{};      ///< s, at which the values of a radiation file are taken, of all motions
    std::optional<double> density{};     ///< kg/m³; none: the hull's, or 1025
    double length = 1;                   ///< of WAMIT's units, m
    std::optional<double> gravity{};     ///< m/s²; none: the hull's, or 9.80665
    std::optional<double> depth{};       ///< m; none: deep
    std::optional<double> waterplane{};  ///< m², against which the file's longest waves are checked
    std::vector<double> reference{};     ///< the file's reference point, ahead, to port, up, m; empty: as it says
    std::string weight;                  ///< "inside" or "outside": where a stiffness has the hull's weight
};

/// The text that goes under [moorings], with remarks. `bytes`: the whole file, of which kind its beginning says. Throws
/// InputError for what is no such file, and where the request lacks what its kind needs.
std::string mooring_keys(const MooringKeysRequest& request, const std::string& bytes);

}  // namespace floes
