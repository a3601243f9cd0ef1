// Catmull's pixel integrator: of polygons in depth order, how much of each is visible in a pixel.
//
// All polygons are clipped against an edge of the foremost one into two lists, and each list is integrated in the same
// way, until all edges of the foremost polygon have been clipped against: then it fills its cell and hides the rest
// (Catmull 1978, "The pixel integrater").
#pragma once

#include <cstdint>
#include <vector>

namespace area {

class PixelIntegrator {
 public:
  // A vertex in the pixel's own coordinates, and whether the edge from it to the next vertex has been clipped against.
  struct Vertex {
    double x, y;
    bool is_clipped;
  };
  struct Visible {
    std::uint32_t layer;
    double area;
  };

  void clear();
  // The next polygon, behind those before it: vertices that lie in 0 .. 1, in either direction.
  void begin_polygon(std::uint32_t layer);
  void vertex(double x, double y) { vertices_.push_back({x, y, false}); }
  // Behind all others: a polygon that covers the pixel.
  void solid(std::uint32_t layer);

  // What is visible, in the order it was found; the areas sum to 1. A layer may come more than once.
  const std::vector<Visible>& integrate();

 private:
  struct Polygon {
    std::uint32_t layer;
    std::size_t begin, end;  // vertices
  };
  struct Line {
    double x, y, dx, dy;
    // On which side a point is, and how far times the line's length: exactly 0 at both of the edge's ends.
    double side(const Vertex& v) const { return dx * (v.y - y) - dy * (v.x - x); }
  };

  void integrate(std::size_t first, std::size_t end);
  void clip(std::size_t first, std::size_t end, const Line& line, double sign);
  void clip(const Polygon& polygon, const Line& line, double sign);
  double area(const Polygon& polygon) const;
  std::size_t next(const Polygon& polygon, std::size_t vertex) const {
    return vertex + 1 < polygon.end ? vertex + 1 : polygon.begin;
  }
  // Where the first edge begins that has not been clipped against; polygon.end: there is none.
  std::size_t first_unclipped(const Polygon& polygon) const;

  // Lists of inner calls follow those of outer ones.
  std::vector<Vertex> vertices_;
  std::vector<Polygon> polygons_;
  std::vector<Visible> visible_;
};

}  // namespace area
