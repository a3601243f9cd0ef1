// Pictures of known frequencies, made by evaluating their sinusoids in double.
#pragma once

#include <cmath>
#include <numbers>
#include <vector>

#include <moire/frame.h>
#include <moire/random.h>

#include "metrics/picture.h"

namespace moire::test {

// A frame that knows its spectrum and answers no other question.
class KnownFrame final : public Frame, private Spectrum {
 public:
  KnownFrame(ImageSize size, std::vector<Sinusoid> waves) : size_(size), waves_(std::move(waves)) {}
  ImageSize size() const override { return size_; }
  void trace(std::span<const SamplePoint>, std::span<Hit>, Counters&) const override {}
  const Spectrum* spectrum() const override { return this; }

 private:
  std::span<const Sinusoid> sinusoids() const override { return waves_; }
  ImageSize size_;
  std::vector<Sinusoid> waves_;
};

inline double sinc(double x) {
  const double angle = std::numbers::pi * x;
  return angle == 0 ? 1 : std::sin(angle) / angle;
}

// 1/2 + sum of gain(wave) times the wave, seen at pixel (x, y) moved by (dx, dy).
template <class Gain>
double value_at(double x, double y, const std::vector<Sinusoid>& waves, Gain gain) {
  double sum = 0.5;
  for (const Sinusoid& w : waves)
    sum += gain(w) * w.amplitude * std::cos(2 * std::numbers::pi * (w.fx * x + w.fy * y) + w.phase);
  return sum;
}

template <class Gain>
Picture picture_of(ImageSize size, const std::vector<Sinusoid>& waves, Gain gain) {
  Picture picture{size, {}};
  for (int y = 0; y < size.height; ++y) {
    for (int x = 0; x < size.width; ++x) {
      const auto grey = static_cast<float>(value_at(x + 0.5, y + 0.5, waves, gain));
      picture.pixels.push_back({grey, grey, grey});
    }
  }
  return picture;
}

}  // namespace moire::test
