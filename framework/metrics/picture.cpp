#include "metrics/picture.h"

#include <cmath>

namespace moire {

std::vector<double> differences(const Picture& picture, const Picture& reference, Space space) {
  const auto value = [space](float light) { return space == Space::linear ? light : linear_to_srgb(light); };
  std::vector<double> result;
  result.reserve(3 * picture.pixels.size());
  for (std::size_t k = 0; k < picture.pixels.size(); ++k) {
    const Color a = picture.pixels[k], b = reference.pixels[k];
    for (double difference : {value(a.r) - value(b.r), value(a.g) - value(b.g), value(a.b) - value(b.b)}) {
      result.push_back(levels_of_full_scale * difference);
    }
  }
  return result;
}

double root_mean_square(std::span<const double> differences) {
  double sum = 0;
  for (double d : differences) sum += d * d;
  return std::sqrt(sum / static_cast<double>(differences.size()));
}

}  // namespace moire
