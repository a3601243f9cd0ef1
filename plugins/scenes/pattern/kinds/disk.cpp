// A light disk, or one in each tile.
#include "kinds/kinds.h"
#include "kinds/two_valued.h"

namespace pattern {

namespace {

class Disks final : public TwoValued<Disks> {
 public:
  Disks(const Look& look, double radius, const Tiles& tiles) : TwoValued(look), radius_(radius), tiles_(tiles) {}

  moire::Hit at(moire::Point p) const {
    const Tiles::Tile tile = tiles_.of(p);
    const moire::Point from_middle = p - tile.middle;
    const bool is_light = dot(from_middle, from_middle) < radius_ * radius_;
    return {is_light ? part(tile.i, tile.j) : moire::background, look().greys.of(is_light)};
  }

  template <class Weights>
  void cover(const Weights& weights, moire::PixelBlock& block) const {
    fill(block, [&](int x, int y, auto deposit) {
      const Tiles::Tile tile = tiles_.of(x, y);
      const double light = weights.disk(tile.middle - middle_of(x, y), radius_);
      deposit(part(tile.i, tile.j), light, look().greys.light);
      deposit(moire::background, 1 - light, look().greys.dark);
    });
  }

 private:
  double radius_;
  Tiles tiles_;
};

}  // namespace

std::unique_ptr<moire::Frame> make_disks(const Look& look, double radius, const Tiles& tiles) {
  return std::make_unique<Disks>(look, radius, tiles);
}

}  // namespace pattern
