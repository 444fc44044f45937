#include "view/projection.hpp"

namespace floes {

Projection::Projection(const Camera& camera, double width, double height)
    : eye_(camera.eye),
      forward_((camera.target - camera.eye).normalized()),
      right_(forward_.cross(camera.up).normalized()),
      up_(right_.cross(forward_)),
      middle_(width / 2, height / 2),
      depth_((camera.target - camera.eye).norm()),
      scale_(height / camera.height),
      parallel_(camera.angle == 0) {}

Vec2 Projection::at(const Vec3& point) const {
    const Vec3 from_eye = point - eye_;
    const double scale = parallel_ ? scale_ : scale_ * depth_ / from_eye.dot(forward_);
    return middle_ + scale * Vec2(from_eye.dot(right_), -from_eye.dot(up_));
}

Vec3 Projection::seen(const Vec3& point) const {
    const Vec2 on_picture = at(point);
    const double depth = (point - eye_).dot(forward_);
    return {on_picture.x(), on_picture.y(), parallel_ ? 1 - depth / (2 * depth_) : depth_ / depth};
}

}  // namespace floes
