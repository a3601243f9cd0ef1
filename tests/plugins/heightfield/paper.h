// One image column as the pseudo-code of Cohen-Or 1997 draws it (figs. 4 and 12), without coherence: every ray and
// every pixel begins at the eye. Its slips are mended: the upper ray moves on with the lower one, and a pixel whose
// limit is reached is done. Shares no code with the scene.
#pragma once

#include <map>
#include <vector>

#include "plugins/heightfield/brute_force.h"

namespace moire::test {

// A voxel of the walk: a wall that stands across the axis along which the column advances more voxels.
struct Wall {
  Element element;
  double x;  // distance over the ground along the column, world units
  double height;
  double s, t;       // where the column passes, in voxels of the map
  bool across_east;  // the wall's voxels follow each other along s
};

class PaperColumn {
 public:
  // The column at image coordinate x, which goes the way of its point in the picture's middle row.
  PaperColumn(const Map& map, const View& view, double x);

  // Rise of the ray through row coordinate y, a unit over the ground along the column.
  double slope(double y) const;

  // V_k, from the eye to the far limit.
  const std::vector<Wall>& walls() const { return walls_; }

  // PointSampleOneColumn (fig. 4) for one ray; null for the sky.
  const Wall* seen_at(double y) const;

  // What fig. 12 makes of the pixel between the rows `low` and `high` (low > high): W_k of each voxel.
  struct Part {
    const Wall* wall;
    double rise;    // H' - H(R)
    double length;  // of the same part in the image, in pixels
  };
  std::vector<Part> seen_between(double low, double high) const;

 private:
  // The row coordinate of a slope.
  double row(double slope) const;

  const View& view_;
  double z_;
  std::vector<Wall> walls_;
  double rise_ = 0, rise_per_row_ = 0, advance_ = 0,
         advance_per_row_ = 0;  // of the ray at row 0, and a row further down
};

// Eq. 4 with the second neighbour floor(y) + 1, voxels counted from their middles: the two voxels and their shares.
std::map<Element, double> interpolated(const Wall& wall);

}  // namespace moire::test
