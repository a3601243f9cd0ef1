#include "exact/integrator.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace area {

namespace {

// Pieces that are smaller are left out.
constexpr double least_area = 1e-18;

}  // namespace

void PixelIntegrator::clear() {
  vertices_.clear();
  polygons_.clear();
  visible_.clear();
}

void PixelIntegrator::begin_polygon(std::uint32_t layer) {
  if (!polygons_.empty()) polygons_.back().end = vertices_.size();
  polygons_.push_back({layer, vertices_.size(), vertices_.size()});
}

void PixelIntegrator::solid(std::uint32_t layer) {
  begin_polygon(layer);
  for (const auto& [x, y] : {std::pair(0.0, 0.0), {0.0, 1.0}, {1.0, 1.0}, {1.0, 0.0}}) vertex(x, y);
  polygons_.back().end = vertices_.size();
}

const std::vector<PixelIntegrator::Visible>& PixelIntegrator::integrate() {
  // Edges on the pixel's own boundary need no clipping.
  for (const Polygon& polygon : polygons_) {
    for (std::size_t k = polygon.begin; k < polygon.end; ++k) {
      const Vertex &p = vertices_[k], &q = vertices_[next(polygon, k)];
      vertices_[k].is_clipped = (p.x == q.x && (p.x == 0 || p.x == 1)) || (p.y == q.y && (p.y == 0 || p.y == 1));
    }
  }
  std::erase_if(polygons_, [&](const Polygon& p) { return p.end - p.begin < 3 || area(p) <= least_area; });
  if (polygons_.size() == 2) {
    const double front = std::min(area(polygons_[0]), 1.0);
    visible_ = {{polygons_[0].layer, front}, {polygons_[1].layer, 1 - front}};
  } else {
    integrate(0, polygons_.size());
  }
  return visible_;
}

// The polygons [first, end): the last one is the cell that the clipping has left of the pixel.
void PixelIntegrator::integrate(std::size_t first, std::size_t end) {
  const double cell = area(polygons_[end - 1]);
  for (; first + 1 < end; ++first) {
    const Polygon front = polygons_[first];
    const std::size_t edge = first_unclipped(front);
    if (edge == front.end) {
      // It fills its cell, or is what rounding has left of one that lies beside it.
      if (area(front) < cell / 2) continue;
      visible_.push_back({front.layer, cell});
      return;
    }
    const Vertex p = vertices_[edge], q = vertices_[next(front, edge)];
    const Line line{p.x, p.y, q.x - p.x, q.y - p.y};
    for (const double sign : {-1.0, 1.0}) {
      const std::size_t base = polygons_.size(), base_vertex = vertices_.size();
      clip(first, end, line, sign);
      if (polygons_.size() > base) integrate(base, polygons_.size());
      polygons_.resize(base);
      vertices_.resize(base_vertex);
    }
    return;
  }
  visible_.push_back({polygons_[first].layer, cell});
}

// Appends what lies on one side of the line of the polygons [first, end), the cell at the end; nothing if that is
// empty.
void PixelIntegrator::clip(std::size_t first, std::size_t end, const Line& line, double sign) {
  const std::size_t base = polygons_.size();
  // The cell first, to see which polygons fill it; it goes to the end of the list.
  clip(Polygon(polygons_[end - 1]), line, sign);
  if (polygons_.size() == base) return;
  const Polygon cell = polygons_.back();
  const double cell_area = area(cell);
  polygons_.pop_back();
  for (std::size_t k = first; k + 1 < end; ++k) {
    const std::size_t before = polygons_.size();
    clip(Polygon(polygons_[k]), line, sign);
    if (polygons_.size() == before) continue;
    if (first_unclipped(polygons_.back()) == polygons_.back().end && area(polygons_.back()) >= cell_area / 2) {
      // All behind it is hidden: it takes the place of the cell.
      polygons_.back() = {polygons_.back().layer, cell.begin, cell.end};
      return;
    }
  }
  polygons_.push_back(cell);
}

void PixelIntegrator::clip(const Polygon& polygon, const Line& line, double sign) {
  const std::size_t begin = vertices_.size();
  const auto keep = [&](Vertex v, bool is_clipped) {
    v.is_clipped = is_clipped;
    vertices_.push_back(v);
  };
  Vertex p = vertices_[polygon.end - 1];
  double before = sign * line.side(p);
  for (std::size_t k = polygon.begin; k < polygon.end; ++k) {
    // The edge from p to q. A vertex on the line is on this side; the edge that follows it lies along the line if the
    // next vertex is on the line or beyond.
    const Vertex q = vertices_[k];
    const double after = sign * line.side(q);
    if (before >= 0) keep(p, p.is_clipped || (before == 0 && after <= 0));
    if ((before > 0 && after < 0) || (before < 0 && after > 0)) {
      const double t = before / (before - after);
      const Vertex crossing{p.x + t * (q.x - p.x), p.y + t * (q.y - p.y), false};
      keep(crossing, before > 0 || p.is_clipped);
    }
    p = q;
    before = after;
  }
  const Polygon part{polygon.layer, begin, vertices_.size()};
  if (part.end - part.begin >= 3 && area(part) > least_area) {
    polygons_.push_back(part);
  } else {
    vertices_.resize(begin);
  }
}

double PixelIntegrator::area(const Polygon& polygon) const {
  const Vertex& origin = vertices_[polygon.begin];
  double twice = 0;
  for (std::size_t k = polygon.begin + 2; k < polygon.end; ++k) {
    const Vertex &p = vertices_[k - 1], &q = vertices_[k];
    twice += (p.x - origin.x) * (q.y - origin.y) - (p.y - origin.y) * (q.x - origin.x);
  }
  return std::abs(twice) / 2;
}

std::size_t PixelIntegrator::first_unclipped(const Polygon& polygon) const {
  std::size_t edge = polygon.begin;
  while (edge < polygon.end) {
    const Vertex &p = vertices_[edge], &q = vertices_[next(polygon, edge)];
    // An edge without length gives no line to clip against.
    if (!p.is_clipped && (p.x != q.x || p.y != q.y)) break;
    ++edge;
  }
  return edge;
}

}  // namespace area
