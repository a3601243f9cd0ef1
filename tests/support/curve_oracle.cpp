#include "support/curve_oracle.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace moire::test {

namespace {

using Number = long double;
struct Span {
  Number from, to;
};
using Spans = std::vector<Span>;
using Lengths = std::vector<Number>;

struct Corner {
  Number x, y;
};

// Curves as seen from a pixel's corner.
class Rows {
 public:
  Rows(std::span<const Curve> curves, int x, int y) : curves_(curves), x_(x), y_(y) {}

  // Of each curve, and the background, the length that is visible along the row at height y.
  Lengths visible(Number y) const {
    Lengths lengths(curves_.size() + 1, 0);
    Spans free{{0, 1}};
    for (std::size_t k = curves_.size(); k-- > 0 && !free.empty();) {
      for (const Span& cover : std::visit([&](const auto& curve) { return spans(curve, y); }, curves_[k])) {
        Spans rest;
        for (const Span& span : free) {
          const Number from = std::max(span.from, cover.from), to = std::min(span.to, cover.to);
          if (from >= to) {
            rest.push_back(span);
            continue;
          }
          lengths[k] += to - from;
          if (span.from < from) rest.push_back({span.from, from});
          if (to < span.to) rest.push_back({to, span.to});
        }
        free = std::move(rest);
      }
    }
    for (const Span& span : free) lengths.back() += span.to - span.from;
    return lengths;
  }

  // Where shapes begin and end, and where circles come nearest to lines and to each other: there a touch is short.
  std::vector<Number> heights() const {
    std::vector<Number> all;
    std::vector<Corner> centers, directions;
    std::vector<Number> radii;
    const auto disk = [&](Point center, Number radius) {
      centers.push_back({center.x - x_, center.y - y_});
      radii.push_back(radius);
      directions.push_back({0, 1});
    };
    for (const Curve& curve : curves_) {
      if (const auto* line = std::get_if<LineCurve>(&curve)) {
        const std::vector<Corner> outline = corners(*line);
        for (const Corner& corner : outline) all.push_back(corner.y);
        if (!outline.empty()) {
          directions.push_back({outline[1].x - outline[0].x, outline[1].y - outline[0].y});
          directions.push_back({directions.back().y, -directions.back().x});
        }
        if (line->cap == Cap::round) disk(line->from, line->width / 2.0L), disk(line->to, line->width / 2.0L);
      } else {
        const auto& circle = std::get<CircleCurve>(curve);
        disk(circle.center, circle.radius + circle.width / 2.0L);
        disk(circle.center, std::max(circle.radius - circle.width / 2.0L, 0.0L));
      }
    }
    for (std::size_t k = 0; k < centers.size(); ++k) {
      const auto at = [&](const Corner& direction) {
        const Number length = std::hypot(direction.x, direction.y);
        if (length == 0) return;
        all.push_back(centers[k].y + radii[k] * direction.y / length);
        all.push_back(centers[k].y - radii[k] * direction.y / length);
      };
      for (const Corner& direction : directions) at(direction);
      for (const Corner& center : centers) at({center.x - centers[k].x, center.y - centers[k].y});
    }
    return all;
  }

 private:
  std::vector<Corner> corners(const LineCurve& line) const {
    const Number x0 = line.from.x - x_, y0 = line.from.y - y_, x1 = line.to.x - x_, y1 = line.to.y - y_;
    Number dx = x1 - x0, dy = y1 - y0;
    const Number length = std::sqrt(dx * dx + dy * dy), half = line.width / 2.0L;
    if (length == 0 && line.cap != Cap::square) return {};
    dx = length == 0 ? half : half * dx / length, dy = length == 0 ? 0 : half * dy / length;
    const Number out = line.cap == Cap::square ? 1 : 0;
    return {{x0 - out * dx - dy, y0 - out * dy + dx},
            {x1 + out * dx - dy, y1 + out * dy + dx},
            {x1 + out * dx + dy, y1 + out * dy - dx},
            {x0 - out * dx + dy, y0 - out * dy - dx}};
  }

