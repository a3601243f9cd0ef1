// The directions of one octant, and their places in the image. An octant has the axes of a walk (walk.h): a direction
// that advances by 1 in p advances by u in q, 0 .. 1, and rises by v.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "camera.h"
#include "walk.h"

namespace heightfield::exact {

struct Vertex {
  double u, v;
  moire::Point at;  // not a number where the direction is beyond the projection's limits
};

// Directions between two azimuths.
struct Wedge {
  double u0, u1;
};

class Projection {
 public:
  Projection(moire::ImageSize size, const Camera& camera, const Plane& axes);

  Vertex vertex(double u, double v) const {
    const double depth = row(depth_, u, v), inverse = 1 / depth;
    const bool within = depth >= least_depth_ && v >= lowest_ * depth && v <= highest_ * depth;
    return {u, v, {within ? row(x_, u, v) * inverse : beyond, row(y_, u, v) * inverse}};
  }
  static bool is_beyond(const Vertex& vertex) { return vertex.at.x != vertex.at.x; }

  // The part of a polygon within the limits: these lie around the image, and keep its places finite.
  void cut(std::span<const Vertex> polygon, std::vector<moire::Point>& out) const;

  // What of a rectangle of the image lies in a wedge: a convex polygon, or nothing.
  std::vector<moire::Point> part_of(const moire::Rectangle& rectangle, const Wedge& wedge) const;
  // The azimuths of a part; those of the nadir and of the zenith point are all.
  Wedge wedge_of(std::span<const moire::Point> part) const;
  // The lowest and the highest v of a part.
  struct Rises {
    double lowest, highest;
  };
  Rises rises_of(std::span<const moire::Point> part) const;
  // No less than the pixels by which a place of that part moves when its u or its v does by 1.
  struct Scale {
    double per_u, per_v;
  };
  Scale scale_of(std::span<const moire::Point> part) const;

 private:
  // A linear form over (1, u, v), or over image points (1, x, y).
  using Form = std::array<double, 3>;
  static constexpr double beyond = std::numeric_limits<double>::quiet_NaN();
  static double row(const Form& form, double a, double b) { return form[0] + form[1] * a + form[2] * b; }
  static double at(const Form& form, moire::Point point) { return row(form, point.x, point.y); }

  Form along_, across_, rise_;  // of the ray through an image point
  Form x_, y_, depth_;          // of a direction: its image point is (x / depth, y / depth)
  double least_depth_ = 0;      // limits
  double lowest_ = 0, highest_ = 0;
};

}  // namespace heightfield::exact
