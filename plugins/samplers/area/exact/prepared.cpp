#include "exact/prepared.h"

#include <algorithm>
#include <utility>

#include "exact/replayed_rows.h"

namespace area {

Prepared::Prepared(const moire::RenderRequest& request) : size_(request.frame.size()) {
  const moire::Polygons& polygons = *request.frame.polygons();
  const moire::Artwork* artwork = polygons.artwork();
  if (!artwork) {
    overlay_ = std::make_shared<Overlay>(
        Layers(polygons, {0, 0, static_cast<double>(size_.width), static_cast<double>(size_.height)}));
    place({});
    return;
  }

  const moire::Affine placement = artwork->placement();
  // Level boundaries count for nothing as long as they stay level.
  const bool is_turned = placement.xy != 0 || placement.yx != 0;
  key_ = {artwork->identity(),
          is_turned ? moire::Affine{placement.xx, placement.xy, 0, placement.yx, placement.yy, 0} : moire::Affine{},
          polygons.background_color()};
  const auto* previous = dynamic_cast<const Prepared*>(request.previous);
  overlay_ = previous && previous->key_ == key_
                 ? previous->overlay_
                 : std::make_shared<Overlay>(Layers(*artwork, key_.turn, key_.background));
  place(is_turned ? moire::Affine{1, 0, placement.x0, 0, 1, placement.y0} : placement);
}

// Boundaries to the image, in their order, without what lies above, below or to the right of it.
void Prepared::place(const moire::Affine& placement) {
  boundaries_.reserve(overlay_->boundaries().size());
  const bool mirrored_x = placement.xx < 0, mirrored_y = placement.yy < 0;
  for (const Overlay::Boundary& b : overlay_->boundaries()) {
    Overlay::Boundary placed{placement(b.upper), placement(b.lower), b.left, b.right};
    if (mirrored_x) std::swap(placed.left, placed.right);
    if (mirrored_y) std::swap(placed.upper, placed.lower);
    const bool is_seen = placed.lower.y > 0 && placed.upper.y < size_.height &&
                         std::min(placed.upper.x, placed.lower.x) < size_.width && placed.upper.y < placed.lower.y;
    if (is_seen) boundaries_.push_back(placed);
  }
  buckets_ = RowBuckets(
      boundaries_.size(), size_.height, [&](std::uint32_t k) { return boundaries_[k].upper.y; },
      [&](std::uint32_t k) { return boundaries_[k].lower.y; });
}

void Prepared::render(moire::PixelBlock& block) const {
  // Kept from block to block: to make them anew takes as long as to fill them.
  thread_local std::vector<PixelCell> spare;
  std::vector<PixelCell> cells = std::exchange(spare, {});
  cells.resize(RowBuckets::rows_each * cells_of(size_.width));
  block.fill([&](auto add) {
    ReplayedRows rows(overlay_->layers(), size_.width, block, add, cells);
    RowBuckets::for_each(block.y0, block.y0 + block.height, [&](int bucket, int first, int end) {
      rows.begin(first, end);
      for (const std::uint32_t k : buckets_[bucket]) {
        if (boundaries_[k].upper.y < end && boundaries_[k].lower.y > first) rows.add(boundaries_[k]);
      }
      rows.deposit();
    });
  });
  spare = std::move(cells);
  block.counters.queries += static_cast<std::uint64_t>(block.width) * static_cast<std::uint64_t>(block.height);
}

}  // namespace area
