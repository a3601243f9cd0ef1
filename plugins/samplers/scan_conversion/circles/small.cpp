#include "small.h"

#include <algorithm>

namespace scan_conversion {

namespace {

// Of the disk within the rectangle between (0, 0) and (x, y), negative where one of them is.
double disk_to_corner(double x, double y, double radius) {
  const double width = std::min(std::abs(x), radius), height = std::min(std::abs(y), radius);
  // The integral of the circle's upper half from 0.
  const auto under = [radius](double t) {
    const double h = std::sqrt(std::max((radius - t) * (radius + t), 0.0));
    return (t * h + radius * radius * std::atan2(t, h)) / 2;
  };
  // The rectangle's upper edge lies inside up to here.
  const double edge = std::min(width, std::sqrt((radius - height) * (radius + height)));
  const double area = height * edge + under(width) - under(edge);
  return (x < 0) != (y < 0) ? -area : area;
}

double disk_in_pixel(double x, double y, double radius) {
  if (radius <= 0) return 0;
  return disk_to_corner(x + 1, y + 1, radius) - disk_to_corner(x, y + 1, radius) - disk_to_corner(x + 1, y, radius) +
         disk_to_corner(x, y, radius);
}

}  // namespace

double annulus_in_pixel(double x, double y, double radius) {
  return std::clamp(disk_in_pixel(x, y, radius + 0.5) - disk_in_pixel(x, y, radius - 0.5), 0.0, 1.0);
}

}  // namespace scan_conversion
