// Pieces of boundaries, seen from a square: (0, 0) is its upper left corner, and its side is the unit.
#pragma once

namespace area {

// Where a x + b y + c >= 0.
struct HalfPlane {
  double a, b, c;

  double at(double x, double y) const { return a * x + b * y + c; }
};

// Where excess + 2 (x, y) . center - x^2 - y^2 >= 0: `excess` is radius^2 - center^2 without the digits that the
// difference of their squares would lose, so that the circle is where it is however far off its centre lies.
struct LocalDisk {
  double excess, x, y, radius;

  double at(double px, double py) const { return excess + px * (2 * x - px) + py * (2 * y - py); }
};

}  // namespace area
