#pragma once
// Where on the structure the ice acts, and when along the tow: means over the window in so few bins that every member
// keeps them. Heights are equal parts of the structure's depth, so that structures of different depth compare bin by
// bin; angles go round its axis, 0 ahead (+x), positive towards +z.

#include <array>
#include <cstddef>
#include <vector>

namespace floes {

class StateArchive;

struct LoadMap {
    static constexpr std::size_t heights = 12;  ///< from the keel up
    static constexpr std::size_t angles = 36;   ///< of 10 degrees each, from -180
    static constexpr std::size_t parts = 24;    ///< of the window

    /// Height h and angle a are at h * angles + a. Means over the window, N; empty: not taken.
    std::vector<double> surge;   ///< load against the tow, friction included; adds up to the mean load
    std::vector<double> normal;  ///< sum of the magnitudes of the normal forces

    std::vector<double> along_tow;  ///< mean surge load in each part of the window, N

    bool empty() const { return surge.empty(); }
    friend bool operator==(const LoadMap&, const LoadMap&) = default;
};

/// Middle of a bin as a share of the depth, from 0 at the keel to 1 at the top.
constexpr double middle_height(std::size_t height) {
    return (static_cast<double>(height) + 0.5) / LoadMap::heights;
}

/// Middle of a bin, degrees.
constexpr double middle_angle(std::size_t angle) {
    return -180 + 360 * (static_cast<double>(angle) + 0.5) / LoadMap::angles;
}

/// Middle of a part of the window as a share of the window's length.
constexpr double middle_part(std::size_t part) {
    return (static_cast<double>(part) + 0.5) / LoadMap::parts;
}

/// Adds up the contacts of one run; allocates nothing.
class ContactBins {
  public:
    /// Heights of the structure's keel and upper end, m.
    ContactBins(double bottom, double top) : bottom_(bottom), bins_a_metre_(LoadMap::heights / (top - bottom)) {}

    /// A contact `ahead` of the structure's axis (m, along +x), at height `up` and `across` (along +z), with its force
    /// on the structure (N): surge load and magnitude of the normal force. Above the top and below the keel it counts
    /// in the last bin there.
    void add(double ahead, double up, double across, double surge, double normal);

    /// Over `steps` steps, all of which added their contacts; without along_tow.
    LoadMap means(std::size_t steps) const;

    /// What was added, saved or set (core/state_archive.hpp).
    void archive(StateArchive& state);

  private:
    double bottom_;
    double bins_a_metre_;
    std::array<double, LoadMap::heights * LoadMap::angles> surge_{};
    std::array<double, LoadMap::heights * LoadMap::angles> normal_{};
};

/// The bin of the angle from +x towards +z of a point in the plane. By comparisons alone, so every machine bins alike.
std::size_t angle_bin(double ahead, double across);

}  // namespace floes
