// Sums of sinusoids.
#include <array>
#include <mutex>
#include <optional>
#include <type_traits>

#include "frame.h"
#include "kinds/kinds.h"
#include "weights/cosine.h"

namespace pattern {

namespace {

// The waves along one axis, by wave and then by pixel: the real and imaginary part of e^(2 pi i f x), x the distance
// of a pixel's middle from the axis' origin, `first` that of the first.
class Table {
 public:
  Table(std::span<const double> frequencies, double first, int pixels) : pixels_(static_cast<std::size_t>(pixels)) {
    cosines_.reserve(frequencies.size() * pixels_);
    sines_.reserve(frequencies.size() * pixels_);
    for (const double f : frequencies) {
      for (int k = 0; k < pixels; ++k) {
        cosines_.push_back(cosine(f * (first + k)));
        sines_.push_back(cosine(f * (first + k) - 0.25));
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
  // Sums over waves run down a column.
  moire::Blocks blocks() const override { return moire::Blocks::columns; }

  // The value in the pixel's middle, times what the filter leaves of each wave. About the image's middle row every wave
  // is the sum of an even and an odd function of y, and rows that lie opposite share both.
  double integrate(const moire::Filter* filter, moire::PixelBlock& block) const override {
    std::call_once(once_, [this] { make_tables(); });
    const std::vector<moire::Point> left = left_by(filter);
    const int last = look().size.height - 1;
    const auto folded = [last](int y) { return std::min(y, last - y); };
    // The rows of the upper half that the block needs: its own, or those opposite.
    const int bottom = block.y0 + block.height - 1, y0 = std::min(folded(block.y0), folded(bottom));
    const bool meets_middle = block.y0 <= last / 2 && bottom >= last / 2;
    const int y1 = meets_middle ? last / 2 : std::max(folded(block.y0), folded(bottom));
    const auto rows = static_cast<std::size_t>(y1 - y0 + 1);
    std::vector<double> even(static_cast<std::size_t>(block.width) * rows, mean_), odd(even.size(), 0);  // by column
    const auto first_of = [&](int x) { return static_cast<std::size_t>(x - block.x0) * rows; };
    // Four waves at once, so that sums are read and written less often; all columns of these, whose table of rows
    // then stays at hand.
    const auto add = [&]<std::size_t count>(std::size_t wave, std::integral_constant<std::size_t, count>) {
      for (int x = block.x0; x < block.x0 + block.width; ++x)
        add_waves<count>(wave, left, x, y0, rows, &even[first_of(x)], &odd[first_of(x)]);
    };
    std::size_t k = 0;
    for (; k + 4 <= waves_.size(); k += 4) add(k, std::integral_constant<std::size_t, 4>());
    for (; k < waves_.size(); ++k) add(k, std::integral_constant<std::size_t, 1>());
    fill(block, [&](int x, int y, auto deposit) {
      const std::size_t place = first_of(x) + static_cast<std::size_t>(folded(y) - y0);
      const double grey = y <= last / 2 ? even[place] + odd[place] : even[place] - odd[place];
      deposit(part(0), 1, look().greys.mix(grey));
    });
    return 0;
  }

  void make_tables() const {
    std::vector<double> fx, fy;
    for (const moire::Sinusoid& wave : waves_) fx.push_back(wave.fx), fy.push_back(wave.fy);
    const moire::ImageSize size = look().size;
    columns_.emplace(fx, 0.5, size.width);
    rows_.emplace(fy, 0.5 - 0.5 * size.height, (size.height + 1) / 2);
  }

  // Of each wave, in the middle of the left border: its amplitude under the filter, times e^(i phase).
  std::vector<moire::Point> left_by(const moire::Filter* filter) const {
    std::vector<moire::Point> left;
    for (const moire::Sinusoid& wave : waves_) {
      const double amplitude = wave.amplitude * transfer(filter, wave.fx) * transfer(filter, wave.fy);
      const double phase = wave.phase + std::numbers::pi * wave.fy * look().size.height;
      left.push_back({amplitude * std::cos(phase), amplitude * std::sin(phase)});
    }
    return left;
  }
  static double transfer(const moire::Filter* filter, double frequency) {
    if (filter) return filter->transfer(frequency);
    const double angle = std::numbers::pi * frequency;
    return angle == 0 ? 1 : std::sin(angle) / angle;
  }

  // Adds waves first .. first + count - 1 to the sums of column x from row y0 on.
  template <std::size_t count>
  void add_waves(std::size_t first, std::span<const moire::Point> left, int x, int y0, std::size_t rows, double* even,
                 double* odd) const {
    std::array<const double*, count> cosines, sines;
    std::array<double, count> real, imaginary;
    for (std::size_t k = 0; k < count; ++k) {
      const double c = *columns_->cosines(first + k, x), s = *columns_->sines(first + k, x);
      const moire::Point w = left[first + k];
      real[k] = w.x * c - w.y * s, imaginary[k] = w.x * s + w.y * c;
      cosines[k] = rows_->cosines(first + k, y0), sines[k] = rows_->sines(first + k, y0);
    }
    const auto add = [rows](double* sums, const auto& tables, const auto& factors) {
      for (std::size_t y = 0; y < rows; ++y) {
        double sum = sums[y];
        for (std::size_t k = 0; k < count; ++k) sum += factors[k] * tables[k][y];
        sums[y] = sum;
      }
    };
    add(even, cosines, real);
    for (double& factor : imaginary) factor = -factor;
    add(odd, sines, imaginary);
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
