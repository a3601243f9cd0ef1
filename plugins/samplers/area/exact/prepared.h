// The exact picture of ordered polygons from their overlay, which is resolved once and serves all frames that show the
// same artwork.
#pragma once

#include <memory>

#include <moire/sampler.h>

#include "exact/overlay.h"
#include "exact/row_buckets.h"

namespace area {

class Prepared final : public moire::Rendering {
 public:
  // Takes over the overlay of request.previous if that one's artwork is the same; otherwise resolves it, to the same
  // bits.
  explicit Prepared(const moire::RenderRequest& request);
  void render(moire::PixelBlock& block) const override;
  moire::Blocks blocks() const override { return moire::Blocks::rows; }

 private:
  // Which polygons an overlay is of: an artwork's own, turned by the linear map unless that keeps the axes apart.
  struct Key {
    std::uint64_t artwork = 0;  // 0: new in every frame
    moire::Affine turn;
    moire::Color background;
    friend bool operator==(const Key&, const Key&) = default;
  };

  void place(const moire::Affine& placement);

  moire::ImageSize size_;
  Key key_;
  std::shared_ptr<const Overlay> overlay_;
  std::vector<Overlay::Boundary> boundaries_;  // in the image
  RowBuckets buckets_;
};

}  // namespace area
