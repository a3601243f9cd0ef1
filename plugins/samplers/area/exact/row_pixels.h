// The pixels of one row, from the boundaries that cross it: a box filter, exactly.
//
// A boundary changes what lies to its right. In the pixel that it crosses, its share of the pixel's height counts by
// the part of the pixel's width to its right, and in the next pixel by the rest: added up from left to right, that is
// the signed area under the boundary in every pixel.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include <moire/tally.h>

#include "exact/layers.h"

namespace area {

// What lies to the right of a boundary instead of what lies to its left.
struct Change {
  Change(const Layers& layers, std::uint32_t l, std::uint32_t r)
      : red(double{layers[r].color.r} - double{layers[l].color.r}),
        green(double{layers[r].color.g} - double{layers[l].color.g}),
        blue(double{layers[r].color.b} - double{layers[l].color.b}),
        left(l),
        right(r) {}
  double red, green, blue;
  std::uint32_t left, right;
};

// What boundaries do to a pixel and, from it on, to all that follow.
struct PixelCell {
  double r = 0, g = 0, b = 0;
  void add(double weight, const Change& change) {
    r += weight * change.red;
    g += weight * change.green;
    b += weight * change.blue;
  }
};
// How many a row of pixels needs.
inline std::size_t cells_of(int width) { return static_cast<std::size_t>(width) + 2; }

// `Add` is a Tally::Adder<recorded>: fragments are kept if it does so.
template <bool recorded>
class RowPixels {
 public:
  using Add = moire::Tally::Adder<recorded>;

  // How much of a pixel each layer takes, and the colour that this makes.
  class Content {
   public:
    Content(const Layers& layers, std::uint32_t layer) { become(layers, layer); }
    void become(const Layers& layers, std::uint32_t layer) {
      const moire::Color color = layers[layer].color;
      sum = {1, color.r, color.g, color.b};
      if constexpr (recorded) shares.assign(1, {layer, 1});
    }

    struct Share {
      std::uint32_t layer;
      double weight;
    };
    moire::Tally::Sum sum;
    std::vector<Share> shares;  // of layers that are there; only if recorded
  };

  // `cells`: empty, cells_of(width) of them; left empty again.
  RowPixels(const Layers& layers, int width, moire::PixelBlock& block, Add add, std::span<PixelCell> cells)
      : layers_(layers),
        width_(width),
        block_(block),
        add_(add),
        nothing_(0x1p-46 * std::max(1.0, width / 256.0)),
        cells_(cells) {
    if constexpr (recorded) passages_.resize(cells_.size());
  }

  int width() const { return width_; }
  const Layers& layers() const { return layers_; }

  void begin_row(int y) { slot_ = block_.slot(block_.x0, y); }

  // A boundary from (x0, y0) to (x1, y1), y in the row's pixels. Calls crossed(first, last) with the pixels it crosses.
  template <class Crossed>
  void boundary(double x0, double y0, double x1, double y1, const Change& change, Crossed crossed) {
    const double height = y1 - y0;
    if (x1 < x0) std::swap(x0, x1);
    if (x0 >= width_) return;
    if (x1 <= 0) {
      crossed(0, 0);
      return deposit(0, height, 1, change);
    }
    const int first = x0 <= 0 ? 0 : static_cast<int>(x0);
    if (x0 >= 0 && x1 <= first + 1) {
      crossed(first, first);
      return deposit(first, height, first + 1 - (x0 + x1) / 2, change);
    }
    // Over several pixels: to each its part of the height.
    crossed(first, std::min(width_, static_cast<int>(std::min<double>(x1, width_)) + 1) - 1);
    const double slope = height / (x1 - x0);
    double from = x0, rest = height;
    if (from < 0) {
      const double outside = -from * slope;
      deposit(0, outside, 1, change);
      rest -= outside;
      from = 0;
    }
    for (int pixel = first; pixel < width_; ++pixel) {
      if (x1 <= pixel + 1) return deposit(pixel, rest, pixel + 1 - (from + x1) / 2, change);
      const double part = (pixel + 1 - from) * slope;
      deposit(pixel, part, (pixel + 1 - from) / 2, change);
      rest -= part;
      from = pixel + 1;
    }
  }

