#pragma once
// The vector and matrix types of floes. World axes: x surge (tow direction), y up (water surface at y = 0), z sway.

#include <cstddef>
#include <numeric>
#include <ranges>
#include <utility>
#include <vector>

#include <Eigen/Core>
#include <Eigen/Geometry>

namespace floes {

/// Lengths that differ by less are equal, m.
inline constexpr double length_rounding = 1e-9;

using Vec2 = Eigen::Vector2d;
using Vec3 = Eigen::Vector3d;
using Mat3 = Eigen::Matrix3d;
using Vec6 = Eigen::Matrix<double, 6, 1>;
using Mat6 = Eigen::Matrix<double, 6, 6>;
using Quat = Eigen::Quaterniond;
using Box2 = Eigen::AlignedBox2d;
using Box3 = Eigen::AlignedBox3d;

/// The smallest box along the axes that holds all points.
template <class Points, int dimensions = std::ranges::range_value_t<Points>::RowsAtCompileTime>
Eigen::AlignedBox<double, dimensions> box_round(const Points& points) {
    Eigen::AlignedBox<double, dimensions> box;
    for (const auto& point : points) box.extend(point);
    return box;
}

/// A rigid pose: position in metres, orientation body -> world.
struct Pose {
    Vec3 position = Vec3::Zero();
    Quat orientation = Quat::Identity();
};

/// Where a floe lies on the water: centre (x, z) in metres; yaw in radians about +y (right-handed: +z turns to +x).
struct PlanarPose {
    double x = 0;
    double z = 0;
    double yaw = 0;
};

/// Turned by this about +y, rad; exactly not at all by 0.
inline Quat turned_about_y(double yaw) {
    return yaw == 0 ? Quat::Identity() : Quat(Eigen::AngleAxisd(yaw, Vec3::UnitY()));
}

/// Where a structure is, in six degrees of freedom. Its reference point is its axis at the height of the calm water.
/// Turns follow each other as given: yaw about +y (right-handed: the bow to port), pitch about its own +z (lifts the
/// bow), roll about its own +x (heels to starboard), rad.
struct StructurePose {
    Vec3 position = Vec3::Zero();  ///< of the reference point: surge x, heave y, sway z, m
    double yaw = 0;
    double pitch = 0;
    double roll = 0;

    Quat orientation() const {
        const Quat flat = turned_about_y(yaw);
        if (pitch == 0 && roll == 0) return flat;
        return flat * Quat(Eigen::AngleAxisd(pitch, Vec3::UnitZ())) * Quat(Eigen::AngleAxisd(roll, Vec3::UnitX()));
    }
    Pose pose() const { return {position, orientation()}; }
    /// A vector of the world in the structure's axes: ahead, up and to starboard.
    Vec3 in_own_axes(const Vec3& vector) const {
        return yaw == 0 && pitch == 0 && roll == 0 ? vector : orientation().conjugate() * vector;
    }
};

/// A force (N) and a moment about the centre of mass (N m), both in world axes.
struct Wrench {
    Vec3 force = Vec3::Zero();
    Vec3 moment = Vec3::Zero();

    Wrench& operator+=(const Wrench& other) {
        force += other.force;
        moment += other.moment;
        return *this;
    }
};

// Connected components of a graph (union-find).

class Components {
  public:
    /// Nodes 0 to `nodes` - 1, none connected.
    explicit Components(std::size_t nodes) : smaller_(nodes) {
        std::iota(smaller_.begin(), smaller_.end(), std::size_t{0});
    }

    void connect(std::size_t a, std::size_t b) {
        a = first(a);
        b = first(b);
        if (a > b) std::swap(a, b);
        smaller_[b] = a;
    }

    /// The smallest node that this one is connected with; itself if there is none smaller.
    std::size_t first(std::size_t node) {
        while (smaller_[node] != node) node = smaller_[node] = smaller_[smaller_[node]];  // shortens the next search
        return node;
    }

  private:
    std::vector<std::size_t> smaller_;  ///< a smaller node of the same component, or the node itself
};

}  // namespace floes
