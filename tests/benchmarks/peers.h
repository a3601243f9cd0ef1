// What people draw flat polygons with today, to be measured against: Cairo and the Anti-Grain Geometry, where they are
// installed. They blend numbers as stored and layer over layer, so their pixels are wrong where layers meet.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include <moire/frame.h>

namespace moire::benchmark {

// Layers from back to front, as renderers take them.
struct PaintedLayer {
  Color color;  // code values
  FillRule rule;
  std::vector<std::vector<Point>> contours;
};
std::vector<PaintedLayer> painted_layers(const Frame& frame);

class Peer {
 public:
  virtual ~Peer() = default;
  virtual std::string name() const = 0;
  // Clears and draws all layers, from paths made beforehand.
  virtual void draw() = 0;
  // Code values 0 .. 255 of a channel of a pixel; 0 red, 1 green, 2 blue.
  virtual int code(int x, int y, int channel) const = 0;
};

// All that were found when the benchmark was built.
std::vector<std::unique_ptr<Peer>> peers(const std::vector<PaintedLayer>& layers, Color background, ImageSize size);

}  // namespace moire::benchmark
