// Everything that draws a line or a circle, under one signature.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "circles/gupta_sproull.h"
#include "circles/midpoint.h"
#include "circles/two_point.h"
#include "lines/gupta_sproull.h"
#include "lines/real_ends.h"
#include "picture.h"

namespace moire::test {

// Draws from one point to another, or rounds them to pixels, into the area.
struct LineKernel {
  std::string name;
  std::function<void(Point from, Point to, const PixelArea& area, Picture& picture)> draw;
};

inline std::vector<LineKernel> line_kernels() {
  using namespace scan_conversion;
  std::vector<LineKernel> kernels{
      {"bresenham", [](Point a, Point b, const PixelArea& area,
                       Picture& picture) { bresenham_line(pixel_of(a), pixel_of(b), area, picture); }},
      {"gupta_sproull", [](Point a, Point b, const PixelArea& area, Picture& picture) {
         gupta_sproull_line(pixel_of(a), pixel_of(b), area, picture);
       }}};
  const char* const names[] = {"accumulator", "direct", "fujimoto_iwata"};
  for (const LineMethod method : {LineMethod::accumulator, LineMethod::direct, LineMethod::fujimoto_iwata}) {
    for (const bool both_ends : {false, true}) {
      const TwoPointLines how{.method = method, .both_ends = both_ends};
      kernels.push_back({std::string(names[static_cast<int>(method)]) + (both_ends ? ", both ends" : ", one end"),
                         [how](Point a, Point b, const PixelArea& area, Picture& picture) {
                           two_point_line(how, pixel_of(a), pixel_of(b), area, picture);
                         }});
    }
    kernels.push_back({std::string(names[static_cast<int>(method)]) + ", real ends",
                       [method](Point a, Point b, const PixelArea& area, Picture& picture) {
                         two_point_line({.method = method}, a, b, area, picture);
                       }});
  }
  return kernels;
}

struct CircleKernel {
  std::string name;
  std::function<void(Point center, double radius, const PixelArea& area, Picture& picture)> draw;
};

// Radii from 3 on.
inline std::vector<CircleKernel> circle_kernels() {
  using namespace scan_conversion;
  const auto rounded = [](Point center, double radius) { return PixelCircle{pixel_of(center), whole(radius + 0.5)}; };
  const auto by_table = [rounded](auto tie_rule, int bits) {
    return [=](Point c, double r, const PixelArea& area, Picture& picture) {
      const PixelCircle circle = rounded(c, r);
      const RootTable table(circle.radius, bits);
      two_point_circle(circle, TableBand<decltype(tie_rule)::value>(table, 8), 255, area, picture);
    };
  };
  return {{"midpoint", [=](Point c, double r, const PixelArea& area,
                           Picture& picture) { midpoint_circle(rounded(c, r), area, picture); }},
          {"gupta_sproull", [=](Point c, double r, const PixelArea& area,
                                Picture& picture) { gupta_sproull_circle(rounded(c, r), area, picture); }},
          {"roots",
           [=](Point c, double r, const PixelArea& area, Picture& picture) {
             const PixelCircle circle = rounded(c, r);
             two_point_circle(circle, RootBand(circle.radius, 8), 255, area, picture);
           }},
          {"table", by_table(std::true_type{}, 8)},
          {"wide table", by_table(std::false_type{}, 16)},
          {"real", [](Point c, double r, const PixelArea& area, Picture& picture) {
             two_point_circle(c, r, 8, area, picture);
           }}};
}

}  // namespace moire::test
