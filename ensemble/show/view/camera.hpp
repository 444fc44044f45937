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

}  // namespace floes
