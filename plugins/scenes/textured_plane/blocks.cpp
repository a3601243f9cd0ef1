#include "blocks.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace textured_plane {

namespace {

// What is known of a block while the next level is made from it.
struct Moments {
  double count;
  double mean[3], low[3], high[3], variance[3];
};

// Not below `value`.
float rounded_up(double value) {
  return value > 0 ? std::nextafter(static_cast<float>(value), std::numeric_limits<float>::infinity()) : 0;
}

Moments merged(const std::vector<const Moments*>& parts) {
  Moments all{};
  for (const Moments* part : parts) all.count += part->count;
  for (int c = 0; c < 3; ++c) {
    all.low[c] = parts.front()->low[c];
    all.high[c] = parts.front()->high[c];
    for (const Moments* part : parts) {
      all.mean[c] += part->count * part->mean[c];
      all.low[c] = std::min(all.low[c], part->low[c]);
      all.high[c] = std::max(all.high[c], part->high[c]);
    }
    all.mean[c] /= all.count;
    for (const Moments* part : parts) {
      const double apart = part->mean[c] - all.mean[c];
      all.variance[c] += part->count / all.count * (part->variance[c] + apart * apart);
    }
  }
  return all;
}

Blocks::Block block_of(const Moments& m) {
  Blocks::Block block{{m.mean[0], m.mean[1], m.mean[2]}, 0, 0};
  for (int c = 0; c < 3; ++c) {
    block.deviation = std::max(block.deviation, rounded_up(std::max(m.high[c] - m.mean[c], m.mean[c] - m.low[c])));
    block.spread = std::max(block.spread, rounded_up(std::sqrt(m.variance[c])));
  }
  return block;
}

}  // namespace

Blocks::Blocks(const float* rgba, int width, int height) {
  std::vector<Moments> fine;
  fine.reserve(static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
  for (std::size_t k = 0; k < static_cast<std::size_t>(width) * static_cast<std::size_t>(height); ++k) {
    Moments texel{.count = 1, .mean = {}, .low = {}, .high = {}, .variance = {}};
    for (std::size_t c = 0; c < 3; ++c) texel.mean[c] = texel.low[c] = texel.high[c] = rgba[4 * k + c];
    fine.push_back(texel);
  }
  for (;;) {
    Level level{width, height, {}};
    level.blocks.reserve(fine.size());
    for (const Moments& m : fine) level.blocks.push_back(block_of(m));
    levels_.push_back(std::move(level));
    if (width == 1 && height == 1) return;

    const int columns = (width + 1) / 2, rows = (height + 1) / 2;
    std::vector<Moments> coarse;
    coarse.reserve(static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows));
    for (int j = 0; j < rows; ++j) {
      for (int i = 0; i < columns; ++i) {
        std::vector<const Moments*> parts;
        for (int y = 2 * j; y < std::min(2 * j + 2, height); ++y) {
          for (int x = 2 * i; x < std::min(2 * i + 2, width); ++x) {
            parts.push_back(
                &fine[static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x)]);
          }
        }
        coarse.push_back(merged(parts));
      }
    }
    fine = std::move(coarse);
    width = columns;
    height = rows;
  }
}

}  // namespace textured_plane
