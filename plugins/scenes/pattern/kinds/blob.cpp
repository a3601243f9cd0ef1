// A Gaussian blob, or one in each tile.
#include "kinds/factors.h"
#include "kinds/kinds.h"
#include "kinds/separable.h"

namespace pattern {

namespace {

class Blob final : public Separable<Blob, Gaussian> {
 public:
  Blob(const Look& look, double sigma) : Separable(look, Gaussian(sigma)) {}
  double grey(double x, double y) const { return x * y; }
};

class TiledBlobs final : public PatternFrame<TiledBlobs> {
 public:
  TiledBlobs(const Look& look, double sigma, const Tiles& tiles)
      : PatternFrame(look), gaussian_(sigma), tiles_(tiles) {}

  moire::Hit at(moire::Point p) const {
    const Tiles::Tile tile = tiles_.of(p);
    const moire::Point from_middle = p - tile.middle;
    return {part(tile.i, tile.j), look().greys.mix(gaussian_.at(from_middle.x) * gaussian_.at(from_middle.y))};
  }

 private:
  // Tiles have no averages under filters.
  double integrate(const moire::Filter*, moire::PixelBlock& block) const override {
    fill(block, [&](int x, int y, auto deposit) {
      const Tiles::Tile tile = tiles_.of(x, y);
      const moire::Point from_middle = middle_of(x, y) - tile.middle;
      const double grey = gaussian_.over_pixel(from_middle.x) * gaussian_.over_pixel(from_middle.y);
      deposit(part(tile.i, tile.j), 1, look().greys.mix(grey));
    });
    return 0;
  }

  Gaussian gaussian_;
  Tiles tiles_;
};

}  // namespace

std::unique_ptr<moire::Frame> make_blobs(const Look& look, double sigma) { return std::make_unique<Blob>(look, sigma); }
std::unique_ptr<moire::Frame> make_tiled_blobs(const Look& look, double sigma, const Tiles& tiles) {
  return std::make_unique<TiledBlobs>(look, sigma, tiles);
}

}  // namespace pattern
