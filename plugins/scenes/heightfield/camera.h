// A pinhole camera without roll above a map. World axes: x east (columns), y south (rows), z up, so that yaw 0 looks
// east and yaw 90 south; directions are given in voxels horizontally and in the heights' unit vertically.
#pragma once

#include <cmath>
#include <numbers>

#include <moire/geometry.h>

namespace heightfield {

struct Direction {
  double x, y, z;
  friend Direction operator+(Direction a, Direction b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
  friend Direction operator-(Direction a, Direction b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
  friend Direction operator*(double f, Direction d) { return {f * d.x, f * d.y, f * d.z}; }
};

class Camera {
 public:
  // Angles in degrees; `fov_deg` is the angle across the width of the image. Spacings: world units a voxel.
  Camera(moire::ImageSize size, double yaw_deg, double pitch_deg, double fov_deg, double spacing_x, double spacing_y)
      : center_{size.width / 2.0, size.height / 2.0} {
    constexpr double degree = std::numbers::pi / 180;
    const double cos_yaw = std::cos(yaw_deg * degree), sin_yaw = std::sin(yaw_deg * degree);
    cos_pitch_ = std::cos(pitch_deg * degree);
    sin_pitch_ = std::sin(pitch_deg * degree);
    focal_ = size.width / 2.0 / std::tan(fov_deg * degree / 2);
    forward_ = {cos_pitch_ * cos_yaw / spacing_x, cos_pitch_ * sin_yaw / spacing_y, sin_pitch_};
    right_ = 1 / focal_ * Direction{-sin_yaw / spacing_x, cos_yaw / spacing_y, 0};
    down_ = 1 / focal_ * Direction{sin_pitch_ * cos_yaw / spacing_x, sin_pitch_ * sin_yaw / spacing_y, -cos_pitch_};
  }

  // Of the ray through an image point; linear in the point.
  Direction direction(double x, double y) const {
    return forward_ + (x - center_.x) * right_ + (y - center_.y) * down_;
  }

  // How a direction moves with the image point.
  const Direction& right() const { return right_; }
  const Direction& down() const { return down_; }

  // True where elevation rises as y falls: above the nadir point, and below the zenith point.
  bool rises_upward(double y) const { return focal_ * cos_pitch_ + (y - center_.y) * sin_pitch_ > 0; }

  // The image of the direction straight down.
  moire::Pole nadir() const {
    return {-sin_pitch_ * center_.x, -sin_pitch_ * center_.y + focal_ * cos_pitch_, -sin_pitch_};
  }

  // Angle of a pixel in the middle of the image, in radians.
  double pixel_angle() const { return 1 / focal_; }

 private:
  moire::Point center_;
  double cos_pitch_, sin_pitch_, focal_;
  Direction forward_, right_, down_;
};

}  // namespace heightfield
