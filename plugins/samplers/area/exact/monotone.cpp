#include "exact/monotone.h"

#include <algorithm>
#include <utility>

#include "exact/path.h"

namespace area {

namespace {

struct Edge {
  moire::Point upper, lower;
  int direction;

  double x(double y) const { return y == upper.y ? upper.x : x_at(upper, lower, y); }
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
  // An edge where a band begins and ends.
  struct Side {
    const Edge* edge;
    double above, below;
  };

  // Bands between y0 and y1, where only crossings divide.
  void bands(double y0, double y1) {
    sides_.clear();
    for (const Edge* e : active_) sides_.push_back({e, e->x(y0), e->x(y1)});
    while (true) {
      const double end = first_crossing(y0, y1);
      if (end == y1) return band(y0, y1);
      for (Side& side : sides_) side.below = side.edge->x(end);
      band(y0, end);
      y0 = end;
      for (Side& side : sides_) side = {side.edge, side.below, side.edge->x(y1)};
    }
  }

  // Where neighbours first cross between y0 and y1; y1: nowhere.
  double first_crossing(double y0, double y1) {
    std::sort(sides_.begin(), sides_.end(), [](const Side& a, const Side& b) {
      return a.above < b.above || (a.above == b.above && a.below < b.below);
    });
    double end = y1;
    for (std::size_t k = 1; k < sides_.size();) {
      const Side &p = sides_[k - 1], &q = sides_[k];
      const double above = q.above - p.above, below = q.below - p.below;
      const double y = below < 0 ? y0 + above / (above - below) * (y1 - y0) : y1;
      if (y <= y0) {
        // They cross at y0 but for rounding, so that they are already the other way round.
        std::swap(sides_[k - 1], sides_[k]);
        k = std::max<std::size_t>(k, 2) - 1;
      } else {
        end = std::min(end, y);
        ++k;
      }
    }
    return end;
  }

  // The spans of a band, each going on with a polygon that ended as wide as it begins, or beginning one.
  void band(double y0, double y1) {
    std::sort(sides_.begin(), sides_.end(),
              [](const Side& a, const Side& b) { return a.above + a.below < b.above + b.below; });
    std::vector<Open> spans = std::move(spare_);
    int winding = 0;
    const Side* left = nullptr;
    for (const Side& side : sides_) {
      const bool was = rule_.is_inside(winding);
      winding += side.edge->direction;
      const bool is = rule_.is_inside(winding);
      if (is && !was) left = &side;
      if (was && !is) spans.push_back(span(*left, side, y0, y1));
    }
    close_all();
    spare_ = std::exchange(open_, std::move(spans));
  }

  Open span(const Side& left, const Side& right, double y0, double y1) {
    const moire::Point l{left.above, y0}, r{right.above, y0};
    const auto upper = std::find_if(open_.begin(), open_.end(), [&](const Open& o) {
      return !o.polygon.left.empty() && o.polygon.left.back() == l && o.polygon.right.back() == r;
    });
    if (upper == open_.end()) return {{layer_, {l, {left.below, y1}}, {r, {right.below, y1}}}, left.edge, right.edge};
    Open result = std::move(*upper);
    upper->polygon.left.clear();
    // Nothing bends where an edge goes on.
    if (result.left == left.edge) result.polygon.left.pop_back();
    if (result.right == right.edge) result.polygon.right.pop_back();
    result.polygon.left.push_back({left.below, y1});
    result.polygon.right.push_back({right.below, y1});
    result.left = left.edge;
    result.right = right.edge;
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
  std::vector<Side> sides_;  // of a band
  std::vector<Open> open_, spare_;
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
