// A rectangle of values, and a smooth surface through a square one.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace heightfield {

template <class Value>
struct Grid {
  int width = 0, height = 0;
  std::vector<Value> values;  // height x width, row 0 first

  Grid(int grid_width, int grid_height, Value value = {})
      : width(grid_width),
        height(grid_height),
        values(static_cast<std::size_t>(grid_width) * static_cast<std::size_t>(grid_height), value) {}

  std::size_t index(int x, int y) const {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x);
  }
  Value& at(int x, int y) { return values[index(x, y)]; }
  const Value& at(int x, int y) const { return values[index(x, y)]; }

  // The value of the nearest place inside.
  const Value& near(int x, int y) const { return at(std::clamp(x, 0, width - 1), std::clamp(y, 0, height - 1)); }
};

// The four weights of a uniform cubic B-spline, `t` of the way from the second to the third of its points. It does not
// pass through the values but has two continuous derivatives, which hides the grid.
struct SplineWeights {
  double w[4];
  explicit SplineWeights(double t) {
    const double s = 1 - t;
    w[0] = s * s * s / 6;
    w[1] = (4 - 3 * t * t * (2 - t)) / 6;
    w[2] = (4 - 3 * s * s * (2 - s)) / 6;
    w[3] = t * t * t / 6;
  }
};

// The B-spline surface over a grid; the value (x, y) has its centre at (x, y).
inline double smooth_value(const Grid<double>& grid, double x, double y) {
  const int x0 = static_cast<int>(std::floor(x)), y0 = static_cast<int>(std::floor(y));
  const SplineWeights across(x - x0), down(y - y0);
  double sum = 0;
  for (int j = 0; j < 4; ++j) {
    double row = 0;
    for (int i = 0; i < 4; ++i) row += across.w[i] * grid.near(x0 - 1 + i, y0 - 1 + j);
    sum += down.w[j] * row;
  }
  return sum;
}

}  // namespace heightfield
