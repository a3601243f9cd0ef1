// A straight edge, or one in each tile.
#include "kinds/kinds.h"
#include "kinds/two_valued.h"

namespace pattern {

namespace {

class Edges final : public TwoValued<Edges> {
 public:
  Edges(const Look& look, EdgeAngle angle, double offset, const Tiles& tiles)
      : TwoValued(look),
        normal_(direction(angle.angle_deg)),
        is_random_(angle.is_random),
        offset_(offset),
        tiles_(tiles) {}

  moire::Hit at(moire::Point p) const {
    const Tiles::Tile tile = tiles_.of(p);
    const bool is_light = inside(p, tile, normal_of(tile)) > 0;
    return {is_light ? part(tile.i, tile.j) : moire::background, look().greys.of(is_light)};
  }

  template <class Weights>
  void cover(const Weights& weights, moire::PixelBlock& block) const {
    const HalfPlanes<Weights> common(weights, normal_);
    fill(block, [&](int x, int y, auto deposit) {
      const Tiles::Tile tile = tiles_.of(x, y);
      const moire::Point normal = normal_of(tile);
      const double s = inside(middle_of(x, y), tile, normal);
      const double light = is_random_ ? weights.half_plane(std::abs(normal.x), std::abs(normal.y), s) : common(s);
      deposit(part(tile.i, tile.j), light, look().greys.light);
      deposit(moire::background, 1 - light, look().greys.dark);
    });
  }

 private:
  moire::Point normal_of(const Tiles::Tile& tile) const {
    return is_random_ ? direction(360 * tiles_.random(tile.i, tile.j, 2)) : normal_;
  }
  // How far a point is on the light side.
  double inside(moire::Point p, const Tiles::Tile& tile, moire::Point normal) const {
    return dot(normal, p - tile.middle) - offset_;
  }

  moire::Point normal_;
  bool is_random_;
  double offset_;
  Tiles tiles_;
};

}  // namespace

std::unique_ptr<moire::Frame> make_edges(const Look& look, EdgeAngle angle, double offset, const Tiles& tiles) {
  return std::make_unique<Edges>(look, angle, offset, tiles);
}

}  // namespace pattern
