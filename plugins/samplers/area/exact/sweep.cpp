#include "exact/sweep.h"

#include "exact/rows.h"
#include "exact/swept_row.h"

namespace area {

Sweep::Sweep(const moire::RenderRequest& request)
    : size_(request.frame.size()),
      layers_(*request.frame.polygons(), {0, 0, static_cast<double>(size_.width), static_cast<double>(size_.height)}),
      chains_(layers_, size_.height, size_.width) {}

void Sweep::render(moire::PixelBlock& block) const {
  block.fill([&](auto add) {
    std::vector<PixelCell> cells(cells_of(size_.width));
    RowPixels pixels(layers_, size_.width, block, add, cells);
    SweptRow row(pixels);
    Rows rows(layers_, chains_, size_.width, row);
    rows.sweep(block.y0, block.y0 + block.height);
  });
  block.counters.queries += static_cast<std::uint64_t>(block.width) * static_cast<std::uint64_t>(block.height);
}

}  // namespace area
