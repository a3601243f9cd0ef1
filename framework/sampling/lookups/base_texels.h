// What a read of a pyramid is made of: the texels of level 0 behind it.
#pragma once

#include <vector>

#include <moire/texture.h>

#include "sampling/lookups/fold.h"

namespace moire {

// Texels with their shares of what was read. A texel of a pyramid's level l is named by the texels of level 0 that it
// is the average of, each with its share, whole or in part. Where they are more than `most`, l's own texel is named: no
// scene shows it, so that coverage counts it as hidden.
class BaseTexels {
 public:
  static constexpr std::int64_t most = 256;

  explicit BaseTexels(const Texture& texture) : texture_(texture), pyramid_(texture.pyramid()) {}

  // (i, j): a texel of `level` of the texture into which the place is folded, or its neighbour across the border.
  // Shares of 0 are left out.
  void add(int level, const Fold& place, std::int64_t i, std::int64_t j, double share);

  // Calls visit(element, share, colour), once for every element, in their order.
  template <class Visit>
  void for_each(Visit&& visit) {
    merge();
    for (const Named& texel : texels_) visit(texel.element, texel.share, texel.color);
  }

 private:
  struct Named {
    Element element;
    double share;
    Color color;
  };
  void merge();

  const Texture& texture_;
  const Pyramid& pyramid_;
  std::vector<Named> texels_;
};

}  // namespace moire
