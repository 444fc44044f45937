#include "water/polygon_water.hpp"

#include <algorithm>
#include <cmath>

namespace floes {
namespace {

/// The submerged part of the column through body point (x, 0, z): its length, and the arm to its middle.
struct Column {
    double length;
    Vec3 arm;
};

Column submerged(const ElementState& e, double x, double z, double thickness) {
    const Vec3 normal = e.rotation.col(1);
    const Vec3 foot = x * e.rotation.col(0) + z * e.rotation.col(2);
    const double height = e.position.y() + foot.y();
    const double half = 0.5 * thickness;
    const double crossing = normal.y() != 0 ? -height / normal.y() : 0;
    const double high = normal.y() > 0 ? std::min(crossing, half) : normal.y() < 0 ? half : height >= 0 ? -half : half;
    const double low = normal.y() < 0 ? std::max(crossing, -half) : -half;
    return {std::max(0.0, high - low), foot + 0.5 * (low + high) * normal};
}

/// Velocity of a point of the element against the water, m/s.
Vec3 relative_velocity(const ElementState& e, const Vec3& arm, const WaterFactors& f, double structure_x) {
    const double x = e.position.x() + arm.x() - structure_x;
    const double z = e.position.z() + arm.z() - f.structure_z;
    const double r2 = x * x + z * z;
    const double near = r2 > f.radius * f.radius ? f.radius * f.radius / r2 : 1.0;
    const double twice_cos = r2 == 0 ? 1.0 : (x * x - z * z) / r2;
    const double twice_sin = r2 == 0 ? 0.0 : 2 * x * z / r2;
    const Vec3 flow(near * (f.speed * twice_cos + f.speed_across * twice_sin) + f.current_x, 0,
                    near * (f.speed * twice_sin + f.speed_across * (r2 == 0 ? 1.0 : -twice_cos)) + f.current_z);
    return flow - (e.velocity + e.angular_velocity.cross(arm));
}

void add(Wrench& to, const Vec3& force, const Vec3& arm) {
    to += {force, arm.cross(force)};
}

}  // namespace

PolygonWater::PolygonWater(const Water& water, double gravity, const CutElement& element, double thickness, double mass,
                           double waterline_radius, double speed, const Vec2& wind_stress)
    : corners_(element.corners),
      gauss_x_(std::sqrt(element.xx / element.area)),
      gauss_z_(std::sqrt(element.zz / element.area)) {
    const double side = std::sqrt(element.area);
    const WaterModel square(water, gravity, {side, thickness}, mass, waterline_radius, speed, wind_stress);
    factors_ = square.factors();
    flows_ = square.flows();
    damping_ = square.damping();
}

Wrench PolygonWater::wrench(const ElementState& e, const WaterFactors& f, double damping, double structure_x) const {
    const Vec3 normal = e.rotation.col(1);
    Wrench total;
    for (std::size_t k = 0; k < corners_.size(); ++k) {
        if ((e.exposed_edges >> k & 1U) == 0) continue;
        const Corner middle = 0.5 * (corners_[k] + after(corners_, k));
        const Corner out = outward(corners_, k);
        const Column column = submerged(e, middle.x, middle.z, f.thickness);
        const Vec3 outwards = out.x * e.rotation.col(0) + out.z * e.rotation.col(2);
        const double approach = relative_velocity(e, column.arm, f, structure_x).dot(outwards);
        if (column.length == 0 || approach >= 0) continue;
        add(total, f.form * edge_length(corners_, k) * column.length * approach * approach * outwards, column.arm);
    }
    const double down = normal.y() >= 0 ? -0.5 : 0.5;
    for (const double x : {-gauss_x_, gauss_x_}) {
        for (const double z : {-gauss_z_, gauss_z_}) {
            const Column column = submerged(e, x, z, f.thickness);
            const Vec3 foot = column.arm - normal.dot(column.arm) * normal;
            if (column.length > 0) {
                add(total, {0, f.buoyancy * column.length, 0}, column.arm);
                const Vec3 arm = foot + down * f.thickness * normal;
                const Vec3 relative = relative_velocity(e, arm, f, structure_x);
                const double through = relative.dot(normal);
                const Vec3 along = relative - through * normal;
                const Vec3 drawn =
                    f.turn_cos * along + (normal.y() >= 0 ? f.turn_sin : -f.turn_sin) * normal.cross(along);
                const double waves = column.length < f.waves_below ? damping / 4 : 0;
                add(total, f.skin * along.norm() * drawn + (f.heave * std::abs(through) + waves) * through * normal,
                    arm);
            }
            if (column.length < f.thickness * (1 - 1e-9))
                add(total, {f.wind_x, 0, f.wind_z}, foot - down * f.thickness * normal);
        }
    }
    return total;
}

}  // namespace floes
