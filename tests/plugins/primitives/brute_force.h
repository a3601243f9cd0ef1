// What is seen of lines and circles, by distances in long double; and curves to see.
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "primitives/seeing/frame.h"

namespace moire::test {

// How deep a point is inside of a curve, in pixels: how far its outline is, or less at corners; negative outside.
long double depth(const primitives::Curve& curve, Point p);

// The element in front; nothing if the outline of a curve that matters is nearer than `unsure` pixels.
std::optional<Element> seen_at(const std::vector<primitives::Curve>& curves, Point p, long double unsure);

// Lines of all caps and angles, rings and disks, from hairlines to some as wide as the image, in and around an image
// of this size. Some are upright, level or at 45 degrees, some without length, radius or width.
std::vector<primitives::Curve> random_curves(int count, ImageSize size, std::uint64_t seed);

std::unique_ptr<Frame> frame_of(std::vector<primitives::Curve> curves, ImageSize size, double tolerance = 0.01);

// The element at each point.
std::vector<Element> elements_at(const Frame& frame, const std::vector<Point>& points);

}  // namespace moire::test
