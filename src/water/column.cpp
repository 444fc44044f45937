#include "water/column.hpp"

#include <algorithm>

namespace floes {

SubmergedColumn submerged_column(const ElementState& state, double x, double z, double thickness) {
    const Vec3 foot = state.rotation.col(0) * x + state.rotation.col(2) * z;
    const Vec3 normal = state.normal();
    const double height = state.position.y() + foot.y();
    // Height along the column is height + s n_y with s in [-T/2, T/2]; find the s that lie below the surface.
    double low = -0.5 * thickness;
    double high = 0.5 * thickness;
    if (normal.y() > 0) {
        high = std::min(high, -height / normal.y());
    } else if (normal.y() < 0) {
        low = std::max(low, -height / normal.y());
    } else if (height >= 0) {
        high = low;
    }
    SubmergedColumn column;
    column.length = std::max(0.0, high - low);
    column.arm = foot + normal * (0.5 * (low + high));
    return column;
}

}  // namespace floes