  Spans disk(Point center, Number radius, Number y) const {
    const Number down = y - (center.y - y_);
    if (!(std::abs(down) < radius)) return {};
    const Number half = std::sqrt((radius - down) * (radius + down)), middle = center.x - x_;
    return {{middle - half, middle + half}};
  }

  Spans spans(const LineCurve& line, Number y) const {
    Spans all;
    const std::vector<Corner> outline = corners(line);
    Number from = 1e30L, to = -1e30L;
    for (std::size_t k = 0; k < outline.size(); ++k) {
      const Corner &p = outline[k], &q = outline[(k + 1) % outline.size()];
      if ((p.y <= y) == (q.y <= y)) continue;
      const Number at = p.x + (y - p.y) * ((q.x - p.x) / (q.y - p.y));
      from = std::min(from, at), to = std::max(to, at);
    }
    if (from < to) all.push_back({from, to});
    if (line.cap == Cap::round) {
      for (const Point end : {line.from, line.to}) {
        for (const Span& span : disk(end, line.width / 2.0L, y)) all.push_back(span);
      }
    }
    return all;
  }

  Spans spans(const CircleCurve& circle, Number y) const {
    if (!(circle.width > 0)) return {};
    const Spans outer = disk(circle.center, circle.radius + circle.width / 2.0L, y);
    const Spans inner = disk(circle.center, circle.radius - circle.width / 2.0L, y);
    if (outer.empty() || inner.empty()) return outer;
    return {{outer[0].from, inner[0].from}, {inner[0].to, outer[0].to}};
  }

  std::span<const Curve> curves_;
  Number x_, y_;
};

// Lobatto's rule of five points. It has one at either end, so that no bend beside an end goes unseen.
Lengths rule(const Rows& rows, Number top, Number bottom) {
  static const Number places[]{0, std::sqrt(3 / 7.0L), 1};
  static const Number weights[]{32 / 45.0L, 49 / 90.0L, 1 / 10.0L};
  const Number middle = (top + bottom) / 2, half = (bottom - top) / 2;
  Lengths sum;
  const auto add = [&](Number place, Number weight) {
    const Lengths lengths = rows.visible(middle + half * place);
    sum.resize(lengths.size(), 0);
    for (std::size_t k = 0; k < sum.size(); ++k) sum[k] += half * weight * lengths[k];
  };
  add(0, weights[0]);
  for (int k : {1, 2}) add(places[k], weights[k]), add(-places[k], weights[k]);
  return sum;
}

// `agreed`: so did the halves that this is one of. Once alone may be chance.
void integrate(const Rows& rows, Number top, Number bottom, const Lengths& whole, bool agreed, Lengths& sum) {
  const Number middle = (top + bottom) / 2;
  const Lengths upper = rule(rows, top, middle), lower = rule(rows, middle, bottom);
  Number difference = 0;
  for (std::size_t k = 0; k < whole.size(); ++k)
    difference = std::max(difference, std::abs(upper[k] + lower[k] - whole[k]));
  const bool agree = difference <= 1e-16L;
  if ((agree && agreed) || bottom - top < 0x1p-50L) {
    for (std::size_t k = 0; k < whole.size(); ++k) sum[k] += upper[k] + lower[k];
    return;
  }
  integrate(rows, top, middle, upper, agree, sum);
  integrate(rows, middle, bottom, lower, agree, sum);
}

}  // namespace

std::vector<double> visible_areas(std::span<const Curve> curves, int x, int y) {
  const Rows rows(curves, x, y);
  std::vector<Number> heights = rows.heights();
  for (int k = 0; k <= 8; ++k) heights.push_back(k / 8.0L);
  for (Number& height : heights) height = std::clamp(height, 0.0L, 1.0L);
  std::sort(heights.begin(), heights.end());
  Lengths sum(curves.size() + 1, 0);
  for (std::size_t k = 0; k + 1 < heights.size(); ++k) {
    if (heights[k] < heights[k + 1])
      integrate(rows, heights[k], heights[k + 1], rule(rows, heights[k], heights[k + 1]), false, sum);
  }
  return {sum.begin(), sum.end()};
}

}  // namespace moire::test
