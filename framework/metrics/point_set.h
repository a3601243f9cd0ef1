// How evenly the points of a pixel lie.
#pragma once

#include <span>
#include <vector>

#include <moire/geometry.h>

namespace moire {

// The L2 star discrepancy of points in the unit square, exactly: the root of the mean square, over all boxes from (0,
// 0) to (x, y), of the share of the points in the box less its area. Warnock 1972, "Computational investigations of
// low-discrepancy point sets". Requires: at least one point.
double star_discrepancy(std::span<const Point> points);

// |sum over the points of exp(-2 pi i f.x)|^2 / N at the whole frequencies f of the unit square up to `reach` cycles a
// pixel: a mean over rings one cycle wide, as points of frequency and power. Points drawn at random have 1 everywhere.
std::vector<Point> point_power(std::span<const Point> points, int reach);

}  // namespace moire
