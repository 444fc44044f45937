#pragma once
// The load of the ice on a structure over time, in the axes of other programs: X ahead, Y to port, Z up, right-handed.
// With ours (x ahead, y up, z to starboard): X = x, Y = -z, Z = y; moments by the right-hand rule about these.

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace floes {

/// Means over cells of equal length that follow each other from t = 0.
struct LoadSeries {
    double step = 0;                           ///< s, of a cell
    std::array<std::vector<double>, 3> force;  ///< N, along X, Y and Z, a value a cell
    std::vector<double> moment;                ///< N m, about Z through the structure's axis; empty: not known

    std::size_t cells() const { return force[0].size(); }
    double length() const { return step * static_cast<double>(cells()); }  ///< s
};

enum class LoadAxes : std::uint8_t {
    earth,  ///< at rest, X along the channel as the tow goes
    hull    ///< X horizontal, towards the bow, turning with the hull's yaw
};

/// The histories of a member as its file has them (docs/campaign_file.md): forces in the structure's own axes, which
/// yaw, pitch and roll with it (StructurePose), the moment about the vertical.
struct HullHistories {
    double step = 0;  ///< s
    std::span<const double> surge, sway, heave;
    std::span<const double> yaw;       ///< rad, positive where +z turns to +x; empty: towed straight on
    std::span<const double> yaw_load;  ///< N m, positive likewise; empty: not stored
    std::span<const double> pitch{};   ///< rad, as StructurePose has it; empty, with roll: it does neither
    std::span<const double> roll{};    ///< rad, likewise
};

/// In these axes. `tow_towards`: direction of the tow in the earth's axes, rad from X towards Y.
LoadSeries load_series(const HullHistories& stored, LoadAxes axes, double tow_towards = 0);

/// By Froude to lengths `scale` times as large: times by its square root, forces by its cube, moments by the fourth
/// power.
LoadSeries scaled(LoadSeries series, double scale);

/// The same load from `from` s on as means over `step` s, so many whole ones as end by `to` s; t = 0 is at `from`. The
/// impulse over each cell is that of the old cells below it. Expects a span within the series and at least one cell.
LoadSeries resampled(const LoadSeries& series, double from, double to, double step);

/// So many whole steps lie in the span.
std::size_t whole_steps(double from, double to, double step);

/// N s along X, Y and Z, N m s about Z (0 where not known), over the series. Programs that interpolate linearly between
/// means which stand in the middles of their cells, and hold the first and the last one, have the same impulse over the
/// series: each value counts once, half of it on each side of its middle.
std::array<double, 4> impulse(const LoadSeries& series);

}  // namespace floes
