#include "painted_layers.h"

#include <algorithm>

namespace outside {

namespace {

class Collector final : public moire::PolygonSink {
 public:
  explicit Collector(moire::Blend blend) : blend_(blend) {}

  void polygon(const moire::Polygon& polygon) override {
    PaintedLayer& layer = layers.emplace_back(PaintedLayer{codes_of(polygon.color, blend_), polygon.rule, {}});
    for (std::size_t k = 0; k < polygon.contours.size(); ++k) {
      const std::size_t end = k + 1 < polygon.contours.size() ? polygon.contours[k + 1] : polygon.points.size();
      layer.contours.emplace_back(polygon.points.begin() + polygon.contours[k],
                                  polygon.points.begin() + static_cast<std::ptrdiff_t>(end));
    }
  }
  std::vector<PaintedLayer> layers;

 private:
  moire::Blend blend_;
};

}  // namespace

Painting painting_of(const moire::Frame& frame) {
  const moire::ImageSize size = frame.size();
  Collector collector(frame.blend());
  frame.polygons()->stream({0, 0, static_cast<double>(size.width), static_cast<double>(size.height)}, collector);
  std::reverse(collector.layers.begin(), collector.layers.end());
  return {size, codes_of(frame.polygons()->background_color(), frame.blend()), std::move(collector.layers)};
}

moire::Color codes_of(moire::Color c, moire::Blend blend) {
  if (blend == moire::Blend::as_stored) return c;
  const auto code = [](float light) { return static_cast<float>(moire::linear_to_srgb(light)); };
  return {code(c.r), code(c.g), code(c.b)};
}

moire::Color of_codes(moire::Color c, moire::Blend blend) {
  if (blend == moire::Blend::as_stored) return c;
  const auto light = [](float code) { return static_cast<float>(moire::srgb_to_linear(code)); };
  return {light(c.r), light(c.g), light(c.b)};
}

}  // namespace outside
