#include "metrics/picture.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <cstring>

namespace moire {

namespace {

// Four at a time: three vectors.
void fill(Color* pixels, std::size_t count, Color color) {
  const std::array<Color, 4> four{color, color, color, color};
  for (; count >= four.size(); count -= four.size(), pixels += four.size())
    std::memcpy(pixels, four.data(), sizeof four);
  std::fill_n(pixels, count, color);
}

// color_of(slot) is asked once for each slot outside of runs. Row by row whatever the block's order: tiles that read a
// column's cache lines whole are slower, since they write to several rows in turn.
template <class ColorOf>
void copy(const PixelBlock& block, Picture& picture, ColorOf color_of) {
  const auto stride = static_cast<std::size_t>(picture.size.width);
  const auto width = static_cast<std::size_t>(block.width), height = static_cast<std::size_t>(block.height);
  const std::size_t across = block.across(), down = block.down();
  Color* row = picture.pixels.data() + static_cast<std::size_t>(block.y0) * stride + static_cast<std::size_t>(block.x0);
  auto run = block.runs().begin();
  for (std::size_t y = 0; y < height; ++y, row += stride) {
    for (std::size_t x = 0; x < width;) {
      const std::size_t slot = y * down + x * across;
      if (run != block.runs().end() && run->first == slot) {
        fill(row + x, run->count, block.light(run->color));
        x += run->count;
        ++run;
        continue;
      }
      const std::size_t end = run == block.runs().end() ? width : std::min(width, x + (run->first - slot));
      for (std::size_t k = slot; x < end; ++x, k += across) row[x] = color_of(k);
    }
  }
}

// Pixels' colours by their sums: the curve is slow, and drawings have large areas of few colours.
class KnownColors {
 public:
  explicit KnownColors(const PixelBlock& block) : block_(block) {}

  Color of(std::size_t slot) {
    const Tally::Sum& sum = block_.sum(slot);
    const std::uint64_t bits = std::bit_cast<std::uint64_t>(sum.r) + 3 * std::bit_cast<std::uint64_t>(sum.g) +
                               5 * std::bit_cast<std::uint64_t>(sum.b);
    Entry& entry = entries_[((bits ^ bits >> 32) * 0x9e3779b97f4a7c15U) >> (64 - log_size)];
    if (entry.sum != sum) entry = {sum, block_.color(slot)};
    return entry.color;
  }

 private:
  static constexpr int log_size = 8;
  struct Entry {
    Tally::Sum sum;  // at first without weight, which is black
    Color color;
  };
  const PixelBlock& block_;
  std::array<Entry, 1 << log_size> entries_;
};

}  // namespace

void put(const PixelBlock& block, Picture& picture) {
  if (block.blend() == Blend::linear) {
    copy(block, picture, [&](std::size_t slot) -> Color {
      const Tally::Sum& s = block.sum(slot);
      if (s.weight != 1) return block.Tally::color(slot);
      return {static_cast<float>(s.r), static_cast<float>(s.g), static_cast<float>(s.b)};
    });
  } else {
    KnownColors known(block);
    copy(block, picture, [&](std::size_t slot) { return known.of(slot); });
  }
}

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
