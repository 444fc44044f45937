#pragma once
// The colours of pictures and films.

#include <array>
#include <string_view>

#include "core/vector.hpp"

namespace floes {

struct Colour {
    double red = 0;  ///< 0-1, as the others
    double green = 0;
    double blue = 0;
    double opacity = 1;

    Colour faded(double by) const { return {red, green, blue, opacity * by}; }
};

/// From `a` at 0 to `b` at 1.
Colour between(const Colour& a, const Colour& b, double share);

/// What the colour of an element says.
enum class Colouring {
    ice,         ///< white; floes with a failed joint are warm
    piece,       ///< a colour for each piece
    speed,       ///< from 0 to the tow's
    utilisation  ///< of its worst joint, from 0 to 1, and cracks
};

inline constexpr std::array<std::string_view, 4> colouring_names{"ice", "piece", "speed", "utilisation"};

inline constexpr Colour white_ice{0.95, 0.97, 0.98};
inline constexpr Colour broken_ice{1.0, 0.80, 0.58};
inline constexpr Colour crack_colour{0.90, 0.20, 0.20};
inline constexpr Colour sheet_ice{0.78, 0.85, 0.89};
inline constexpr Colour structure_yellow{0.98, 0.80, 0.16};
inline constexpr Colour sea{0.13, 0.31, 0.43};
inline constexpr Colour ink{0.10, 0.15, 0.20};
inline constexpr Colour bright{1, 1, 1};

// Fig. 5: components of the load on the structure. Forces on floes at contacts have colours of their own.
inline constexpr Colour surge_red{0.90, 0.16, 0.16};
inline constexpr Colour heave_green{0.16, 0.70, 0.30};
inline constexpr Colour sway_blue{0.25, 0.50, 1.0};
inline constexpr Colour sum_white{1, 1, 1};
inline constexpr Colour normal_magenta{0.80, 0.10, 0.62};
inline constexpr Colour tow_orange{0.95, 0.50, 0.02};
inline constexpr Colour friction_teal{0.00, 0.62, 0.66};

/// Of a number from 0 to 1: dark blue, green, yellow.
Colour scale_colour(double share);

/// Of a piece: neighbouring numbers differ well.
Colour piece_colour(int piece);

/// Of a face with this outward normal in the light of the pictures' sun.
Colour lit(const Colour& colour, const Vec3& normal);

/// What is left of it below `depth` m of water, seen from above; `clear`, m: where nearly all is gone.
Colour through_water(const Colour& colour, double depth, double clear);

}  // namespace floes
