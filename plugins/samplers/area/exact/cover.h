// Which layers cover a place, and the foremost of them.
#pragma once

#include <algorithm>
#include <bit>
#include <cstdint>
#include <limits>
#include <vector>

namespace area {

// A set of layers in words of 64 bits, above them words that say which words below are not empty, and so on: to change
// it and to find its first layer takes a step a level, however many layers there are.
class Cover {
 public:
  // Empty but for the background, the last layer, which stays.
  explicit Cover(std::uint32_t layers) {
    for (std::uint32_t size = layers; levels_.empty() || size > 1;) {
      size = (size + 63) / 64;
      levels_.emplace_back(size, 0);
    }
    insert(layers - 1);
  }

  void insert(std::uint32_t layer) {
    front_ = std::min(front_, layer);
    for (auto& words : levels_) {
      words[layer / 64] |= std::uint64_t{1} << (layer % 64);
      layer /= 64;
    }
  }
  void erase(std::uint32_t layer) {
    std::uint32_t place = layer;
    for (auto& words : levels_) {
      std::uint64_t& word = words[place / 64];
      word &= ~(std::uint64_t{1} << (place % 64));
      if (word != 0) break;
      place /= 64;
    }
    if (layer == front_) front_ = find_front();
  }

  std::uint32_t front() const { return front_; }

 private:
  std::uint32_t find_front() const {
    std::uint32_t layer = 0;
    for (auto words = levels_.rbegin(); words != levels_.rend(); ++words)
      layer = layer * 64 + static_cast<std::uint32_t>(std::countr_zero((*words)[layer]));
    return layer;
  }

  std::vector<std::vector<std::uint64_t>> levels_;  // the layers themselves first
  std::uint32_t front_ = std::numeric_limits<std::uint32_t>::max();
};

}  // namespace area
