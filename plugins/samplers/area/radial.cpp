#include "radial.h"

namespace area {

Radial::Radial(const moire::RenderRequest& request, int lines)
    : request_(request), fans_(fans(request.frame.size(), request.frame.lines()->pole().value(), lines)) {}

void Radial::render(moire::PixelBlock& block) const {
  Stretches stretches;
  moire::Tally pieces(0, block.recording());
  for (const Fan& fan : fans_) {
    for (int wedge = 0; wedge < fan.wedges(); ++wedge) {
      fan.stretches(wedge, block.x0, block.x0 + block.width, stretches);
      if (stretches.shares.empty()) continue;
      pieces.reset(stretches.cuts.size() - 1);
      const moire::ImageLine line{stretches.from, stretches.to, stretches.cuts};
      request_.frame.lines()->along({&line, 1}, request_.lookup, pieces);
      for (std::size_t i = 0; i < pieces.slots(); ++i) {
        for (std::size_t s = stretches.first[i]; s < stretches.first[i + 1]; ++s) {
          const Share& share = stretches.shares[s];
          block.mix(block.slot(share.x, share.y), pieces, i, share.width * stretches.along_per_distance);
        }
      }
      block.counters += pieces.counters;
    }
  }
}

}  // namespace area
