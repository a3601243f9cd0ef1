#include "upright.h"

#include <algorithm>
#include <numeric>
#include <vector>

namespace area {

namespace {

// Lines that a scene gets at once, if they come from more than one image column: enough to follow them side by side,
// and no more than a few megabytes of sums.
constexpr int batch = 32;

}  // namespace

void Upright::render(moire::PixelBlock& block) const {
  const auto rows = static_cast<std::size_t>(block.height);
  std::vector<double> cuts(rows + 1);
  std::iota(cuts.begin(), cuts.end(), 0.0);
  const double bottom = block.y0 + block.height, top = block.y0;
  const int columns = std::max(1, batch / lines_), end = block.x0 + block.width;

  std::vector<moire::ImageLine> lines;
  moire::Tally pieces(0, block.recording());
  for (int first = block.x0; first < end; first += columns) {
    const int last = std::min(first + columns, end);
    lines.clear();
    for (int x = first; x < last; ++x) {
      for (int line = 0; line < lines_; ++line) {
        const double across = x + (line + 0.5) / lines_;
        lines.push_back({{across, bottom}, {across, top}, cuts});
      }
    }
    pieces.reset(lines.size() * rows);
    request_.frame.lines()->along(lines, request_.lookup, pieces);

    std::size_t piece = 0;
    for (int x = first; x < last; ++x) {
      const std::size_t lowest = block.slot(x, block.y0 + block.height - 1);
      for (int line = 0; line < lines_; ++line) {
        for (std::size_t i = 0; i < rows; ++i) block.mix(lowest - i, pieces, piece++, 1.0 / lines_);
      }
    }
    block.counters += pieces.counters;
  }
}

}  // namespace area
