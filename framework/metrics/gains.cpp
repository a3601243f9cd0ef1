#include "metrics/gains.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <set>
#include <utility>

namespace moire {

namespace {

using Complex = std::complex<double>;
using Bin = std::pair<long, long>;

// The bin of the picture's discrete transform, if the frequency is one.
std::optional<Bin> bin_of(const Sinusoid& wave, ImageSize size) {
  const double x = wave.fx * size.width, y = wave.fy * size.height;
  if (std::abs(x - std::round(x)) > 1e-6 || std::abs(y - std::round(y)) > 1e-6) return std::nullopt;
  const auto within = [](long k, long n) { return ((k % n) + n) % n; };
  return Bin{within(std::lround(x), size.width), within(std::lround(y), size.height)};
}

Bin mirrored(const Bin& bin, ImageSize size) {
  return {(size.width - bin.first) % size.width, (size.height - bin.second) % size.height};
}

bool can_be_told_apart(std::span<const Sinusoid> waves, ImageSize size) {
  std::set<Bin> taken;
  for (const Sinusoid& wave : waves) {
    const auto bin = bin_of(wave, size);
    // A bin that is its own mirror holds a real number: the phase is lost.
    if (!bin || *bin == mirrored(*bin, size)) return false;
    if (!taken.insert(*bin).second || !taken.insert(mirrored(*bin, size)).second) return false;
  }
  return true;
}

// exp(-2 pi i f (m + 1/2)) for m = 0 .. count - 1.
std::vector<Complex> conjugate_wave(double frequency, int count) {
  std::vector<Complex> wave;
  for (int m = 0; m < count; ++m) {
    const double cycles = frequency * (m + 0.5);
    wave.push_back(std::polar(1.0, -2 * std::numbers::pi * (cycles - std::floor(cycles))));
  }
  return wave;
}

}  // namespace

bool is_in_band(const Sinusoid& wave) { return std::max(std::abs(wave.fx), std::abs(wave.fy)) < 0.5; }

double folded(double frequency) { return frequency - std::floor(frequency + 0.5); }

std::vector<Complex> gains(const Picture& picture, std::span<const Sinusoid> waves) {
  if (!can_be_told_apart(waves, picture.size)) return {};
  std::vector<Complex> result;
  const double pixels = static_cast<double>(picture.pixels.size());
  for (const Sinusoid& wave : waves) {
    const auto across = conjugate_wave(wave.fx, picture.size.width),
               down = conjugate_wave(wave.fy, picture.size.height);
    const Color* pixel = picture.pixels.data();
    Complex sum = 0;
    for (const Complex& of_row : down) {
      Complex row = 0;
      for (const Complex& of_column : across) {
        row += of_column * ((static_cast<double>(pixel->r) + pixel->g + pixel->b) / 3);
        ++pixel;
      }
      sum += of_row * row;
    }
    result.push_back(2 / (wave.amplitude * pixels) * sum * std::polar(1.0, -wave.phase));
  }
  return result;
}

}  // namespace moire
