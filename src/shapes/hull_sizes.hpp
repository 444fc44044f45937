#pragma once
// Hulls that a few numbers describe. Axes: x ahead, y up from the waterline, z to starboard; the origin is on the
// waterline, in the middle of its length.

#include <array>
#include <numbers>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/words.hpp"
#include "shapes/convex_solid.hpp"

namespace floes {

/// What a hull is given by.
enum class HullKind { profile, cylinder, cone_up, cone_down, four_legs, wedge_bow, drillship, barge, file };

/// Its words in hull.shape, and what they say.
inline constexpr std::array<std::string_view, 9> hull_kind_words{
    "profile", "cylinder", "cone_up", "cone_down", "four_legs", "wedge_bow", "drillship", "barge", "file"};
inline constexpr std::string_view hull_kind_doc =
    "profile: a body of revolution by structure.profile_m; cylinder: vertical; cone_up narrows upwards and breaks "
    "ice upwards; cone_down flares upwards and breaks it downwards; four_legs: vertical, in a square; wedge_bow: "
    "a ship with a wedge as bow and a flat stern; drillship: a wedge at either end; barge: ends that slope; file: "
    "convex pieces of hull.file or hull.pieces. docs/structures.md has their drawings.";

/// About the vertical axis.
constexpr bool is_of_revolution(HullKind kind) {
    using enum HullKind;
    return kind == profile || kind == cylinder || kind == cone_up || kind == cone_down;
}

/// With a bow, a stern and sides that may flare.
constexpr bool is_ship(HullKind kind) {
    using enum HullKind;
    return kind == wedge_bow || kind == drillship || kind == barge;
}

/// Lengths m, angles rad, from the horizontal; 0: not given.
struct HullSizes {
    double length = 0;                      ///< of the waterline
    double beam = 0;                        ///< likewise
    double diameter = 0;                    ///< of the circle, or of each, that it cuts out of the water
    double spacing = 0;                     ///< between the axes of neighbouring legs
    double draught = 0;                     ///< from the waterline down to the keel
    double freeboard = 0;                   ///< from the waterline up to the deck
    double wall = 0;                        ///< angle of a cone's wall
    double stem = 0;                        ///< angle of a ship's stem, or of a barge's ends
    double flare = 0.5 * std::numbers::pi;  ///< angle of the sides; below a right angle they flare upwards
    double entrance = 0;                    ///< half of the angle of the waterline at the bow

    friend bool operator==(const HullSizes&, const HullSizes&) = default;
};

/// A point of a profile: height above the waterline (m, negative below) and radius there (m).
struct ProfilePoint {
    double height = 0;
    double radius = 0;
    friend bool operator==(const ProfilePoint&, const ProfilePoint&) = default;
};

struct HullSolids {
    std::vector<std::string> parts;  ///< names
    std::vector<ConvexSolid> solids;
};

/// A size as a key, with what it means.
struct HullSizeKey {
    std::string_view path;
    double HullSizes::*size;
    std::string_view doc;
};
inline constexpr std::array<HullSizeKey, 10> hull_size_keys{
    {{"hull.length_m", &HullSizes::length, "Length of the waterline, of ships and barges."},
     {"hull.beam_m", &HullSizes::beam, "Breadth of the waterline, of ships and barges."},
     {"hull.diameter_m", &HullSizes::diameter,
      "Diameter of the circle that a cylinder, a cone or each leg cuts out of the water."},
     {"hull.spacing_m", &HullSizes::spacing, "Distance between the axes of neighbouring legs."},
     {"hull.draught_m", &HullSizes::draught, "From the waterline down to the keel."},
     {"hull.freeboard_m", &HullSizes::freeboard,
      "From the waterline up to the deck: the hull ends there, so it has to be above ice that piles up."},
     {"hull.wall_deg", &HullSizes::wall, "Angle of a cone's wall from the horizontal, below 90."},
     {"hull.stem_deg", &HullSizes::stem,
      "Angle from the horizontal of a ship's stem, or of both ends of a barge; below 90 they overhang and break ice "
      "downwards."},
     {"hull.flare_deg", &HullSizes::flare,
      "Angle of the sides of ships and barges from the horizontal; 90: vertical, below 90 they flare upwards."},
     {"hull.entrance_deg", &HullSizes::entrance,
      "Angle of the bow's waterline from the centre line, half of what it encloses."}}};

/// Those that the kind needs.
std::vector<double HullSizes::*> needed_sizes(HullKind kind);

/// Why the sizes are no such hull, as a clause behind it; nothing if they are.
std::optional<std::string> fault_of(HullKind kind, const HullSizes& sizes);

/// From the keel up, of a cylinder or a cone.
std::vector<ProfilePoint> profile_of(HullKind kind, const HullSizes& sizes);

/// For legs, ships and barges without fault.
HullSolids solids_of(HullKind kind, const HullSizes& sizes);

/// "barge, 100 m x 20 m at the waterline, draught 6 m, ends 45° and sides 90° from the horizontal".
Words words_of(HullKind kind, const HullSizes& sizes);

}  // namespace floes
