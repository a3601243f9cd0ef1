#include "samples.h"

#include <cmath>

#include <moire/lattice.h>
#include <moire/random.h>

namespace adaptive {

namespace {

// A random point of the light for a place of the image.
moire::LightPoint light_at(moire::Point place, std::uint64_t seed) {
  const double x = std::floor(place.x), y = std::floor(place.y);
  const moire::Pixel pixel{static_cast<int>(x), static_cast<int>(y), 0, seed};
  const auto across = static_cast<std::uint32_t>(0x1p32 * (place.x - x));
  const auto down = static_cast<std::uint32_t>(0x1p32 * (place.y - y));
  return {moire::fraction(moire::random(pixel, across, down)), moire::fraction(moire::random(pixel, down, ~across))};
}

}  // namespace

void Samples::look_at(std::span<moire::SamplePoint> points, std::span<const std::size_t> ends, moire::Spacing spacing,
                      moire::Counters& counters) {
  const std::size_t first = seen_.size();
  moire::Tally& tally = rounds_.emplace_back(Round{first, moire::Tally(points.size(), recording_)}).tally;
  seen_.resize(first + points.size());
  moire::Probe probe(request_, spacing);
  if (request_.frame.receivers()) {
    for (moire::SamplePoint& point : points) {
      const moire::LightPoint light = light_at({point.x, point.y}, request_.seed);
      point.u = light.u, point.v = light.v;
    }
  }
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
