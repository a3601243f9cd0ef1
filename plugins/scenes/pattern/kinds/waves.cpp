// Sums of sinusoids.
#include <array>
#include <mutex>
#include <optional>

#include "frame.h"
#include "kinds/kinds.h"
#include "weights/cosine.h"

namespace pattern {

namespace {

// The waves along one axis, by wave and then by pixel's middle: the real and imaginary part of e^(2 pi i f x).
class Table {
 public:
  Table(std::span<const double> frequencies, int pixels) : pixels_(static_cast<std::size_t>(pixels)) {
    cosines_.reserve(frequencies.size() * pixels_);
    sines_.reserve(frequencies.size() * pixels_);
    for (const double f : frequencies) {
      for (int k = 0; k < pixels; ++k) {
        cosines_.push_back(cosine(f * (k + 0.5)));
        sines_.push_back(cosine(f * (k + 0.5) - 0.25));
      }
    }
  }
  const double* cosines(std::size_t wave, int pixel) const { return &cosines_[wave * pixels_] + pixel; }
  const double* sines(std::size_t wave, int pixel) const { return &sines_[wave * pixels_] + pixel; }

 private:
  std::size_t pixels_;
  std::vector<double> cosines_, sines_;
};

class Waves final : public PatternFrame<Waves>, private moire::Spectrum {
 public:
  Waves(const Look& look, double mean, std::vector<moire::Sinusoid> waves)
      : PatternFrame(look), mean_(mean), waves_(std::move(waves)) {}

  const moire::Spectrum* spectrum() const override { return this; }
  std::span<const moire::Sinusoid> sinusoids() const override { return waves_; }

  void see(std::span<const moire::SamplePoint> points, std::span<moire::Hit> hits) const {
    constexpr std::size_t most = 64;
    for (std::size_t first = 0; first < points.size(); first += most) {
      const std::size_t count = std::min(most, points.size() - first);
      std::array<double, most> greys, x, y;
      for (std::size_t k = 0; k < count; ++k) greys[k] = mean_, x[k] = points[first + k].x, y[k] = points[first + k].y;
      for (const moire::Sinusoid& wave : waves_) {
        const double cycles = wave.phase / (2 * std::numbers::pi);
        for (std::size_t k = 0; k < count; ++k)
          greys[k] += wave.amplitude * cosine(wave.fx * x[k] + wave.fy * y[k] + cycles);
      }
      for (std::size_t k = 0; k < count; ++k) hits[first + k] = {part(0), look().greys.mix(greys[k])};
    }
  }

 private:
  // The value in the pixel's middle, times what the filter leaves of each wave.
  double integrate(const moire::Filter* filter, moire::PixelBlock& block) const override {
    std::call_once(once_, [this] {
      std::vector<double> fx, fy;
      for (const moire::Sinusoid& wave : waves_) fx.push_back(wave.fx), fy.push_back(wave.fy);
      columns_.emplace(fx, look().size.width);
      rows_.emplace(fy, look().size.height);
    });
    std::vector<moire::Point> left;  // of each wave: the factors of the real and of the imaginary part
    for (const moire::Sinusoid& wave : waves_) {
      const double amplitude = wave.amplitude * transfer(filter, wave.fx) * transfer(filter, wave.fy);
      left.push_back({amplitude * std::cos(wave.phase), amplitude * std::sin(wave.phase)});
    }
    std::vector<double> greys(static_cast<std::size_t>(block.height));
    int column = block.x0 - 1;
    fill(block, [&](int x, int y, auto deposit) {
      if (x != column) sum_column(column = x, block.y0, left, greys);
      deposit(part(0), 1, look().greys.mix(greys[static_cast<std::size_t>(y - block.y0)]));
    });
    return 0;
  }

  static double transfer(const moire::Filter* filter, double frequency) {
    if (filter) return filter->transfer(frequency);
    const double angle = std::numbers::pi * frequency;
    return angle == 0 ? 1 : std::sin(angle) / angle;
  }

  // Of column x, from row y0 on. Four waves at once, to read and write the sums less often.
  void sum_column(int x, int y0, std::span<const moire::Point> left, std::span<double> greys) const {
    std::fill(greys.begin(), greys.end(), mean_);
    std::size_t k = 0;
    for (; k + 4 <= waves_.size(); k += 4) add_waves<4>(k, x, y0, left, greys);
    for (; k < waves_.size(); ++k) add_waves<1>(k, x, y0, left, greys);
  }
  template <std::size_t count>
  void add_waves(std::size_t first, int x, int y0, std::span<const moire::Point> left, std::span<double> greys) const {
    std::array<const double*, count> cosines, sines;
    std::array<double, count> real, imaginary;
    for (std::size_t k = 0; k < count; ++k) {
      const double c = *columns_->cosines(first + k, x), s = *columns_->sines(first + k, x);
      const moire::Point w = left[first + k];
      real[k] = w.x * c - w.y * s, imaginary[k] = w.x * s + w.y * c;
      cosines[k] = rows_->cosines(first + k, y0), sines[k] = rows_->sines(first + k, y0);
    }
    for (std::size_t y = 0; y < greys.size(); ++y) {
      double sum = greys[y];
      for (std::size_t k = 0; k < count; ++k) sum += real[k] * cosines[k][y] - imaginary[k] * sines[k][y];
      greys[y] = sum;
    }
  }

  double mean_;
  std::vector<moire::Sinusoid> waves_;
  mutable std::once_flag once_;
  mutable std::optional<Table> columns_, rows_;
};

}  // namespace

std::unique_ptr<moire::Frame> make_waves(const Look& look, double mean, std::vector<moire::Sinusoid> waves) {
  return std::make_unique<Waves>(look, mean, std::move(waves));
}

}  // namespace pattern
