// A sampler whose points a test writes down.
#pragma once

#include <functional>
#include <utility>

#include <moire/sampler.h>

namespace moire::test {

// The same points in every pixel.
class Pattern final : public PointSampler {
 public:
  explicit Pattern(std::vector<Points::Entry> points) : points_(std::move(points)) {}
  void points(const Pixel&, Points& out) const override {
    ++asked;
    for (const Points::Entry& p : points_) {
      p.light ? out.add_lit(p.x, p.y, *p.light) : out.add(p.x, p.y, p.weight);
    }
  }
  bool same_in_every_pixel() const override { return true; }

  mutable int asked = 0;

 private:
  std::vector<Points::Entry> points_;
};

// Points that depend on the pixel.
class Changing final : public PointSampler {
 public:
  explicit Changing(std::function<void(const Pixel&, Points&)> body) : body_(std::move(body)) {}
  void points(const Pixel& pixel, Points& out) const override { body_(pixel, out); }

 private:
  std::function<void(const Pixel&, Points&)> body_;
};

}  // namespace moire::test
