#include "plugins/cartoon/brute_force.h"

#include <algorithm>

#include <moire/random.h>

#include "drawing/pen.h"

namespace moire::test {

namespace {

// Twice the area of the triangle a, b, c; positive if c lies to the left of a to b, y upward.
std::int64_t turn(Site a, Site b, Site c) { return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x); }

bool lies_on(Site site, Site a, Site b) {
  return turn(a, b, site) == 0 && std::min(a.x, b.x) <= site.x && site.x <= std::max(a.x, b.x) &&
         std::min(a.y, b.y) <= site.y && site.y <= std::max(a.y, b.y);
}

std::vector<Element> elements_of(const std::vector<Hit>& hits) {
  std::vector<Element> elements;
  for (const Hit& hit : hits) elements.push_back(hit.element);
  return elements;
}

}  // namespace

cartoon::Drawing LatticeDrawing::drawing() const {
  cartoon::Drawing result;
  cartoon::Pen pen(result);
  for (std::size_t k = 0; k < layers.size(); ++k) {
    for (const std::vector<Site>& contour : layers[k].contours) {
      for (std::size_t i = 0; i < contour.size(); ++i) {
        const Point p{static_cast<double>(contour[i].x) / steps, static_cast<double>(contour[i].y) / steps};
        i == 0 ? pen.move_to(p) : pen.line_to(p);
      }
      pen.close();
    }
    pen.finish({static_cast<std::uint8_t>(k), static_cast<std::uint8_t>(k >> 8), 77}, layers[k].rule);
  }
  return result;
}

LatticeDrawing random_drawing(int layers, int corners, ImageSize size, std::uint64_t seed) {
  LatticeDrawing drawing;
  for (int k = 0; k < layers; ++k) {
    LatticeLayer layer;
    const auto draw = [&](int i, std::uint32_t dimension) {
      return random({.x = k, .y = i, .seed = seed}, 0, dimension);
    };
    layer.rule = draw(0, 0) < 0.5 ? FillRule::nonzero : FillRule::even_odd;
    layer.contours.resize(1 + static_cast<std::size_t>(3 * draw(0, 1)));
    int i = 0;
    for (std::vector<Site>& contour : layer.contours) {
      // Some are small, so that the layers below are seen.
      const double share = draw(i, 2) < 0.5 ? 1.2 : 0.3;
      const double left = (1.2 - share) * draw(i, 3) - 0.1, top = (1.2 - share) * draw(i, 4) - 0.1;
      for (int c = 0; c < corners; ++c, ++i) {
        const std::int64_t coarse = i % 3 == 0 ? LatticeDrawing::steps : 1;
        const auto place = [&](double low, int extent, std::uint32_t dimension) {
          const double at = (low + share * draw(i, dimension)) * extent * LatticeDrawing::steps;
          return static_cast<std::int64_t>(at) / coarse * coarse;
        };
        contour.push_back({place(left, size.width, 5), place(top, size.height, 6)});
      }
    }
    drawing.layers.push_back(std::move(layer));
  }
  return drawing;
}

std::optional<Element> seen_at(const LatticeDrawing& drawing, Site site) {
  Element seen = background;
  for (std::size_t k = 0; k < drawing.layers.size(); ++k) {
    std::int64_t winding = 0;
    for (const std::vector<Site>& contour : drawing.layers[k].contours) {
      for (std::size_t i = 0; i < contour.size(); ++i) {
        const Site a = contour[i], b = contour[(i + 1) % contour.size()];
        if (lies_on(site, a, b)) return std::nullopt;
        if (a.y <= site.y && b.y > site.y && turn(a, b, site) > 0) ++winding;
        if (b.y <= site.y && a.y > site.y && turn(a, b, site) < 0) --winding;
      }
    }
    if (drawing.layers[k].rule == FillRule::nonzero ? winding != 0 : winding % 2 != 0) seen = k + 1;
  }
  return seen;
}

std::unique_ptr<Frame> frame_of(const cartoon::Drawing& drawing, ImageSize size) {
  auto outlines = std::make_shared<const cartoon::Outlines>(drawing, 0.01, Blend::linear);
  return std::make_unique<cartoon::CartoonFrame>(std::move(outlines), Affine{}, size, Color{1, 1, 1}, Blend::linear);
}

std::vector<Element> one_by_one(const Frame& frame, std::span<const SamplePoint> points) {
  std::vector<Hit> hits(points.size());
  Counters counters;
  for (std::size_t k = 0; k < points.size(); ++k) {
    frame.trace(points.subspan(k, 1), std::span(hits).subspan(k, 1), counters);
  }
  return elements_of(hits);
}

std::vector<Element> together(const Frame& frame, std::span<const SamplePoint> points) {
  std::vector<Hit> hits(points.size());
  Counters counters;
  frame.trace(points, hits, counters);
  return elements_of(hits);
}

}  // namespace moire::test
