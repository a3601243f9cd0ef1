// A sampler that draws curves pixel by pixel, one over the other.
#pragma once

#include <memory>

#include "covers.h"
#include "drawing.h"

namespace scan_conversion {

// Draws a frame by a method of drawing: made from the sampler's settings and the frame's drawing, it has
//   full()                      the intensity that covers a pixel
//   draw(stroke, area, put)     puts the pixels of the area that the stroke lights, each once
template <class Method>
class ScanConversion final : public moire::Rendering {
 public:
  template <class Choices>
  ScanConversion(const Choices& choices, const moire::Curves& curves) : drawing_(curves), method_(choices, drawing_) {}

  void render(moire::PixelBlock& block) const override {
    const moire::PixelArea area = block;
    Covers covers(block, method_.full());
    drawing_.for_each_near(area, [&](std::uint32_t k) {
      method_.draw(drawing_.strokes()[k], area, [&](int x, int y, std::uint32_t i) { covers.add(x, y, k, i); });
    });
    covers.deposit(block, drawing_.background(),
                   [this](std::uint32_t k) -> const Stroke& { return drawing_.strokes()[k]; });
    block.counters.queries += block.slots();
  }
  moire::Blocks blocks() const override { return moire::Blocks::rows; }

 private:
  Drawing drawing_;
  Method method_;
};

template <class Method>
class ScanConverter final : public moire::Sampler {
 public:
  using Choices = typename Method::Choices;

  explicit ScanConverter(const Choices& choices) : choices_(choices) {}

  std::unique_ptr<moire::Rendering> begin(const moire::RenderRequest& request) const override {
    return std::make_unique<ScanConversion<Method>>(choices_, *request.frame.curves());
  }

 private:
  Choices choices_;
};

// The pixel and the circle that rounded curves have.
inline PixelCircle rounded_circle(const Stroke& circle) {
  return {pixel_of(circle.center), whole(circle.radius + 0.5)};
}

}  // namespace scan_conversion
