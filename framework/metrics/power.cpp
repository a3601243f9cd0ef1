#include "metrics/power.h"

#include <cmath>
#include <complex>
#include <cstddef>

#include <unsupported/Eigen/FFT>

#include "metrics/gains.h"

namespace moire {

std::vector<double> power_spectrum(std::span<const double> values, ImageSize size) {
  using Complex = std::complex<double>;
  const auto width = static_cast<std::size_t>(size.width), height = static_cast<std::size_t>(size.height);
  Eigen::FFT<double> fft;
  std::vector<Complex> all(values.begin(), values.end()), line, transformed;
  const auto transform = [&](std::size_t first, std::size_t step, std::size_t count) {
    line.resize(count);
    for (std::size_t k = 0; k < count; ++k) line[k] = all[first + k * step];
    fft.fwd(transformed, line);
    for (std::size_t k = 0; k < count; ++k) all[first + k * step] = transformed[k];
  };
  // kissfft does not take a transform of one.
  if (width > 1) {
    for (std::size_t y = 0; y < height; ++y) transform(y * width, 1, width);
  }
  if (height > 1) {
    for (std::size_t x = 0; x < width; ++x) transform(x, width, height);
  }
  std::vector<double> power;
  for (const Complex& bin : all) power.push_back(std::norm(bin) / static_cast<double>(all.size()));
  return power;
}

std::vector<Point> radial_mean(std::span<const double> power, ImageSize size, int rings) {
  std::vector<double> sums(static_cast<std::size_t>(rings));
  std::vector<std::size_t> counts(sums.size());
  std::size_t bin = 0;
  for (int v = 0; v < size.height; ++v) {
    for (int u = 0; u < size.width; ++u, ++bin) {
      const double frequency =
          std::hypot(folded(static_cast<double>(u) / size.width), folded(static_cast<double>(v) / size.height));
      const auto ring = static_cast<std::size_t>(frequency * 2 * rings);
      if (bin == 0 || ring >= sums.size()) continue;
      sums[ring] += power[bin];
      ++counts[ring];
    }
  }
  std::vector<Point> result;
  for (std::size_t ring = 0; ring < sums.size(); ++ring) {
    if (counts[ring] == 0) continue;
    result.push_back({(static_cast<double>(ring) + 0.5) / (2 * rings), sums[ring] / static_cast<double>(counts[ring])});
  }
  return result;
}

}  // namespace moire
