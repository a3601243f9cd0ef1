#include "run/column_line.h"

#include <numeric>

namespace moire {

void ColumnLine::render(PixelBlock& block) const {
  const auto rows = static_cast<std::size_t>(block.height);
  std::vector<double> cuts(rows + 1);
  std::iota(cuts.begin(), cuts.end(), 0.0);
  Tally line(rows, block.recording());
  for (int x = block.x0; x < block.x0 + block.width; ++x) {
    line.reset(rows);
    const double middle = x + 0.5, bottom = block.y0 + block.height, top = block.y0;
    const ImageLine upright{{middle, bottom}, {middle, top}, cuts};
    frame_.lines()->along({&upright, 1}, nullptr, line);
    for (std::size_t i = 0; i < rows; ++i) {
      block.mix(block.slot(x, block.y0 + block.height - 1 - static_cast<int>(i)), line, i, 1);
    }
  }
}

}  // namespace moire
