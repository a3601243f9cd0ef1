#include "quadtree.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "footprint.h"

namespace textured_plane {

namespace {

constexpr std::int64_t few_texels = 64;

// A rectangle of the plane between texels' edges, ends excluded.
struct Extent {
  std::int64_t i0, i1, j0, j1;
};

// One pixel on its way down the tree.
class Descent {
 public:
  Descent(const View& view, const Texels& texels, const Blocks& blocks, const Footprint& footprint, double tolerance)
      : view_(view),
        texels_(texels),
        blocks_(blocks),
        footprint_(footprint),
        box_(footprint.box()),
        tolerance_(tolerance) {}

  void run() {
    if (box_.count() <= few_texels) {
      return footprint_.for_each_texel(
          [&](std::int64_t i, std::int64_t j, double area) { sum_.add(area, texels_.texture().texel(0, i, j).color); });
    }
    if (is_clamped()) return descend(footprint_.near(), blocks_.levels() - 1, 0, 0, {});
    const auto copy = [](std::int64_t i, std::int64_t size) { return (i - moire::wrapped(i, size, repeat)) / size; };
    const std::int64_t width = texels_.width(), height = texels_.height();
    over_copies(footprint_.near(),
                {copy(box_.i0, width), copy(box_.i1, width) + 1, copy(box_.j0, height), copy(box_.j1, height) + 1});
  }

  const moire::Tally::Sum& sum() const { return sum_; }
  double bound() const { return bound_; }

 private:
  static constexpr moire::Wrap repeat = moire::Wrap::repeat;

  // A copy of the texture: how many lie before it each way.
  struct Copy {
    std::int64_t i = 0, j = 0;
  };

  bool is_clamped() const { return texels_.wrap() == moire::Wrap::clamp; }

  // Copies of the texture, in numbers of copies. They have one mean, that of the whole texture.
  void over_copies(const Convex& part, const Extent& copies) {
    if (part.empty()) return;
    const std::int64_t width = texels_.width(), height = texels_.height();
    const std::int64_t across = copies.i1 - copies.i0, down = copies.j1 - copies.j0;
    if (across == 1 && down == 1) return descend(part, blocks_.levels() - 1, 0, 0, {copies.i0, copies.j0});
    const Extent extent{copies.i0 * width, copies.i1 * width, copies.j0 * height, copies.j1 * height};
    if (take(part, blocks_.whole(), &extent)) return;
    if (across > 1 && (down == 1 || across * width > down * height)) {
      const std::int64_t middle = copies.i0 + across / 2;
      const auto [above, below] = footprint_.split_s(part, middle * width);
      over_copies(below, {copies.i0, middle, copies.j0, copies.j1});
      over_copies(above, {middle, copies.i1, copies.j0, copies.j1});
    } else {
      const std::int64_t middle = copies.j0 + down / 2;
      const auto [above, below] = footprint_.split_t(part, middle * height);
      over_copies(below, {copies.i0, copies.i1, copies.j0, middle});
      over_copies(above, {copies.i0, copies.i1, middle, copies.j1});
    }
  }

  // Where texel k's lower edge of the texture is in a copy of it: the upper one of its mirror image.
  std::int64_t edge(std::int64_t k, std::int64_t copy, int size) const {
    return is_mirrored(copy) ? (copy + 1) * size - k : copy * size + k;
  }
  // The same for a range of texels, the lower one first.
  std::pair<std::int64_t, std::int64_t> edges(std::int64_t first, std::int64_t end, std::int64_t copy, int size) const {
    const std::int64_t a = edge(first, copy, size), b = edge(end, copy, size);
    return {std::min(a, b), std::max(a, b)};
  }
  bool is_mirrored(std::int64_t copy) const { return texels_.wrap() == moire::Wrap::mirror && copy % 2 != 0; }

  // Block (i, j) of a level.
  void descend(const Convex& part, int level, int i, int j, const Copy& copy) {
    if (part.empty()) return;
    const Blocks::Block& block = blocks_.block(level, i, j);
    const std::int64_t size = std::int64_t{1} << level;
    const Extent of_texture{i * size, std::min<std::int64_t>((i + 1) * size, texels_.width()), j * size,
                            std::min<std::int64_t>((j + 1) * size, texels_.height())};
    if (is_clamped()) {
      // Texels of the texture's border go on without end.
      const bool ends =
          of_texture.i0 > 0 && of_texture.i1 < texels_.width() && of_texture.j0 > 0 && of_texture.j1 < texels_.height();
      if (take(part, block, ends ? &of_texture : nullptr)) return;
    } else {
      const auto [i0, i1] = edges(of_texture.i0, of_texture.i1, copy.i, texels_.width());
      const auto [j0, j1] = edges(of_texture.j0, of_texture.j1, copy.j, texels_.height());
      const Extent extent{i0, i1, j0, j1};
      if (take(part, block, &extent)) return;
    }

    // Its four parts, as far as the texture goes.
    const auto halves = [&](const Convex& whole, bool is_two, auto split, bool mirrored) {
      if (!is_two) return std::array{whole, Convex()};
      const auto [above, below] = split(whole);
      return mirrored ? std::array{above, below} : std::array{below, above};
    };
    const bool two_columns = 2 * i + 1 < blocks_.columns(level - 1), two_rows = 2 * j + 1 < blocks_.rows(level - 1);
    const std::array columns = halves(
        part, two_columns,
        [&](const Convex& whole) {
          return footprint_.split_s(whole, edge((2 * i + 1) * (size / 2), copy.i, texels_.width()));
        },
        is_mirrored(copy.i));
    for (int a = 0; a < (two_columns ? 2 : 1); ++a) {
      const std::array parts = halves(
          columns[static_cast<std::size_t>(a)], two_rows,
          [&](const Convex& whole) {
            return footprint_.split_t(whole, edge((2 * j + 1) * (size / 2), copy.j, texels_.height()));
          },
          is_mirrored(copy.j));
      for (int b = 0; b < (two_rows ? 2 : 1); ++b) {
        descend(parts[static_cast<std::size_t>(b)], level - 1, 2 * i + a, 2 * j + b, copy);
      }
    }
  }

