// A pattern of points under a filter that may reach beyond the pixel: neighbours share the points.
#pragma once

#include <memory>
#include <vector>

#include <moire/filter.h>
#include <moire/sampler.h>

#include "sampling/pattern_sampler.h"
#include "sampling/strands.h"

namespace moire {

// One axis of a filter, as weights of places in a pixel.
class FilterAxis {
 public:
  FilterAxis(const FilterChoice& choice, double spacing, double shift);

  // How many pixels on either side a point may count in.
  int reach() const { return reach_; }
  // Makes `weights` what a point at this place of a pixel counts in the pixels -reach() .. reach() behind that one.
  void weigh(double place, std::vector<double>& weights) const;

 private:
  std::unique_ptr<Filter> filter_;
  int reach_;
};

// Points of a block and of a margin around it are looked at once, in strands as under the box, and count in every
// pixel by the filter at their place, which of jittered points is that of the grid; each pixel is then divided by the
// sum of its weights. Margins may lie outside the image. What a pixel is added up from, and in which order, is the same
// in every block: column by column, strand by strand, from the bottom to the top.
//
// Filters with negative lobes leave fragments of negative weight. Weights of a pixel still sum to 1; an element's share
// is what remains of its fragments, and may be less than nothing.
class FilteredRendering final : public Rendering {
 public:
  // Requires: the filter is not the box.
  FilteredRendering(const PointSampler& sampler, const RenderRequest& request, const FilterChoice& filter,
                    LightSeed light_seed);

  // Error: the weights of a pixel have no sum to divide by.
  void render(PixelBlock& block) const override;

 private:
  struct Pixels;
  class Column;

  const PointSampler& sampler_;
  RenderRequest request_;
  LightSeed light_seed_;
  Spacing spacing_;
  Point shift_;
  FilterAxis across_, down_;
};

}  // namespace moire
