#include "sampling/spacing.h"

#include <algorithm>
#include <cmath>

namespace moire {

namespace {

Points points_of_a_pixel(const PointSampler& sampler, const RenderRequest& request) {
  Points points;
  sampler.points({0, 0, request.frame_number, request.seed}, points);
  return points;
}

// Regular places lie either on the pixel's middle, a whole number of spacings from it, or half a spacing beside.
double shift(double place, double spacing) {
  const double steps = (place - 0.5) / spacing;
  return std::abs(steps - std::round(steps)) < 0.25 ? 0 : spacing / 2;
}

}  // namespace

Spacing spacing_of(const PointSampler& sampler, const RenderRequest& request) {
  if (const auto spacing = sampler.spacing()) return *spacing;
  const Points points = points_of_a_pixel(sampler, request);
  const double apart = 1 / std::sqrt(static_cast<double>(std::max<std::size_t>(points.entries().size(), 1)));
  return {apart, apart};
}

Point shift_to_middle(const PointSampler& sampler, const RenderRequest& request) {
  const auto spacing = sampler.spacing();
  const Points points = points_of_a_pixel(sampler, request);
  if (!spacing || points.entries().empty()) return {};
  const Points::Entry& first = points.entries().front();
  return {shift(first.x - first.moved.x, spacing->x), shift(first.y - first.moved.y, spacing->y)};
}

}  // namespace moire
