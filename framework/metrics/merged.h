// Fragments as metrics see them: merged by element, divided by their sum.
#pragma once

#include <span>
#include <vector>

#include <moire/tally.h>

namespace moire {

struct ElementWeight {
  Element element;
  double weight;  // of a pixel: all weights sum to 1
};

// The elements of a slot in rising order, each once, none of weight 0. `out` is overwritten.
void merge(const Tally& tally, std::size_t slot, std::vector<ElementWeight>& out);

// The merged fragments of a block of pixels, compactly.
class MergedBlock {
 public:
  MergedBlock() = default;
  explicit MergedBlock(const PixelBlock& block);

  std::span<const ElementWeight> pixel(std::size_t slot) const {
    return std::span(fragments_).subspan(begins_[slot], begins_[slot + 1] - begins_[slot]);
  }

 private:
  std::vector<std::size_t> begins_;
  std::vector<ElementWeight> fragments_;
};

}  // namespace moire
