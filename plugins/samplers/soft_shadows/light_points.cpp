#include "light_points.h"

#include <array>

#include <moire/jitter.h>
#include <moire/lattice.h>

namespace soft_shadows {

Pattern pattern_of(std::string_view name) {
  constexpr std::array all{Pattern::lattice, Pattern::grid, Pattern::jittered, Pattern::random, Pattern::rotated};
  std::size_t which = 0;
  for (std::string_view rest = patterns; !rest.starts_with(name); rest.remove_prefix(rest.find(' ') + 1)) ++which;
  return all[which];
}

std::vector<moire::LightPoint> light_points(Pattern pattern, std::uint32_t n, const moire::Pixel& key) {
  const std::uint32_t count = n * n;
  const auto side = std::int64_t{n};
  const double u = moire::random(key, count, 0), v = moire::random(key, count, 1);
  std::vector<moire::LightPoint> points;
  points.reserve(count);
  const auto cell = [&](std::uint32_t k, double amount) {
    const auto place = [&](std::uint32_t at, std::uint32_t axis) {
      return moire::fraction(moire::jittered(at, side, amount, moire::random(key, k, axis)));
    };
    points.push_back({place(k % n, 0), place(k / n, 1)});
  };
  for (std::uint32_t k = 0; k < count; ++k) {
    switch (pattern) {
      case Pattern::lattice:
        points.push_back(moire::fibonacci_lattice(k, count));
        break;
      case Pattern::grid:
        cell(k, 0);
        break;
      case Pattern::jittered:
        cell(k, 1);
        break;
      case Pattern::random:
        points.push_back({moire::fraction(moire::random(key, k, 0)), moire::fraction(moire::random(key, k, 1))});
        break;
      case Pattern::rotated:
        points.push_back(moire::r2_lattice(u, v, k));
        break;
    }
  }
  return points;
}

}  // namespace soft_shadows
