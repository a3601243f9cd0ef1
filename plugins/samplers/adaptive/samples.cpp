#include "samples.h"

namespace adaptive {

void Samples::look_at(std::span<const moire::SamplePoint> points, std::span<const std::size_t> ends,
                      moire::Spacing spacing, moire::Counters& counters) {
  const std::size_t first = seen_.size();
  moire::Tally& tally = rounds_.emplace_back(Round{first, moire::Tally(points.size(), recording_)}).tally;
  seen_.resize(first + points.size());
  moire::Probe probe(request_, spacing);
  std::size_t begin = 0;
  for (const std::size_t end : ends) {
    const auto batch = points.subspan(begin, end - begin);
    probe.see(
        batch, tally, [&](std::size_t k) { return begin + k; }, [](std::size_t) { return 1.0; });
    for (std::size_t k = 0; k < batch.size(); ++k)
      seen_[first + begin + k] = {tally.color(begin + k), probe.element(k)};
    begin = end;
  }
  counters += tally.counters;
}

void Samples::add_to(moire::PixelBlock& block, std::size_t slot, std::size_t k, double weight) const {
  auto round = rounds_.end() - 1;
  while (round->first > k) --round;
  block.mix(slot, round->tally, k - round->first, weight);
}

}  // namespace adaptive
