#include "support/polygon_frame.h"

#include <algorithm>

namespace moire::test {

namespace {

int winding(const std::vector<std::vector<Point>>& contours, const Affine& map, double x, double y) {
  int result = 0;
  for (const auto& contour : contours) {
    for (std::size_t k = 0; k < contour.size(); ++k) {
      const Point p = map(contour[k]), q = map(contour[(k + 1) % contour.size()]);
      if ((p.y <= y) == (q.y <= y)) continue;
      if (p.x + (y - p.y) * (q.x - p.x) / (q.y - p.y) <= x) result += p.y < q.y ? 1 : -1;
    }
  }
  return result;
}

}  // namespace

void PolygonFrame::trace(std::span<const SamplePoint> points, std::span<Hit> hits, Counters& counters) const {
  for (std::size_t k = 0; k < points.size(); ++k) {
    const auto front = std::find_if(polygons_.begin(), polygons_.end(), [&](const FlatPolygon& polygon) {
      const int number = winding(polygon.contours, placement_, points[k].x, points[k].y);
      return polygon.rule == FillRule::nonzero ? number != 0 : number % 2 != 0;
    });
    hits[k] = front == polygons_.end() ? Hit{background, background_} : Hit{front->element, front->color};
    ++counters.queries;
  }
}

void PolygonFrame::stream(const Rectangle&, PolygonSink& sink) const { stream(sink, placement_); }

void PolygonFrame::stream(PolygonSink& sink, const Affine& map) const {
  for (const FlatPolygon& polygon : polygons_) {
    std::vector<Point> points;
    std::vector<std::uint32_t> contours;
    for (const auto& contour : polygon.contours) {
      contours.push_back(static_cast<std::uint32_t>(points.size()));
      for (const Point p : contour) points.push_back(map(p));
    }
    sink.polygon({polygon.element, polygon.color, polygon.rule, points, contours});
  }
}

}  // namespace moire::test
