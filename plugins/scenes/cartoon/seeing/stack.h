// The layers that lie over one another at a place, as it moves over their edges.
#pragma once

#include <bit>
#include <cstdint>
#include <vector>

namespace cartoon {

class Stack {
 public:
  static constexpr std::uint32_t empty = 0xffffffffU;

  // Makes room for so many layers, at least one. Requires: the stack is clear.
  void reserve(std::size_t layers) {
    if (layers <= windings_.size()) return;
    windings_.resize(layers, 0);
    covering_.clear();
    for (std::size_t words = layers; words > 1 || covering_.empty();) {
      words = (words + 63) / 64;
      covering_.emplace_back(words, 0);
    }
  }

  // Moves over an edge of the layer.
  void turn(std::uint32_t layer, std::int32_t by, std::int32_t inside) {
    std::int32_t& winding = windings_[layer];
    const bool covered = (winding & inside) != 0;
    winding += by;
    const bool covers = (winding & inside) != 0;
    if (covers && !covered) set(layer);
    if (covered && !covers) reset(layer);
  }

  // The layer on top; `empty` if there is none.
  std::uint32_t top() const {
    if (covering_.back()[0] == 0) return empty;
    std::size_t at = 0;
    for (std::size_t level = covering_.size(); level-- > 0;) {
      at = at * 64 + 63 - static_cast<std::size_t>(std::countl_zero(covering_[level][at]));
    }
    return static_cast<std::uint32_t>(at);
  }

  // Makes the layer as if no edge of it had been met. Every layer that was turned has to be cleared.
  void clear(std::uint32_t layer) {
    windings_[layer] = 0;
    reset(layer);
  }

 private:
  void set(std::size_t at) {
    for (std::vector<std::uint64_t>& words : covering_) {
      std::uint64_t& word = words[at / 64];
      const bool known = word != 0;
      word |= std::uint64_t{1} << at % 64;
      if (known) return;
      at /= 64;
    }
  }
  void reset(std::size_t at) {
    for (std::vector<std::uint64_t>& words : covering_) {
      std::uint64_t& word = words[at / 64];
      word &= ~(std::uint64_t{1} << at % 64);
      if (word != 0) return;
      at /= 64;
    }
  }

  std::vector<std::int32_t> windings_;
  // A bit for each layer that covers; above it a bit for each word of 64 that is not 0, and so on up to one word.
  std::vector<std::vector<std::uint64_t>> covering_;
};

}  // namespace cartoon
