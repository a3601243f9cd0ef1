// A view without roll along one of the texture's axes: every row of the picture sees one distance.
#pragma once

#include "place.h"
#include "view.h"

namespace textured_plane {

// Rows of the picture are counted by k: from the horizon where that is in reach, so that differences keep their digits
// near it, else from the picture's middle.
class LevelView {
 public:
  // Requires: view.is_aligned().
  explicit LevelView(const View& view);

  // Lines of texels run along s; else along t.
  bool lines_along_s() const { return along_s_; }
  // Of the camera: the line below it, and where on that line.
  const Place& line0() const { return line0_; }
  const Place& place0() const { return place0_; }
  // Line numbers rise ahead of the camera.
  bool rises_ahead() const { return rises_ahead_; }
  // X = X0 + b u / W on a line; negative where places fall to the right. Texels.
  double b() const { return b_; }
  // Pixels from the picture's middle to the left edge of pixel x.
  double u(int x) const { return x - center_x_; }

  // A row of pixels: its shares of sky, far ground and texture, and the texture's part.
  struct Row {
    double sky, far, near;
    double k0, k1;
  };
  Row row(int y) const;

  double fall(double k) const { return fall0_ + fall_slope_ * k; }
  // The inverse of fall(). Requires: the camera does not look straight up or down.
  double row_of_fall(double fall) const { return (fall - fall0_) * rows_per_fall_; }
  // How far ahead of the camera the plane lies at k.
  double ahead(double k) const;
  double row_of(double ahead) const;

 private:
  moire::Turn pitch_;
  double height_, focal_, center_x_;
  bool along_s_, rises_ahead_;
  Place line0_, place0_;
  double b_;
  bool from_horizon_;
  double fall0_, fall_slope_, rows_per_fall_;
  double top_;                // where k is 0, rows below the picture's upper edge
  double horizon_, far_row_;  // k
};

}  // namespace textured_plane
