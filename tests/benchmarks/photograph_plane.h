// A ground plane under an aerial photograph, 512 x 512 pixels with the horizon at half their height: the view of all
// figures about lookups. Its exact averages, computed here on their own.
#pragma once

#include <array>
#include <vector>

#include <moire/texture.h>

namespace moire::benchmark {

class PhotographPlane {
 public:
  static constexpr int columns = 512, rows = 255;     // that lie below the horizon whole
  static constexpr double height = 100, focal = 500;  // texels, pixels

  // Requires: MOIRE_DATA is set.
  PhotographPlane();

  const Texture& texture() const { return texture_; }
  // What is seen in the middle of each pixel, row by row, the farthest first.
  const std::vector<SurfacePoint>& points() const { return points_; }
  // The photograph's exact average over each pixel, linear light.
  std::vector<std::array<double, 3>> exact() const;

 private:
  std::vector<float> texels_;
  Texture texture_;
  std::vector<SurfacePoint> points_;
};

}  // namespace moire::benchmark
