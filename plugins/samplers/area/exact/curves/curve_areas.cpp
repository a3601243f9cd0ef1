#include "exact/curves/curve_areas.h"

#include <algorithm>
#include <limits>

namespace area {

namespace {

// Pixels; a tile's own arrays stay in the processor's first cache.
constexpr int tile_side = 32;

// A cover by less is a rounding error, and so is what one by more leaves.
constexpr double least_area = 0x1p-50;

constexpr std::uint32_t none = std::numeric_limits<std::uint32_t>::max();

}  // namespace

class CurveAreas::Reader final : public moire::CurveSink {
 public:
  explicit Reader(std::vector<Curve>& curves) : curves_(curves) {}
  void line(const moire::LineCurve& line) override { add(line); }
  void circle(const moire::CircleCurve& circle) override { add(circle); }

 private:
  template <class Given>
  void add(const Given& given) {
    Shape shape(given);
    if (!shape.is_empty()) curves_.push_back({given.element, given.color, std::move(shape)});
  }
  std::vector<Curve>& curves_;
};

CurveAreas::CurveAreas(const moire::Frame& frame)
    : size_(frame.size()), background_(frame.curves()->background_color()) {
  Reader reader(curves_);
  frame.curves()->stream(reader);
  tiles_ = {0, 0, (size_.width + tile_side - 1) / tile_side, (size_.height + tile_side - 1) / tile_side};
  sort_into_tiles();
}

void CurveAreas::sort_into_tiles() {
  const auto tiles = static_cast<std::size_t>(tiles_.width) * static_cast<std::size_t>(tiles_.height);
  // In the order of curves, each once.
  std::vector<std::uint32_t> last(tiles, none);
  std::vector<std::pair<std::uint32_t, std::uint32_t>> touches;
  first_.assign(tiles + 1, 0);
  for (std::uint32_t k = 0; k < curves_.size(); ++k) {
    curves_[k].shape.boxes(tile_side, tiles_, [&](int u, int v) {
      const auto tile = static_cast<std::uint32_t>(v * tiles_.width + u);
      if (last[tile] == k) return;
      last[tile] = k;
      touches.emplace_back(tile, k);
      ++first_[tile + 1];
    });
  }
  for (std::size_t t = 0; t < tiles; ++t) first_[t + 1] += first_[t];
  std::vector<std::size_t> next(first_.begin(), first_.end() - 1);
  touching_.resize(touches.size());
  for (const auto& [tile, curve] : touches) touching_[next[tile]++] = curve;
}

// The pixels of a tile that are in a block: what covers each of them, from the front to what covers it whole.
class CurveAreas::Tile {
 public:
  explicit Tile(const CurveAreas& all) : all_(all) {}

  // Finds all covers of the pixels of `window`. Requires: it lies within tile `tile`.
  void look_at(std::size_t tile, const moire::PixelArea& window) {
    window_ = window;
    pixels_.assign(static_cast<std::size_t>(window.width) * static_cast<std::size_t>(window.height), Pixel{});
    parts_.clear();
    std::size_t open = pixels_.size();
    for (std::size_t k = all_.first_[tile + 1]; k > all_.first_[tile] && open > 0; --k) {
      const std::uint32_t curve = all_.touching_[k - 1];
      all_.curves_[curve].shape.areas(window, slabs_, [&](int x, int y, double area) {
        Pixel& pixel = pixels_[index(x, y)];
        if (pixel.whole != none || area < least_area) return;
        if (area > 1 - least_area) {
          pixel.whole = curve;
          --open;
          return;
        }
        const auto part = static_cast<std::uint32_t>(parts_.size());
        parts_.push_back({curve, none, area});
        if (pixel.parts++ == 0) {
          pixel.first = part;
        } else {
          parts_[pixel.last].next = part;
        }
        pixel.last = part;
      });
    }
  }

  // Deposits the content of a pixel, those in front last.
  template <class Deposit>
  void deposit(int x, int y, Deposit deposit) {
    const Pixel& pixel = pixels_[index(x, y)];
    if (pixel.parts == 0) {
      deposit(pixel.whole, 1.0);
    } else if (pixel.parts == 1) {
      const Part& part = parts_[pixel.first];
      deposit(pixel.whole, 1 - part.area);
      deposit(part.curve, part.area);
    } else {
      slabs_.clear();
      order_.clear();
      for (std::uint32_t k = pixel.first; k != none; k = parts_[k].next) {
        all_.curves_[parts_[k].curve].shape.cover(x, y, static_cast<std::uint32_t>(order_.size()), slabs_);
        order_.push_back(parts_[k].curve);
      }
      const std::vector<double>& areas = slabs_.integrate(order_.size());
      order_.push_back(pixel.whole);
      for (std::size_t k = order_.size(); k-- > 0;) {
        if (areas[k] >= least_area) deposit(order_[k], areas[k]);
      }
    }
  }

 private:
  struct Pixel {
    std::uint32_t whole = none;  // what covers it whole; none: the background
    std::uint32_t parts = 0, first = none, last = none;
  };
  // A cover of a part of a pixel, and the next one behind it.
  struct Part {
    std::uint32_t curve, next;
    double area;
  };

  std::size_t index(int x, int y) const {
    return static_cast<std::size_t>(y - window_.y0) * static_cast<std::size_t>(window_.width) +
           static_cast<std::size_t>(x - window_.x0);
  }

  const CurveAreas& all_;
  moire::PixelArea window_;
  std::vector<Pixel> pixels_;
  std::vector<Part> parts_;
  std::vector<std::uint32_t> order_;
  Slabs slabs_;
};

void CurveAreas::render(moire::PixelBlock& block) const {
  block.fill([&](auto add) {
    Tile pixels(*this);
    const int right = block.x0 + block.width, bottom = block.y0 + block.height;
    for (int v = block.y0 / tile_side; v * tile_side < bottom; ++v) {
      for (int u = block.x0 / tile_side; u * tile_side < right; ++u) {
        const int x0 = std::max(block.x0, u * tile_side), y0 = std::max(block.y0, v * tile_side);
        const int x1 = std::min(right, (u + 1) * tile_side), y1 = std::min(bottom, (v + 1) * tile_side);
        pixels.look_at(static_cast<std::size_t>(v * tiles_.width + u), {x0, y0, x1 - x0, y1 - y0});
        for (int y = y0; y < y1; ++y) {
          for (int x = x0; x < x1; ++x) {
            const std::size_t slot = block.slot(x, y);
            pixels.deposit(x, y, [&](std::uint32_t curve, double area) {
              if (curve == none) {
                add(slot, moire::background, area, background_);
                return;
              }
              add(slot, curves_[curve].element, area, curves_[curve].color);
              ++block.counters.hits;
            });
          }
        }
      }
    }
  });
  block.counters.queries += block.slots();
}

}  // namespace area
