#include "exact/disjoint.h"

#include "exact/pixel_areas.h"

namespace area {

namespace {

// What polygons leave of a pixel is background where it is more than their rounding errors: the corners of polygons
// that meet there are the same numbers, so that a pixel's sum is off by some 1e-16 for each of them.
constexpr double least_background = 1e-10;

template <class Add>
class Collector final : public moire::PolygonSink {
 public:
  Collector(moire::PixelBlock& block, Add add) : block_(block), add_(add), areas_(block) {}

  void polygon(const moire::Polygon& polygon) override {
    areas_.of(polygon, [&](int x, int y, double area) {
      add_(block_.slot(x, y), polygon.element, area, polygon.color);
      ++block_.counters.hits;
    });
  }

 private:
  moire::PixelBlock& block_;
  Add add_;
  PixelAreas areas_;
};

}  // namespace

void Disjoint::render(moire::PixelBlock& block) const {
  const moire::Polygons& polygons = *frame_.polygons();
  const moire::Color sky = polygons.background_color();
  block.fill([&](auto add) {
    Collector collector(block, add);
    const double x0 = block.x0, y0 = block.y0;
    polygons.stream({x0, y0, x0 + block.width, y0 + block.height}, collector);
    for (std::size_t slot = 0; slot < block.slots(); ++slot) {
      const double rest = 1 - block.weight(slot);
      if (rest > least_background) add(slot, moire::background, rest, sky);
    }
  });
  block.counters.queries += block.slots();
}

}  // namespace area
