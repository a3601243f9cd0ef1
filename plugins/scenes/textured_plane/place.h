// Coordinates that keep their digits.
#pragma once

#include <cmath>
#include <cstdint>

namespace textured_plane {

// A place on one of the texture's axes as its whole part and the rest, so that places near the camera keep their digits
// however far from the texture's corner it stands.
struct Place {
  explicit Place(double coordinate)
      : whole(static_cast<std::int64_t>(std::floor(coordinate))), rest(coordinate - std::floor(coordinate)) {}

  // How far texel i's lower edge lies above this place.
  double to(std::int64_t i) const { return static_cast<double>(i - whole) - rest; }
  // The texel so far above this place.
  std::int64_t texel(double distance) const { return whole + static_cast<std::int64_t>(std::floor(rest + distance)); }

  std::int64_t whole;
  double rest;  // 0 .. 1
};

}  // namespace textured_plane
