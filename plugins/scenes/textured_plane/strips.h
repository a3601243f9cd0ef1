// The exact average of every pixel where the texture's axes run along and across a view without roll.
#pragma once

#include <cstdint>
#include <vector>

#include <moire/tally.h>

#include "level_view.h"
#include "surroundings.h"
#include "texels.h"

namespace textured_plane {

// Lines of texels across the view are level strips of the picture. On one of them the place of the image point (u, k)
// is X = X0 + b u / W, W linear in k, so that the integral of the colour over u is (W / b) F(X), F that of the line.
// Where X is no whole number this is linear in k: trapezoids between the places where it is one are exact. Done once
// at every edge between two pixel columns, this takes time in proportion to the strips and to the texels that the edge
// passes through, not to all texels. Rows with few texels a pixel, and textures that are clamped, add up texel by texel
// instead: there F would be large beside what is made of it.
class Strips {
 public:
  // Requires: view.is_aligned(); both outlive this.
  Strips(const View& view, const Texels& texels, const Surroundings& surroundings);

  // As moire::Averages::integrate; rounding is all there is.
  void integrate(moire::PixelBlock& block) const;

 private:
  struct Strip;
  // Calls visit(strip) for each line of texels within a row, from the horizon down; where `clamped`, with all lines
  // that repeat the texture's first or last one as one.
  template <class Visit>
  void for_each_strip(const LevelView::Row& row, bool clamped, Visit visit) const;
  // Calls visit(x, i, area) for the texels of a strip in pixels x = 0 .. width - 1 from x0 on: i along the line,
  // unwrapped; where `clamped`, within the texture.
  template <class Visit>
  void for_each_texel(const Strip& strip, int x0, int width, bool clamped, Visit visit) const;

  moire::Hit texel(const Strip& strip, std::int64_t i) const;
  bool takes_sums(const LevelView::Row& row) const;
  // Adds the colours of a row's near part to the sums of its pixels.
  void add_by_sums(const LevelView::Row& row, int x0, std::vector<moire::Tally::Sum>& pixels) const;
  void add_by_texels(const LevelView::Row& row, int x0, std::vector<moire::Tally::Sum>& pixels) const;
  // Twice the integral of W F(X) over the strip at u pixels from the middle.
  LineSums::Node edge(const Strip& strip, double u) const;

  LevelView view_;
  const Texels& texels_;
  Surroundings surroundings_;
  const LineSums* sums_;   // null where clamped
  double origin_ = 0;      // where on the first period of a line's sums the camera is, its whole part
  double per_period_ = 0;  // 1 / period
};

}  // namespace textured_plane
