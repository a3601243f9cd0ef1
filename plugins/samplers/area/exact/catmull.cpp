#include "exact/catmull.h"

#include "exact/scanline.h"

namespace area {

Catmull::Catmull(const moire::RenderRequest& request, bool jagged)
    : size_(request.frame.size()),
      jagged_(jagged),
      layers_(*request.frame.polygons(), {0, 0, static_cast<double>(size_.width), static_cast<double>(size_.height)}),
      polygons_(monotone_polygons(layers_, size_.height)),
      buckets_(
          polygons_.size(), size_.height, [&](std::uint32_t k) { return polygons_[k].top(); },
          [&](std::uint32_t k) { return polygons_[k].bottom(); }) {}

void Catmull::render(moire::PixelBlock& block) const {
  block.fill([&](auto add) {
    Scanline scanline(layers_, size_.width, jagged_, block, add);
    RowBuckets::for_each(block.y0, block.y0 + block.height, [&](int bucket, int first, int end) {
      for (int y = first; y < end; ++y) {
        scanline.begin(y);
        for (const std::uint32_t k : buckets_[bucket]) {
          const MonotonePolygon& polygon = polygons_[k];
          if (polygon.top() >= y + 1) break;
          if (polygon.bottom() > y) scanline.add(polygon);
        }
        scanline.deposit();
      }
    });
  });
  block.counters.queries += static_cast<std::uint64_t>(block.width) * static_cast<std::uint64_t>(block.height);
}

}  // namespace area
