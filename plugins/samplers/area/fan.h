// The geometry of area sampling on lines through a pole: the image is divided into wedges with their apex there.
//
// A fan holds the lines that run more along one image axis ("along") than across it ("across"): y and x for a pole
// above or below the picture. Four fans cover an image with the pole in it. Wedges of a fan are equally wide on its
// reference line, the far end of the fan, so that nowhere do they get wider than 1 / lines of a pixel.
#pragma once

#include <vector>

#include <moire/geometry.h>

namespace area {

// Part of a pixel that lies in one wedge and one stretch of its middle line.
struct Share {
  int x, y;      // the pixel
  double width;  // mean extent of wedge and pixel across the line, in pixels along the across axis
};

// The stretches of a wedge's middle line: within each, the wedge overlaps the same pixels and is about equally wide.
struct Stretches {
  moire::Point from, to;           // the middle line, in order of rising elevation
  std::vector<double> cuts;        // distances from `from` in pixels, one more than stretches
  std::vector<std::size_t> first;  // shares of stretch i are first[i] .. first[i + 1] - 1
  std::vector<Share> shares;
  double along_per_distance = 1;  // advance along the along axis for a pixel's distance on the line

  void clear() { cuts.clear(), first.clear(), shares.clear(); }
};

class Fan {
 public:
  // `transposed`: the along axis is x. `ahead`: the half with rising along coordinate, seen from the pole.
  Fan(moire::ImageSize size, moire::Pole pole, int lines, bool transposed, bool ahead);

  int wedges() const { return wedges_; }

  // The stretches of wedge `index` that overlap image columns x0 .. x1 - 1; none if `out.shares` comes back empty.
  void stretches(int index, int x0, int x1, Stretches& out) const;

 private:
  // The across coordinate at `along` of the line that meets the reference line at `c`.
  double across(double c, double along) const { return c + (along - reference_) * slope(c); }
  double slope(double c) const { return (pole_across_ - c * pole_w_) / (pole_along_ - reference_ * pole_w_); }

  bool transposed_;
  double pole_across_, pole_along_, pole_w_;
  int across_size_, along_size_;
  int lines_;
  double apex_;                  // along coordinate of the pole; infinite where the wedges are parallel
  double low_ = 0, high_ = 0;    // the fan's part of the along axis
  double reference_ = 0;         // along coordinate where wedges are 1 / lines wide
  double start_ = 0, step_ = 0;  // wedge i lies between start + i step and start + (i + 1) step there
  int wedges_ = 0;
  bool rising_ = true;  // elevation rises with the along coordinate
};

// All fans that an image needs.
std::vector<Fan> fans(moire::ImageSize size, moire::Pole pole, int lines);

}  // namespace area
