// What is seen along straight lines of the image.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include <moire/frame.h>

#include "drawing/outlines.h"
#include "edges.h"

namespace cartoon {

// Along part of a line one layer is on top.
struct LineRun {
  double begin, end;    // distances from the line's beginning, in pixels
  std::uint32_t layer;  // or Stack::empty
};

// Cuts lines at the edges of the drawing. Edges that a line only touches, or lies on, cut it as if it passed on their
// one side: always the same.
class LineCutter {
 public:
  LineCutter(const Outlines& outlines, std::span<const moire::Point> points, const Edges& edges)
      : outlines_(outlines), points_(points), edges_(edges) {}

  // The runs from `begin` to `end`, one after another, no two of one layer side by side. Valid until the next call.
  std::span<const LineRun> runs(moire::Point from, moire::Point to, double begin, double end);

 private:
  struct Meeting {
    double at;
    std::uint32_t layer;
    std::int16_t turn, inside;
  };

  void meet_upright(double x, double y, double direction);
  void meet_slanted(moire::Point from, moire::Point to);

  const Outlines& outlines_;
  std::span<const moire::Point> points_;
  const Edges& edges_;
  std::vector<Meeting> meetings_;
  std::vector<LineRun> runs_;
};

}  // namespace cartoon
