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

// What a block's pixels add up to before they are divided, in the order of its slots.
struct FilteredRendering::Pixels {
  std::vector<Tally::Sum> sums;
  Tally fragments;  // if they are recorded
};

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
    if (strands_ && rendering_.sampler_.same_in_every_pixel() && !rendering_.light_seed_) {
      strands_->move_to(x);
    } else {
      const Pixel pixel{x, 0, rendering_.request_.frame_number, rendering_.request_.seed};
      strands_ =
          Strands::with_places(rendering_.sampler_, pixel, top_, height_, rendering_.light_seed_, rendering_.shift_);
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

  // Adds to the pixels of the block. Where the places of a strand share x, as those of grids do, its points are added
  // up along the column first: each then counts in so many rows, and each row in so many columns.
  void add_to(const PixelBlock& block, Pixels& pixels) {
    known_.resize(strands_->all().size());
    std::size_t point = 0;
    for (std::size_t s = 0; s < known_.size(); ++s) {
      const Strand& strand = strands_->all()[s];
      const bool shares_x = std::all_of(strand.places.begin(), strand.places.end(),
                                        [&](Point place) { return place.x == strand.places.front().x; });
      rows_.assign(static_cast<std::size_t>(block.height), Tally::Sum{});
      std::size_t in_pixel = 0;
      for (std::size_t k = 0; k < strand.points.size(); ++k, ++point) {
        in_pixel = k > 0 && strand.rows[k] == strand.rows[k - 1] ? in_pixel + 1 : 0;
        const Taps& weights = taps(known_[s], in_pixel, strand.places[k]);
        const int y = top_ + static_cast<int>(strand.rows[k]);
        if (shares_x) {
          for_each_row(block, y, weights, [&](int row, double down) {
            add(rows_[static_cast<std::size_t>(row - block.y0)], seen_.sum(point), strand.weights[k] * down);
          });
        }
        if (shares_x && !block.recording()) continue;
        for_each_column(block, weights, [&](int x, double across) {
          for_each_row(block, y, weights, [&](int row, double down) {
            const double weight = strand.weights[k] * across * down;
            const std::size_t slot = block.slot(x, row);
            if (!shares_x) add(pixels.sums[slot], seen_.sum(point), weight);
            if (block.recording()) pixels.fragments.mix(slot, seen_, point, weight);
          });
        });
      }
      if (!shares_x || strand.points.empty()) continue;
      for_each_column(block, known_[s].front(), [&](int x, double across) {
        for (int row = 0; row < block.height; ++row)
          add(pixels.sums[block.slot(x, block.y0 + row)], rows_[static_cast<std::size_t>(row)], across);
      });
    }
  }

 private:
  static void add(Tally::Sum& to, const Tally::Sum& from, double factor) {
    to.add({factor * from.weight, factor * from.r, factor * from.g, factor * from.b});
  }

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

  // Calls visit(x, weight) for the block's columns in which points of this one count.
  template <class Visit>
  void for_each_column(const PixelBlock& block, const Taps& taps, Visit visit) const {
    for_each(taps.across, x_, rendering_.across_.reach(), block.x0, block.width, visit);
  }
  // Calls visit(row, weight) for the block's rows in which a point of the pixel at row y counts.
  template <class Visit>
  void for_each_row(const PixelBlock& block, int y, const Taps& taps, Visit visit) const {
    for_each(taps.down, y, rendering_.down_.reach(), block.y0, block.height, visit);
  }
  template <class Visit>
  static void for_each(const std::vector<double>& weights, int from, int reach, int begin, int count, Visit visit) {
    for (int k = std::max(from - reach, begin); k < std::min(from + reach + 1, begin + count); ++k) {
      const double weight = weights[static_cast<std::size_t>(k - from + reach)];
      if (weight != 0) visit(k, weight);
    }
  }

  const FilteredRendering& rendering_;
  int x_ = 0;
  const int top_, height_;  // of the block and its margin
  std::optional<Strands> strands_;
  Probe probe_;
  Tally seen_;
  std::vector<std::vector<Taps>> known_;  // of each strand, of the points that it last had in a pixel
  std::vector<Tally::Sum> rows_;          // of a strand
};

FilteredRendering::FilteredRendering(const PointSampler& sampler, const RenderRequest& request,
                                     const FilterChoice& filter, LightSeed light_seed)
    : sampler_(sampler),
      request_(request),
      light_seed_(light_seed),
      spacing_(spacing_of(sampler, request)),
      shift_(is_centred_on_points(filter.name) ? shift_to_middle(sampler, request) : Point{}),
      across_(filter, spacing_.x, shift_.x),
      down_(filter, spacing_.y, shift_.y) {}

void FilteredRendering::render(PixelBlock& block) const {
  Pixels pixels{std::vector<Tally::Sum>(block.slots()), Tally(block.slots(), block.recording())};
  Column column(*this, block);
  for (int x = block.x0 - across_.reach(); x < block.x0 + block.width + across_.reach(); ++x) {
    column.look_at(x, block.counters);
    column.add_to(block, pixels);
  }
  for (int x = block.x0; x < block.x0 + block.width; ++x) {
    for (int y = block.y0; y < block.y0 + block.height; ++y) {
      const double sum = pixels.sums[block.slot(x, y)].weight;
      if (sum != 0 && std::isfinite(sum)) continue;
      throw Error(fmt::format(
          "pixel ({}, {}): the filter gives the points around it weights that sum to {}; the sum is a finite number "
          "other than 0: take more points, or a wider filter",
          x, y, sum));
    }
  }
  block.fill([&](auto add) {
    for (std::size_t slot = 0; slot < block.slots(); ++slot) {
      const auto& [weight, r, g, b] = pixels.sums[slot];
      const double factor = 1 / weight;
      add.sum(slot, {factor * weight, factor * r, factor * g, factor * b});
      pixels.fragments.for_each(slot,
                                [&](const Fragment& f) { add.record(slot, f.element, factor * f.weight, f.color); });
    }
  });
}

}  // namespace moire