  // Deposits the pixels [begin, end), which boundaries cross. `content` is what lies left of them, and becomes what
  // lies right of them.
  void deposit_crossed(int begin, int end, Content& content) {
    for (int pixel = begin; pixel < end; ++pixel) {
      pass(pixel, content);
      if (is_wanted(pixel)) deposit(slot(pixel), content);
    }
    pass(end, content);
  }

  // Deposits the pixels [begin, end), all alike.
  void deposit_solid(int begin, int end, const Content& content) {
    const int first = std::max(begin, block_.x0), last = std::min(end, block_.x0 + block_.width);
    if (!recorded && block_.across() == 1 && first < last) {
      const moire::Color color{static_cast<float>(content.sum.r), static_cast<float>(content.sum.g),
                               static_cast<float>(content.sum.b)};
      return block_.add_run({slot(first), static_cast<std::size_t>(last - first), color});
    }
    for (int pixel = first; pixel < last; ++pixel) deposit(slot(pixel), content);
  }

 private:
  // How much passes to a layer.
  struct Passage {
    std::uint32_t layer;
    double weight;
  };

  // A boundary of this height in a pixel, `beyond` of whose width lies to its right.
  void deposit(int pixel, double height, double beyond, const Change& change) {
    PixelCell* cell = &cells_[static_cast<std::size_t>(pixel)];
    const double here = height * beyond, next = height - here;
    cell[0].add(here, change);
    cell[1].add(next, change);
    if constexpr (recorded) {
      std::vector<Passage>* passages = &passages_[static_cast<std::size_t>(pixel)];
      passages[0].insert(passages[0].end(), {{change.left, -here}, {change.right, here}});
      passages[1].insert(passages[1].end(), {{change.left, -next}, {change.right, next}});
    }
  }

  // Adds to `content` what boundaries have changed up to this pixel.
  void pass(int pixel, Content& content) {
    PixelCell& cell = cells_[static_cast<std::size_t>(pixel)];
    content.sum.r += cell.r;
    content.sum.g += cell.g;
    content.sum.b += cell.b;
    cell = {};
    if constexpr (recorded) {
      for (const Passage& passage : passages_[static_cast<std::size_t>(pixel)]) {
        auto share = std::find_if(content.shares.begin(), content.shares.end(),
                                  [&](const auto& s) { return s.layer == passage.layer; });
        if (share == content.shares.end()) share = content.shares.insert(share, {passage.layer, 0});
        share->weight += passage.weight;
      }
      passages_[static_cast<std::size_t>(pixel)].clear();
      std::erase_if(content.shares, [&](const auto& s) { return std::abs(s.weight) < nothing_; });
    }
  }

  bool is_wanted(int pixel) const { return pixel >= block_.x0 && pixel < block_.x0 + block_.width; }
  std::size_t slot(int pixel) const { return slot_ + static_cast<std::size_t>(pixel - block_.x0) * block_.across(); }
  void deposit(std::size_t slot, const Content& content) {
    add_.sum(slot, content.sum);
    if constexpr (recorded) {
      // Whatever rounding has left of layers that are gone, or has taken too much, the layer that has most makes up
      // for.
      const auto most = std::max_element(content.shares.begin(), content.shares.end(),
                                         [](const auto& a, const auto& b) { return a.weight < b.weight; });
      double rest = 1;
      for (auto share = content.shares.begin(); share != content.shares.end(); ++share) {
        if (share != most && share->weight > 0) rest -= share->weight;
      }
      for (auto share = content.shares.begin(); share != content.shares.end(); ++share) {
        const double weight = share == most ? rest : share->weight;
        if (weight > 0) add_.record(slot, layers_[share->layer].element, weight, layers_[share->layer].color);
      }
    }
  }

  const Layers& layers_;
  int width_;
  moire::PixelBlock& block_;
  Add add_;
  // Less is what rounding leaves of a layer that is gone: some boundaries, each known to half a digit of the largest x.
  double nothing_;
  std::size_t slot_ = 0;
  std::span<PixelCell> cells_;
  std::vector<std::vector<Passage>> passages_;  // in each pixel, from it on; only if recorded
};

}  // namespace area
