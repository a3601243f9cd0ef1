#include "sampling/filtered_rendering.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include <fmt/format.h>

#include <moire/error.h>
#include <moire/probe.h>

#include "sampling/filters.h"
#include "sampling/spacing.h"

namespace moire {

FilterAxis::FilterAxis(const FilterChoice& choice, double spacing, double shift)
    : filter_(make_filter(choice.name, choice.settings, spacing)),
      reach_(std::max(0, static_cast<int>(std::ceil(filter_->radius() + 0.5 + shift)) - 1)) {}

void FilterAxis::weigh(double place, std::vector<double>& weights) const {
  weights.clear();
  for (int pixel = -reach_; pixel <= reach_; ++pixel) weights.push_back(filter_->at(place - (pixel + 0.5)));
}

// What is seen at the points of one image column, a slot a point, and what it counts in the pixels around.
class FilteredRendering::Column {
  // Of a place in a pixel, along both axes.
  struct Taps {
    Point place;
    std::vector<double> across, down;
  };

 public:
  Column(const FilteredRendering& rendering, const PixelBlock& block)
      : rendering_(rendering),
        top_(block.y0 - rendering.down_.reach()),
        height_(block.height + 2 * rendering.down_.reach()),
        probe_(rendering.request_, rendering.spacing_),
        seen_(0, block.recording()) {}

  void look_at(int x, Counters& counters) {
    x_ = x;
    if (strands_ && rendering_.sampler_.same_in_every_pixel()) {
      strands_->move_to(x);
    } else {
      const Pixel pixel{x, 0, rendering_.request_.frame_number, rendering_.request_.seed};
      strands_ = Strands::with_places(rendering_.sampler_, pixel, top_, height_, rendering_.shift_);
    }
    std::size_t points = 0;
    for (const Strand& strand : strands_->all()) points += strand.points.size();
    seen_.reset(points);
    std::size_t first = 0;
    for (const Strand& strand : strands_->all()) {
      probe_.see(
          strand.points, seen_, [&](std::size_t k) { return first + k; }, [](std::size_t) { return 1.0; });
      first += strand.points.size();
    }
    counters += seen_.counters;
  }

  // Adds to the slots of the block's pixels.
  void add_to(const PixelBlock& block, Tally& sums) {
    known_.resize(strands_->all().size());
    std::size_t point = 0;
    for (std::size_t s = 0; s < known_.size(); ++s) {
      const Strand& strand = strands_->all()[s];
      std::size_t in_pixel = 0;
      for (std::size_t k = 0; k < strand.points.size(); ++k, ++point) {
        in_pixel = k > 0 && strand.rows[k] == strand.rows[k - 1] ? in_pixel + 1 : 0;
        const int y = top_ + static_cast<int>(strand.rows[k]);
        add(point, y, strand.weights[k], taps(known_[s], in_pixel, strand.places[k]), block, sums);
      }
    }
  }

 private:
  // Most patterns have their places in every pixel again.
  const Taps& taps(std::vector<Taps>& known, std::size_t in_pixel, Point place) const {
    if (in_pixel == known.size()) known.emplace_back();
    Taps& taps = known[in_pixel];
    if (taps.across.empty() || taps.place != place) {
      taps.place = place;
      rendering_.across_.weigh(place.x, taps.across);
      rendering_.down_.weigh(place.y, taps.down);
    }
    return taps;
  }

  // A point of the pixel at row y.
  void add(std::size_t point, int y, double weight, const Taps& taps, const PixelBlock& block, Tally& sums) const {
    const int right = rendering_.across_.reach(), down = rendering_.down_.reach();
    const int first_x = std::max(x_ - right, block.x0), end_x = std::min(x_ + right + 1, block.x0 + block.width);
    const int first_y = std::max(y - down, block.y0), end_y = std::min(y + down + 1, block.y0 + block.height);
    for (int x = first_x; x < end_x; ++x) {
      const double across = weight * taps.across[static_cast<std::size_t>(x - x_ + right)];
      if (across == 0) continue;
      for (int row = first_y; row < end_y; ++row) {
        const double both = across * taps.down[static_cast<std::size_t>(row - y + down)];
        if (both != 0) sums.mix(block.slot(x, row), seen_, point, both);
      }
    }
  }

  const FilteredRendering& rendering_;
  int x_ = 0;
  const int top_, height_;  // of the block and its margin
  std::optional<Strands> strands_;
  Probe probe_;
  Tally seen_;
  std::vector<std::vector<Taps>> known_;  // of each strand, of the points that it last had in a pixel
};

FilteredRendering::FilteredRendering(const PointSampler& sampler, const RenderRequest& request,
                                     const FilterChoice& filter)
    : sampler_(sampler),
      request_(request),
      spacing_(spacing_of(sampler, request)),
      shift_(is_centred_on_points(filter.name) ? shift_to_middle(sampler, request) : Point{}),
      across_(filter, spacing_.x, shift_.x),
      down_(filter, spacing_.y, shift_.y) {}

void FilteredRendering::render(PixelBlock& block) const {
  Tally sums(block.slots(), block.recording());
  Column column(*this, block);
  for (int x = block.x0 - across_.reach(); x < block.x0 + block.width + across_.reach(); ++x) {
    column.look_at(x, block.counters);
    column.add_to(block, sums);
  }
  for (int x = block.x0; x < block.x0 + block.width; ++x) {
    for (int y = block.y0; y < block.y0 + block.height; ++y) {
      const std::size_t slot = block.slot(x, y);
      const double sum = sums.weight(slot);
      if (sum == 0 || !std::isfinite(sum)) {
        throw Error(fmt::format(
            "pixel ({}, {}): the filter gives the points around it weights that sum to {}; the sum is a finite number "
            "other than 0: take more points, or a wider filter",
            x, y, sum));
      }
      block.mix(slot, sums, slot, 1 / sum);
    }
  }
}

}  // namespace moire
