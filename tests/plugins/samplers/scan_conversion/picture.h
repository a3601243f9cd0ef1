// What was put on a small canvas, and how often.
#pragma once

#include <cstdint>
#include <random>
#include <vector>

#include "pixels.h"

namespace moire::test {

class Picture {
 public:
  explicit Picture(PixelArea area)
      : area_(area),
        intensity_(static_cast<std::size_t>(area.width) * static_cast<std::size_t>(area.height)),
        times_(intensity_.size()) {}

  // A pixel put twice has the sum of its intensities; one outside is only counted.
  void operator()(int x, int y, std::uint32_t intensity) {
    if (!scan_conversion::holds(area_, x, y)) {
      outside += intensity > 0 ? 1 : 0;
      return;
    }
    intensity_[place(x, y)] += intensity;
    again += ++times_[place(x, y)] > 1 ? 1 : 0;
    sum += intensity;
  }

  // 0 outside.
  std::uint32_t at(std::int64_t x, std::int64_t y) const {
    if (!scan_conversion::holds(area_, x, y)) return 0;
    return intensity_[place(static_cast<int>(x), static_cast<int>(y))];
  }
  const PixelArea& area() const { return area_; }

  // Calls visit(x, y) for all pixels.
  template <class Visit>
  void for_each_pixel(Visit visit) const {
    for (int y = area_.y0; y < area_.y0 + area_.height; ++y) {
      for (int x = area_.x0; x < area_.x0 + area_.width; ++x) visit(x, y);
    }
  }
  // How many pixels of `part` differ from those here.
  int differences(const Picture& part) const {
    int count = 0;
    part.for_each_pixel([&](int x, int y) { count += at(x, y) != part.at(x, y) ? 1 : 0; });
    return count;
  }

  int again = 0;    // times a pixel was put that had been put before
  int outside = 0;  // pixels lit outside of the area
  std::uint64_t sum = 0;

 private:
  std::size_t place(int x, int y) const {
    return static_cast<std::size_t>(y - area_.y0) * static_cast<std::size_t>(area_.width) +
           static_cast<std::size_t>(x - area_.x0);
  }

  PixelArea area_;
  std::vector<std::uint32_t> intensity_;
  std::vector<int> times_;
};

// Numbers of a seed, the same everywhere.
class Numbers {
 public:
  explicit Numbers(std::uint64_t seed) : engine_(seed) {}
  // In [low, high).
  double real(double low, double high) { return low + (high - low) * (static_cast<double>(engine_() >> 11) * 0x1p-53); }
  // low .. high.
  std::int64_t integer(std::int64_t low, std::int64_t high) {
    return low + static_cast<std::int64_t>(engine_() % static_cast<std::uint64_t>(high - low + 1));
  }

 private:
  std::mt19937_64 engine_;
};

}  // namespace moire::test
