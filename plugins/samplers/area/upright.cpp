#include "upright.h"

#include <numeric>

namespace area {

void Upright::render(moire::PixelBlock& block) const {
  const auto rows = static_cast<std::size_t>(block.height);
  std::vector<double> cuts(rows + 1);
  std::iota(cuts.begin(), cuts.end(), 0.0);
  moire::Tally pieces(rows, block.recording());
  const double bottom = block.y0 + block.height;
  for (int x = block.x0; x < block.x0 + block.width; ++x) {
    for (int line = 0; line < lines_; ++line) {
      const double across = x + (line + 0.5) / lines_;
      pieces.reset(rows);
      request_.frame.lines()->along({across, bottom}, {across, static_cast<double>(block.y0)}, cuts, request_.lookup,
                                    pieces);
      for (std::size_t i = 0; i < rows; ++i) {
        block.mix(block.slot(x, block.y0 + block.height - 1 - static_cast<int>(i)), pieces, i, 1.0 / lines_);
      }
      block.counters += pieces.counters;
    }
  }
}

}  // namespace area
