#include "traced/take_outlines.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <limits>
#include <map>
#include <vector>

#include "core/error.hpp"
#include "outline/elements.hpp"
#include "outline/rings.hpp"
#include "traced/traced_file.hpp"

namespace floes {
namespace {

constexpr double smallest = 0.01;  // m, of all outlines together
constexpr double largest = 1e5;

bool ends_with(std::string file, const std::string& ending) {
    std::ranges::transform(file, file.begin(), [](unsigned char c) { return std::tolower(c); });
    return file.ends_with(ending);
}

std::vector<TracedFloe> floes_of(const std::string& text, const std::string& file) {
    const bool csv = ends_with(file, ".csv");
    if (!csv && !ends_with(file, ".geojson") && !ends_with(file, ".json"))
        throw InputError(
            fmt::format("{}: outlines are read from .geojson, .json and .csv files; export one of these", file));
    if (text.size() > longest_outline_file)
        throw InputError(
            fmt::format("{}: this file has {} bytes, more than {}; simplify its outlines, or take a part "
                        "of it",
                        file, text.size(), longest_outline_file));
    if (text.find_first_not_of(" \t\r\n") == std::string::npos)
        throw InputError(fmt::format("{}: the file is empty", file));
    std::vector<TracedFloe> floes = csv ? read_outline_csv(text, file) : read_geojson(text, file);
    if (floes.empty()) throw InputError(fmt::format("{}: the file has no outlines", file));
    return floes;
}

/// The ring without corners that lie on the one before.
Outline ring_of(const Outline& corners, const std::string& where) {
    Outline ring = corners;
    ring.erase(std::ranges::unique(ring).begin(), ring.end());
    while (ring.size() > 1 && ring.front() == ring.back()) ring.pop_back();
    if (ring.size() > most_ring_corners)
        throw InputError(fmt::format("{}: the outline has {} corners, more than {}; simplify it", where, ring.size(),
                                     most_ring_corners));
    if (const auto fault = ring_fault_of(ring)) throw InputError(fmt::format("{}: {}; trace it anew", where, *fault));
    return ring;
}

/// What the file says covers, in its unit.
double area_of(const TracedFloe& floe) {
    double area = std::abs(floes::area_of(floe.ring));
    for (const Outline& hole : floe.holes) area -= std::abs(floes::area_of(hole));
    if (!(area > 0)) throw InputError(fmt::format("{}: its holes leave nothing of it", floe.where));
    return area;
}

void refuse_doubles(const std::vector<TracedFloe>& floes) {
    std::map<std::string, const TracedFloe*> named;
    for (const TracedFloe& one : floes) {
        if (one.name.empty()) continue;
        const auto [found, is_new] = named.try_emplace(one.name, &one);
        if (!is_new)
            throw InputError(
                fmt::format("{}: floe {} is there already ({}); was it traced twice? Give each floe a "
                            "name of its own, or none a name",
                            one.where, one.name, found->second->where));
    }
}

struct Bounds {
    Corner low{std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity()};
    Corner high{-low.x, -low.z};

    void hold(const Outline& outline) {
        for (const Corner& one : outline) {
            low = {std::min(low.x, one.x), std::min(low.z, one.z)};
            high = {std::max(high.x, one.x), std::max(high.z, one.z)};
        }
    }
};

/// Floes of some metres are some 1e-5 degrees wide, and no file in lengths has floes as small beside its coordinates.
void refuse_degrees(const std::vector<TracedFloe>& floes, const Bounds& bounds, const std::string& file) {
    constexpr double widest = 0.1;  // degrees, of one floe: 11 km
    double size = 0;
    for (const TracedFloe& one : floes) size = std::max({size, size_of(one.ring).x, size_of(one.ring).z});
    if (size > widest || bounds.low.x < -180 || bounds.high.x > 360 || bounds.low.z < -90 || bounds.high.z > 90) return;
    throw InputError(fmt::format(
        "{}: its coordinates look like degrees of longitude and latitude: the largest floe is {:.3g} across, and all "
        "lie within x = {:.6g} to {:.6g} and y = {:.6g} to {:.6g}; project them to lengths first, such as the UTM zone "
        "of the picture, or, if they are lengths, write them in a smaller unit with shapes.unit",
        file, size, bounds.low.x, bounds.high.x, 0.0 - bounds.high.z, 0.0 - bounds.low.z));
}

/// Of all floes, divided by commas; empty if none has one.
std::string names_of(const std::vector<TracedFloe>& floes) {
    if (std::ranges::all_of(floes, &std::string::empty, &TracedFloe::name)) return "";
    std::string names;
    for (std::size_t i = 0; i < floes.size(); ++i) {
        std::string name = floes[i].name.empty() ? fmt::format("{}", i + 1) : floes[i].name;
        std::ranges::replace_if(
            name, [](unsigned char c) { return c == ',' || c < ' '; }, ' ');
        names += (i > 0 ? ", " : "") + name;
    }
    return names;
}

}  // namespace

void take_outlines(TracedOutlines& traced, const std::string& text, const std::string& file) {
    std::vector<TracedFloe> floes = floes_of(text, file);
    refuse_doubles(floes);
    Bounds bounds;
    for (TracedFloe& one : floes) {
        one.ring = ring_of(one.ring, one.where);
        for (Outline& hole : one.holes) hole = ring_of(hole, one.where + ", a hole");
        bounds.hold(one.ring);
    }
    refuse_degrees(floes, bounds, file);
    const double unit = metres(traced.unit);
    const double size = unit * std::max(bounds.high.x - bounds.low.x, bounds.high.z - bounds.low.z);
    if (!(size > smallest && size < largest))
        throw InputError(
            fmt::format("{}: the outlines reach over {:.4g} m, which is no field of ice; is shapes.unit "
                        "right?",
                        file, size));
    Bounds of_floes;  // which reach a little farther where they have fewer corners
    std::vector<Outline> outlines;
    std::vector<double> areas;
    for (const TracedFloe& one : floes) {
        areas.push_back(unit * unit * area_of(one));
        Outline placed;
        for (const Corner& corner : one.ring) placed.push_back(unit * (corner - bounds.low));
        outlines.push_back(with_fewer_corners(convex_hull(std::move(placed)), most_outline_corners));
        of_floes.hold(outlines.back());
    }
    const Corner origin{of_floes.low.x, 0.5 * (of_floes.low.z + of_floes.high.z)};
    for (Outline& one : outlines)
        for (Corner& corner : one) corner = corner - origin;
    traced.outlines = std::move(outlines);
    traced.areas = std::move(areas);
    traced.names = names_of(floes);
    traced.path.clear();
    traced.unit = LengthUnit::m;
}

}  // namespace floes
