#include "metrics/merged.h"

#include <algorithm>

namespace moire {

void merge(const Tally& tally, std::size_t slot, std::vector<ElementWeight>& out) {
  out.clear();
  double sum = 0;
  tally.for_each(slot, [&](const Fragment& f) {
    out.push_back({f.element, f.weight});
    sum += f.weight;
  });
  // Stable, so that weights are summed in the order of deposit and the sum has the same bits every time.
  std::stable_sort(out.begin(), out.end(), [](const auto& a, const auto& b) { return a.element < b.element; });
  std::size_t kept = 0;
  for (std::size_t k = 0; k < out.size();) {
    ElementWeight merged{out[k].element, 0};
    for (; k < out.size() && out[k].element == merged.element; ++k) merged.weight += out[k].weight / sum;
    if (merged.weight != 0) out[kept++] = merged;
  }
  out.resize(kept);
}

MergedBlock::MergedBlock(const PixelBlock& block) {
  std::vector<ElementWeight> pixel;
  begins_.push_back(0);
  for (std::size_t slot = 0; slot < block.slots(); ++slot) {
    merge(block, slot, pixel);
    fragments_.insert(fragments_.end(), pixel.begin(), pixel.end());
    begins_.push_back(fragments_.size());
  }
  fragments_.shrink_to_fit();
}

}  // namespace moire
