// The filters: how points are weighed into pixels. A new one is a file in filters/ and a line in filters.cpp.
#pragma once

#include <memory>
#include <span>
#include <string_view>

#include <moire/filter.h>
#include <moire/settings.h>

#include "config/experiment.h"

namespace moire {

// "box" first.
std::span<const NamedSummary> filters();

// One axis of a filter. `spacing`: between the points that it will weigh, pixels. Null for "box": all points of a pixel
// and no others. Requires: a name from filters(), what `settings` lacks of its table has its default.
std::unique_ptr<Filter> make_filter(std::string_view name, const Settings& settings, double spacing);

// The lecture's integer tables (Maddock, Table 4.1) as a function of the distance: 1 2 .. r .. 2 1 over r, r = (taps +
// 1) / 2, on points that are `spacing` apart, so that it is a tent of r points on either side.
std::unique_ptr<Filter> make_bartlett(int taps, double spacing);
std::unique_ptr<Filter> make_tent(double radius);
std::unique_ptr<Filter> make_gaussian(double sigma);
std::unique_ptr<Filter> make_mitchell(double b, double c);
std::unique_ptr<Filter> make_lanczos(int lobes);

// Whether a filter's window is centred on a point: patterns with an even number of points across a pixel are then moved
// by half their spacing.
bool is_centred_on_points(std::string_view name);

}  // namespace moire
