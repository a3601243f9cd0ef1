#include "exact/overlay.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "exact/rows.h"

namespace area {

namespace {

// Rows that the polygons are cut into to resolve them: about as many as a picture has.
constexpr double rows_at_most = 1024;

// A sink of Rows that joins the parts of an edge that show the same layers on both sides.
class Joiner {
 public:
  Joiner(std::size_t edges, std::vector<Overlay::Boundary>& out)
      : latest_(edges, std::numeric_limits<std::uint32_t>::max()), out_(out) {}

  void begin_row(int y) { top_ = y; }
  void open(double, std::uint32_t) {}
  void close(double) {}
  void end_row(std::uint32_t) {}
  void boundary(double x0, double y0, double x1, double y1, std::uint32_t left, std::uint32_t right,
                std::uint32_t edge) {
    const moire::Point upper{x0, top_ + y0}, lower{x1, top_ + y1};
    std::uint32_t& latest = latest_[edge];
    if (latest < out_.size()) {
      Overlay::Boundary& b = out_[latest];
      if (b.left == left && b.right == right && b.lower == upper) {
        b.lower = lower;
        return;
      }
    }
    latest = static_cast<std::uint32_t>(out_.size());
    out_.push_back({upper, lower, left, right});
  }

 private:
  double top_ = 0;
  std::vector<std::uint32_t> latest_;  // the last boundary on each edge
  std::vector<Overlay::Boundary>& out_;
};

moire::Rectangle extent_of(const Layers& layers) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  moire::Rectangle extent{infinity, infinity, -infinity, -infinity};
  for (std::size_t k = 0; k < layers.point_count(); ++k) {
    const moire::Point p = layers.points()[k];
    extent = {std::min(extent.x0, p.x), std::min(extent.y0, p.y), std::max(extent.x1, p.x), std::max(extent.y1, p.y)};
  }
  return extent;
}

}  // namespace

Overlay::Overlay(Layers layers) : layers_(std::move(layers)) {
  if (layers_.point_count() == 0) return;
  const moire::Rectangle extent = extent_of(layers_);
  const double height = extent.y1 - extent.y0;
  if (!(height > 0)) return;
  // By a power of two and whole rows, so that hardly a coordinate is rounded.
  const double scale = std::exp2(std::floor(std::log2(rows_at_most / height)));
  const moire::Affine to_rows{scale, 0, 1 - std::floor(extent.x0 * scale), 0, scale, -std::floor(extent.y0 * scale)};
  Layers scaled = layers_;
  scaled.map(to_rows);
  const double right = std::ceil(extent.x1 * scale) + to_rows.x0 + 1;
  const int rows = static_cast<int>(std::floor(extent.y1 * scale) + to_rows.y0) + 1;

  const Chains chains(scaled, rows, right);
  Joiner joiner(chains.point_count(), boundaries_);
  Rows(scaled, chains, right, joiner).sweep(0, rows);
  // As buckets of rows want them.
  std::stable_sort(boundaries_.begin(), boundaries_.end(),
                   [](const Boundary& a, const Boundary& b) { return a.upper.y < b.upper.y; });
  for (Boundary& b : boundaries_) {
    for (moire::Point* p : {&b.upper, &b.lower}) *p = {(p->x - to_rows.x0) / scale, (p->y - to_rows.y0) / scale};
  }
}

}  // namespace area
