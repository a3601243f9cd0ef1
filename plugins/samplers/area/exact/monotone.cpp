#include "exact/monotone.h"

#include <algorithm>
#include <utility>

namespace area {

namespace {

struct Edge {
  moire::Point upper, lower;
  int direction;

  double x(double y) const {
    if (y == upper.y) return upper.x;
    if (y == lower.y) return lower.x;
    return upper.x + (y - upper.y) * ((lower.x - upper.x) / (lower.y - upper.y));
  }
};

// One layer, cut into bands in which no edge begins, ends or crosses another.
class Decomposition {
 public:
  Decomposition(const Layers& layers, std::uint32_t layer, int rows, std::vector<MonotonePolygon>& out)
      : rule_(layers[layer]), layer_(layer), rows_(rows), out_(out) {}

  void add(const moire::Point* points, const Layers::Contour& contour) {
    for (std::uint32_t k = contour.first; k < contour.end; ++k) {
      const moire::Point p = points[k], q = points[k + 1 < contour.end ? k + 1 : contour.first];
      if (p.y == q.y) continue;
      edges_.push_back(p.y < q.y ? Edge{p, q, 1} : Edge{q, p, -1});
    }
  }

  void run() {
    std::vector<double> ys;
    for (const Edge& e : edges_) {
      ys.push_back(e.upper.y);
      ys.push_back(e.lower.y);
    }
    std::sort(ys.begin(), ys.end());
    ys.erase(std::unique(ys.begin(), ys.end()), ys.end());
    std::sort(edges_.begin(), edges_.end(), [](const Edge& a, const Edge& b) { return a.upper.y < b.upper.y; });

    std::size_t next = 0;
    for (std::size_t k = 0; k + 1 < ys.size(); ++k) {
      std::erase_if(active_, [&](const Edge* e) { return e->lower.y <= ys[k]; });
      for (; next < edges_.size() && edges_[next].upper.y <= ys[k]; ++next) active_.push_back(&edges_[next]);
      if (ys[k + 1] > 0 && ys[k] < rows_) bands(ys[k], ys[k + 1]);
    }
    close_all();
  }

 private:
  // A polygon whose lower end may go on in the next band.
  struct Open {
    MonotonePolygon polygon;
    const Edge *left, *right;  // the last on its sides
  };

  // Bands between y0 and y1, where only crossings divide.
  void bands(double y0, double y1) {
    while (y0 < y1) {
      std::sort(active_.begin(), active_.end(), [&](const Edge* a, const Edge* b) {
        const double xa = a->x(y0), xb = b->x(y0);
        return xa < xb || (xa == xb && a->x(y1) < b->x(y1));
      });
      double end = y1;
      for (std::size_t k = 1; k < active_.size();) {
        const Edge &p = *active_[k - 1], &q = *active_[k];
        const double above = q.x(y0) - p.x(y0), below = q.x(y1) - p.x(y1);
        const double y = below < 0 ? y0 + above / (above - below) * (y1 - y0) : y1;
        if (y <= y0) {
          // They cross at y0 but for rounding, so that they are already the other way round.
          std::swap(active_[k - 1], active_[k]);
          k = std::max<std::size_t>(k, 2) - 1;
        } else {
          end = std::min(end, y);
          ++k;
        }
      }
      band(y0, end);
      y0 = end;
    }
  }

  // The spans of a band, each going on with a polygon that ended as wide as it begins, or beginning one.
  void band(double y0, double y1) {
    std::sort(active_.begin(), active_.end(),
              [&](const Edge* a, const Edge* b) { return a->x(y0) + a->x(y1) < b->x(y0) + b->x(y1); });
    std::vector<Open> spans;
    int winding = 0;
    const Edge* left = nullptr;
    for (const Edge* e : active_) {
      const bool was = rule_.is_inside(winding);
      winding += e->direction;
      const bool is = rule_.is_inside(winding);
      if (is && !was) left = e;
      if (was && !is) spans.push_back(span(left, e, y0, y1));
    }
    close_all();
    open_ = std::move(spans);
  }

  Open span(const Edge* left, const Edge* right, double y0, double y1) {
    const moire::Point l{left->x(y0), y0}, r{right->x(y0), y0};
    const auto upper = std::find_if(open_.begin(), open_.end(), [&](const Open& o) {
      return !o.polygon.left.empty() && o.polygon.left.back() == l && o.polygon.right.back() == r;
    });
    if (upper == open_.end()) return {{layer_, {l, {left->x(y1), y1}}, {r, {right->x(y1), y1}}}, left, right};
    Open result = std::move(*upper);
    upper->polygon.left.clear();
    // Nothing bends where an edge goes on.
    if (result.left == left) result.polygon.left.pop_back();
    if (result.right == right) result.polygon.right.pop_back();
    result.polygon.left.push_back({left->x(y1), y1});
    result.polygon.right.push_back({right->x(y1), y1});
    result.left = left;
    result.right = right;
    return result;
  }

  void close_all() {
    for (Open& o : open_) {
      if (!o.polygon.left.empty()) out_.push_back(std::move(o.polygon));
    }
    open_.clear();
  }

  const Layer& rule_;
  const std::uint32_t layer_;
  const int rows_;
  std::vector<MonotonePolygon>& out_;
  std::vector<Edge> edges_;
  std::vector<const Edge*> active_;
  std::vector<Open> open_;
};

}  // namespace

std::vector<MonotonePolygon> monotone_polygons(const Layers& layers, int rows) {
  std::vector<MonotonePolygon> result;
  const auto& contours = layers.contours();
  for (std::size_t first = 0; first < contours.size();) {
    const std::uint32_t layer = contours[first].layer;
    Decomposition decomposition(layers, layer, rows, result);
    for (; first < contours.size() && contours[first].layer == layer; ++first)
      decomposition.add(layers.points(), contours[first]);
    decomposition.run();
  }
  return result;
}

}  // namespace area
