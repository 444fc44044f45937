#pragma once
// From a point of the world to a point of a picture.

#include "core/vector.hpp"
#include "view/camera.hpp"

namespace floes {

class Projection {
  public:
    /// Of a picture of this size, pixels.
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

}  // namespace floes
