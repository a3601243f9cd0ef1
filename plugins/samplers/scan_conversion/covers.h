// What curves cover of the pixels of a block, one over the other.
#pragma once

#include <vector>

#include <moire/sampler.h>

namespace scan_conversion {

// Every pixel keeps its covers, those in front first. Each hides its intensity's share of what lies behind it, whatever
// part of the pixel it may lie in: coverages are blended, and where curves meet that is no exact area.
class Covers {
 public:
  // Intensities are of `full`.
  Covers(const moire::PixelBlock& block, std::uint32_t full)
      : block_(block), full_(full), first_(block.slots(), none) {}

  // Over those of the pixel before. Requires: the pixel lies in the block, intensity <= full.
  void add(int x, int y, std::uint32_t curve, std::uint32_t intensity) {
    if (intensity == 0) return;
    std::uint32_t& first = first_[block_.slot(x, y)];
    covers_.push_back({first, curve, intensity});
    first = static_cast<std::uint32_t>(covers_.size() - 1);
  }

  // Deposits them: paint(curve) has an element and a colour. What is left of a pixel is background.
  template <class Paint>
  void deposit(moire::PixelBlock& block, moire::Color background, Paint paint) const {
    block.fill([&](auto add_fragment) {
      for (std::size_t slot = 0; slot < first_.size(); ++slot) {
        double rest = 1;
        for (std::uint32_t k = first_[slot]; k != none; k = covers_[k].next) {
          const double alpha = static_cast<double>(covers_[k].intensity) / full_, weight = alpha * rest;
          // Behind hundreds of covers nothing is left that a double could hold.
          if (weight == 0) break;
          const auto& painted = paint(covers_[k].curve);
          add_fragment(slot, painted.element, weight, painted.color);
          rest *= 1 - alpha;
        }
        if (rest > 0) add_fragment(slot, moire::background, rest, background);
      }
    });
  }

 private:
  static constexpr std::uint32_t none = 0xffffffffU;
  struct Cover {
    std::uint32_t next, curve, intensity;
  };

  const moire::PixelBlock& block_;
  double full_;
  std::vector<std::uint32_t> first_;
  std::vector<Cover> covers_;
};

}  // namespace scan_conversion
