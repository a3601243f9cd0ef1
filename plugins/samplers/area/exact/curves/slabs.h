// What is visible in a pixel where curves meet, exactly.
//
// The pixel is cut into slabs at every height where something happens: boundaries cross, circles begin and end or cross
// the pixel's sides. Within a slab boundaries keep their order, so that each has the area to its left in closed form,
// and what lies between two neighbours belongs to the foremost cover there. A crossing that rounding hides leaves
// boundaries in the wrong order where they are no farther apart than rounding errors; a height too many costs time
// alone.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "exact/curves/local_shapes.h"

namespace area {

class Slabs {
 public:
  // Forgets all covers.
  void clear();

  // A cover is where a point lies in all half-planes and in the disk, and not in the hole; several covers may be one
  // layer. Covers come front to back. Requires: layers count up from 0.
  void begin_cover(std::uint32_t layer);
  void half_plane(const HalfPlane& side) { lines_.push_back({side, 0, 0}), covers_.back().lines_end = lines_.size(); }
  void disk(const LocalDisk& disk) { arcs_.push_back({disk, 1}), covers_.back().arcs_end = arcs_.size(); }
  void hole(const LocalDisk& disk) { arcs_.push_back({disk, -1}), covers_.back().arcs_end = arcs_.size(); }

  // Of each layer what is visible in the unit square, and behind the last what no cover hides. The sum is 1.
  const std::vector<double>& integrate(std::size_t layers);

 private:
  // A line through the square: x = x0 + slope y, unless it is level.
  struct Line {
    HalfPlane side;
    double x0, slope;
    bool is_level() const { return side.a == 0; }
  };
  struct Arc {
    LocalDisk disk;
    int sign;  // 1: within the circle, -1: beyond it
  };
  struct Cover {
    std::uint32_t layer;
    std::size_t lines, lines_end, arcs, arcs_end;
    int needed;  // so many of its conditions hold where it is

    std::size_t size() const { return (lines_end - lines) + (arcs_end - arcs); }
  };
  // A part of the square, itself a square.
  struct Box {
    double x, y, side;
  };
  enum class Edge { line, left_arc, right_arc };
  // A boundary in a slab: the area to its left, and what is counted on crossing it to the right.
  struct Strand {
    double area;
    std::size_t piece;
    std::uint32_t cover;
    int step;
    Edge edge;
    bool is_there = true;
  };

  void integrate(std::size_t first, std::size_t end, double area, int depth);
  // Appends what matters of the covers [first, end) in the box, as it sees them.
  void look_at(const Box& box, std::size_t first, std::size_t end);
  void cut(std::size_t first, std::size_t end, double area);
  static bool is_order_seen(double x, const Line& one, const Line& other);
  void find_events(std::size_t first, std::size_t end);
  void line_events(const Line& line, const Arc& arc);
  void arc_events(const Arc& one, const Arc& other);
  void event(double y) {
    if (y > 0 && y < 1) events_.push_back(y);
  }
  void slab(std::size_t first, std::size_t end, double top, double bottom, double area);
  void find_strands(std::size_t first, std::size_t end);
  std::optional<double> left_of(const Strand& strand, double top, double bottom) const;

  std::vector<Line> lines_;
  std::vector<Arc> arcs_;
  std::vector<Cover> covers_;
  std::vector<double> events_, areas_;
  std::vector<Strand> strands_;
  std::vector<int> start_, counts_;  // of each cover, how many of its conditions hold left of all strands, and now
};

}  // namespace area
