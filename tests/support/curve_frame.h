// A frame of given lines and circles.
#pragma once

#include <variant>
#include <vector>

#include <moire/frame.h>

namespace moire::test {

using Curve = std::variant<LineCurve, CircleCurve>;

// Curves from back to front. Traced, a line is the rectangle about it with its cap, a circle its annulus.
class CurveFrame final : public Frame, private Curves {
 public:
  CurveFrame(ImageSize size, std::vector<Curve> curves, Color background = {}, Blend blend = Blend::linear)
      : size_(size), curves_(std::move(curves)), background_(background), blend_(blend) {}

  ImageSize size() const override { return size_; }
  Blend blend() const override { return blend_; }
  // The foremost curve whose area holds the point.
  void trace(std::span<const SamplePoint> points, std::span<Hit> hits, Counters& counters) const override;
  const Curves* curves() const override { return this; }

 private:
  void stream(CurveSink& sink) const override;
  Color background_color() const override { return background_; }

  ImageSize size_;
  std::vector<Curve> curves_;
  Color background_;
  Blend blend_;
};

}  // namespace moire::test
