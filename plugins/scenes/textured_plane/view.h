// A pinhole camera above a plane, and the homography between its picture and the plane. World axes: x east (columns of
// the texture), y south (rows), z up, so that yaw 0 looks east and yaw 90 south. Lengths are in texels.
#pragma once

#include <moire/geometry.h>
#include <moire/settings.h>
#include <moire/turn.h>

namespace textured_plane {

// u and v are pixels to the right of the picture's middle and below it.
struct Linear {
  double u, v, constant;
  double operator()(double at_u, double at_v) const { return u * at_u + v * at_v + constant; }
};

// What the settings say, in texels.
struct Camera {
  moire::ImageSize size;
  double x = 0, y = 0, height = 1;
  double far = 0;  // how far ahead of the camera the texture ends
  double yaw_deg = 0, pitch_deg = 0, roll_deg = 0;
  double fov_deg = 90;  // across the width
};
Camera camera_of(const moire::Settings& settings, moire::ImageSize size, double texel);

// With W the fall of the ray through an image point (how far down it goes for a step ahead), the ray meets the plane at
// (s0 + S / W, t0 + T / W) if W > 0; S, T and W are linear in the image point. It sees the texture if F, linear too,
// is not negative: F = far W - H, where H / W is how far ahead of the camera the point of the plane lies, measured
// along the plane in the direction of view. That line is parallel to the horizon, in the plane and in the picture.
class View {
 public:
  explicit View(const Camera& camera);

  moire::ImageSize size() const { return size_; }
  const moire::Point& center() const { return center_; }
  double focal() const { return focal_; }  // pixels
  double height() const { return height_; }
  double far() const { return far_; }
  double s0() const { return s0_; }
  double t0() const { return t0_; }
  moire::Turn yaw() const { return yaw_; }
  moire::Turn pitch() const { return pitch_; }

  const Linear& s() const { return s_; }
  const Linear& t() const { return t_; }
  const Linear& fall() const { return fall_; }
  const Linear& nearness() const { return nearness_; }

  // True where the horizon is level and the texture's axes run along and across the view.
  bool is_aligned() const { return aligned_; }

  // How deep before the camera a point of the plane lies, given from the foot of the camera: height / W.
  double depth(double s, double t) const {
    return (s * yaw_.cosine + t * yaw_.sine) * pitch_.cosine - height_ * pitch_.sine;
  }
  // The place of such a point in the picture, from its middle. Requires: its depth is above 0.
  moire::Point image_of(double s, double t) const;

 private:
  moire::ImageSize size_;
  moire::Point center_;
  double focal_, height_, far_, s0_, t0_;
  moire::Turn yaw_, pitch_, roll_;
  bool aligned_;
  Linear s_, t_, fall_, nearness_;
};

// Error: texels are seen that have no element (texel_element) because they are too far off.
void check_reach(const View& view);

}  // namespace textured_plane
