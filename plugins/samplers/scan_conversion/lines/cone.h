// How much of a line of width 1 a pixel sees through a cone of radius 1 pixel and volume 1 about its middle, as tables.
// After Gupta, Sproull 1981, doi:10.1145/800224.806783; the integrals are our own.
#pragma once

#include <array>
#include <cstdint>

namespace scan_conversion {

// The cone's share of the half-strip |y - across| <= 1/2, x >= -along: of a line that begins `along` behind the pixel's
// middle, whose axis passes it at `across`; both in pixels. Along >= 1: of a line without an end. To 1e-5, 1 / 400 of a
// level.
double cone_share(double along, double across);

class Cone {
 public:
  static constexpr int entries = 64;    // over 0 <= |across| < reach, and over -1 <= along < 1
  static constexpr double reach = 1.5;  // nothing beyond: half the line's width, and the cone's radius
  static constexpr std::uint32_t full = 255;

  // Computed once a process.
  static const Cone& tables();

  // Of a line without ends near. Requires: 0 <= across <= reach.
  std::uint32_t within_reach(double across) const {
    return strip_[static_cast<std::size_t>(static_cast<int>(across * (entries / reach)))];
  }
  // Requires: 0 <= across.
  std::uint32_t endless(double across) const { return within_reach(across < reach ? across : reach); }
  // Of a line that ends `before` pixels behind and `after` pixels ahead of the pixel.
  std::uint32_t between(double before, double after, double across) const;

 private:
  Cone();
  // Of 255, not rounded.
  double half(double along, double across) const;

  std::array<std::uint8_t, entries + 1> strip_{};
  std::array<std::array<double, entries>, entries> ends_{};
};

}  // namespace scan_conversion