  // Deposits the block's mean if that is good enough. `extent`: of the block, null where it has no end.
  bool take(const Convex& part, const Blocks::Block& block, const Extent* extent) {
    const double area = part.area(), limit = std::max(tolerance_ * area, tolerance_ / 1000);
    const double error = error_of(area, block, extent, limit);
    if (error > limit) return false;
    bound_ += error;
    sum_.add({area, area * block.mean[0], area * block.mean[1], area * block.mean[2]});
    return true;
  }

  // A bound on the error that the mean makes; not needed exactly above `limit`. With J the area in the picture of a
  // piece of the plane, in proportion to depth^-3, and d the colour's distance from its mean over the block, it is
  // the integral of d J over the part seen. No part's is above its area times the largest |d|. The integral of d alone
  // vanishes over a whole block, so that its own is at most that of d (J - K) for any constant K: K the smallest J
  // gives area * largest |d| * (1 - smallest / largest J); K the mean of both, with Cauchy and Schwarz, area * root
  // mean square d * (largest / smallest J - 1) / 2. What is hidden of the block counts as its area times the largest
  // |d|.
  double error_of(double area, const Blocks::Block& block, const Extent* extent, double limit) const {
    const double deviation = block.deviation, all = area * deviation;
    if (all <= limit || !extent) return all;
    const double s[] = {footprint_.s_of(extent->i0), footprint_.s_of(extent->i1)};
    const double t[] = {footprint_.t_of(extent->j0), footprint_.t_of(extent->j1)};
    double low = view_.depth(s[0], t[0]), high = low;
    for (const double depth : {view_.depth(s[0], t[1]), view_.depth(s[1], t[0]), view_.depth(s[1], t[1])}) {
      low = std::min(low, depth);
      high = std::max(high, depth);
    }
    if (low <= 0) return all;
    const double ratio = high / low, cube = ratio * ratio * ratio;
    const double per_area = std::min(deviation * (1 - 1 / cube), block.spread * (cube - 1) / 2);
    if (area * per_area > limit) return all;
    const moire::Point a = view_.image_of(s[0], t[0]), b = view_.image_of(s[1], t[0]), c = view_.image_of(s[1], t[1]),
                       d = view_.image_of(s[0], t[1]);
    const double whole = std::abs((c.x - a.x) * (d.y - b.y) - (d.x - b.x) * (c.y - a.y)) / 2;
    return std::min(all, whole * per_area + std::max(0.0, whole - area) * deviation);
  }

  const View& view_;
  const Texels& texels_;
  const Blocks& blocks_;
  const Footprint& footprint_;
  TexelBox box_;
  double tolerance_;
  moire::Tally::Sum sum_;
  double bound_ = 0;
};

}  // namespace

Quadtree::Quadtree(const View& view, const Texels& texels, const Surroundings& surroundings, double tolerance)
    : view_(view), texels_(texels), surroundings_(surroundings), tolerance_(tolerance), blocks_(texels.blocks()) {}

double Quadtree::integrate(moire::PixelBlock& block) const {
  double bound = 0;
  block.counters.queries += block.slots();
  block.fill([&](auto add) {
    for (int y = block.y0; y < block.y0 + block.height; ++y) {
      for (int x = block.x0; x < block.x0 + block.width; ++x) {
        const std::size_t slot = block.slot(x, y);
        const Footprint footprint(view_, x, y);
        if (footprint.sky() > 0) add(slot, moire::background, footprint.sky(), surroundings_.sky);
        if (footprint.sky() < 1) ++block.counters.hits;
        if (footprint.far() > 0) add(slot, far_ground, footprint.far(), surroundings_.far);
        if (footprint.near().empty()) continue;
        Descent descent(view_, texels_, blocks_, footprint, tolerance_);
        descent.run();
        add.sum(slot, descent.sum());
        bound = std::max(bound, descent.bound());
        if (!block.recording()) continue;
        footprint.for_each_texel([&](std::int64_t i, std::int64_t j, double area) {
          const moire::Hit hit = texels_.texture().texel(0, i, j);
          add.record(slot, hit.element, area, hit.color);
        });
      }
    }
  });
  return bound;
}

}  // namespace textured_plane
