// How far the points of a pattern are apart, and where its middle one lies.
#pragma once

#include <moire/sampler.h>

namespace moire {

// What the pattern says itself, else the root of the number of points each way.
Spacing spacing_of(const PointSampler& sampler, const RenderRequest& request);

// How far the points must go, to the left and upward, for one of their places to be a pixel's middle: half their
// spacing along each axis where a regular pattern has an even number of them across a pixel, or nothing.
Point shift_to_middle(const PointSampler& sampler, const RenderRequest& request);

}  // namespace moire
