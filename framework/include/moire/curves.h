// Lines and circles with their real end points, for samplers that draw them by formula.
#pragma once

#include <moire/color.h>
#include <moire/element.h>
#include <moire/geometry.h>

namespace moire {

// How a line ends: at its end point, half a width behind it, or in half a disk around it.
enum class Cap { butt, square, round };

// All lengths in pixels of the image. A width is at least 0; one of 0, and a line without length and round caps or
// square ones, covers no area, and methods that draw pixels instead of areas draw it all the same.
struct LineCurve {
  Element element;
  Color color;
  Point from, to;
  double width = 1;
  Cap cap = Cap::butt;
};

// What lies within width / 2 of the circle of this radius. Where width > 2 radius, it is a disk.
struct CircleCurve {
  Element element;
  Color color;
  Point center;
  double radius = 0, width = 1;
};

class CurveSink {
 public:
  virtual ~CurveSink() = default;
  virtual void line(const LineCurve&) = 0;
  virtual void circle(const CircleCurve&) = 0;
};

// The curves that make up the picture.
class Curves {
 public:
  virtual ~Curves() = default;
  // All of them, those in front last (painter's order). All numbers are finite.
  virtual void stream(CurveSink& sink) const = 0;
  virtual Color background_color() const = 0;
};

}  // namespace moire
