#pragma once
// From where the ice is looked at: the same for the page, for pictures and for films.

#include <array>
#include <string_view>

#include "core/vector.hpp"
#include "replay/recording.hpp"

namespace floes {

enum class View {
    perspective,  ///< Fig. 5: from above and astern, round the structure
    above,        ///< straight down on the structure
    side,         ///< level with the water, the tow to the right; what lies nearer than the structure is cut away
    below,        ///< from under the water, where floes slide along the wall
    plan          ///< the whole channel from above, to scale: Fig. 3
};

inline constexpr std::array<std::string_view, 5> view_names{"perspective", "above", "side", "below", "plan"};

struct Camera {
    Vec3 eye = Vec3::Zero();     ///< m; of a parallel projection nothing behind it is seen
    Vec3 target = Vec3::Zero();  ///< m, in the middle of the picture
    Vec3 up = Vec3::UnitY();     ///< up in the picture; not along the line of sight
    double angle = 0;            ///< vertical angle of view, rad; 0: parallel projection
    double height = 0;           ///< m that the picture is high at the target
};

/// From which x to which the view `plan` sees, m: the whole channel or, of a field without end, the ice round a
/// structure whose axis is at x = `structure` m.
Vec2 plan_of(const RecordingSubject& subject, double structure);

/// How a view sees a run while the structure's axis is at x = `structure` m and z = `across` m. All views but `plan`
/// follow it, and in a field without end that too.
Camera camera(View view, const RecordingSubject& subject, double structure, double across = 0);

// From a point of the world to a point of a picture.

class Projection {
  public:
    /// For a picture of this size, pixels.
    Projection(const Camera& camera, double width, double height);

    /// x to the right and y down, pixels from the upper left. The point must lie before the eye.
    Vec2 at(const Vec3& point) const;
    /// The same with how near the point is: larger is nearer, and it is linear along lines of the picture.
    Vec3 seen(const Vec3& point) const;
    /// Whether it lies before the eye.
    bool before(const Vec3& point) const { return (point - eye_).dot(forward_) > (parallel_ ? 0 : 0.01 * depth_); }
    /// From the point to the eye, of length 1.
    Vec3 to_eye(const Vec3& point) const { return parallel_ ? -forward_ : Vec3((eye_ - point).normalized()); }
    /// Pixels a metre at the target.
    double scale() const { return scale_; }

  private:
    Vec3 eye_;
    Vec3 forward_;
    Vec3 right_;
    Vec3 up_;
    Vec2 middle_;
    double depth_;  ///< of the target
    double scale_;
    bool parallel_;
};

// The colours of pictures and films.

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
inline constexpr Colour line_violet{0.76, 0.62, 0.98};  // mooring lines
inline constexpr Colour tow_orange{0.95, 0.50, 0.02};
inline constexpr Colour friction_teal{0.00, 0.62, 0.66};

/// The colour of a number from 0 to 1: dark blue, green, yellow.
Colour scale_colour(double share);

/// The colour of a piece: neighbouring numbers differ well.
Colour piece_colour(int piece);

/// The colour of a face with this outward normal in the light of the pictures' sun.
Colour lit(const Colour& colour, const Vec3& normal);

/// What is left of it below `depth` m of water, seen from above; `clear`, m: where nearly all is gone.
Colour through_water(const Colour& colour, double depth, double clear);

}  // namespace floes
