#include "sampling/lookups/base_texels.h"

#include <algorithm>

namespace moire {

namespace {

constexpr std::int64_t floor_of_quotient(std::int64_t a, std::int64_t b) { return a / b - (a % b < 0 ? 1 : 0); }

// Calls visit(k, share) for the texels of level 0 that texel i of a level covers, along an axis where they have `size`
// and `level_size` texels. By whole numbers, as the pyramid averages them.
template <class Visit>
void for_each_covered(std::int64_t i, std::int64_t size, std::int64_t level_size, Visit visit) {
  const std::int64_t begin = i * size, end = begin + size;
  for (std::int64_t k = floor_of_quotient(begin, level_size); k * level_size < end; ++k) {
    const std::int64_t part = std::min((k + 1) * level_size, end) - std::max(k * level_size, begin);
    visit(k, static_cast<double>(part) / static_cast<double>(size));
  }
}

}  // namespace

void BaseTexels::add(int level, const Fold& place, std::int64_t i, std::int64_t j, double share) {
  if (share == 0) return;
  const Pyramid::Level &base = pyramid_.level(0), &own = pyramid_.level(level);
  // Beyond a border that stretches its texels, a level repeats its own, which are averages of what lies within.
  if (texture_.wrap() == Wrap::clamp) {
    i = std::clamp<std::int64_t>(i, 0, own.width - 1);
    j = std::clamp<std::int64_t>(j, 0, own.height - 1);
  }
  const std::int64_t texels = static_cast<std::int64_t>(base.width) * base.height;
  if (texels > most * own.width * own.height) {
    const std::int64_t column = wrapped(i, own.width, texture_.wrap()), row = wrapped(j, own.height, texture_.wrap());
    const float* c = own.rgba.data() + 4 * (row * own.width + column);
    texels_.push_back({texel_element(level, place.unfolded(0, i, own.width), place.unfolded(1, j, own.height)),
                       share,
                       {c[0], c[1], c[2]}});
    return;
  }
  for_each_covered(j, base.height, own.height, [&](std::int64_t row, double part_of_rows) {
    for_each_covered(i, base.width, own.width, [&](std::int64_t column, double part_of_columns) {
      const Hit hit = texture_.texel(0, place.unfolded(0, column, base.width), place.unfolded(1, row, base.height));
      texels_.push_back({hit.element, share * part_of_rows * part_of_columns, hit.color});
    });
  });
}

void BaseTexels::merge() {
  std::stable_sort(texels_.begin(), texels_.end(),
                   [](const Named& a, const Named& b) { return a.element < b.element; });
  std::size_t kept = 0;
  for (std::size_t k = 1; k < texels_.size(); ++k) {
    if (texels_[k].element == texels_[kept].element) {
      texels_[kept].share += texels_[k].share;
    } else {
      texels_[++kept] = texels_[k];
    }
  }
  texels_.resize(std::min(texels_.size(), kept + 1));
}

}  // namespace moire
