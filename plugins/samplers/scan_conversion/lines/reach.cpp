#include "reach.h"

namespace scan_conversion {

namespace {

// Moves `end` to where the line has this coordinate, or leaves it.
bool cut(moire::Point& end, moire::Point other, double moire::Point::*axis, double moire::Point::*across) {
  if (std::abs(end.*axis) <= farthest) return true;
  const double limit = std::copysign(farthest, end.*axis);
  if (limit > 0 ? other.*axis > limit : other.*axis < limit) return false;
  // Quarters, since the difference of two doubles may be none.
  const double t = (limit / 4 - other.*axis / 4) / (end.*axis / 4 - other.*axis / 4);
  end.*across = (1 - t) * other.*across + t * end.*across;
  end.*axis = limit;
  return true;
}

}  // namespace

std::optional<Ends> within_reach(moire::Point from, moire::Point to) {
  constexpr auto x = &moire::Point::x, y = &moire::Point::y;
  if (cut(from, to, x, y) && cut(to, from, x, y) && cut(from, to, y, x) && cut(to, from, y, x)) return Ends{from, to};
  return std::nullopt;
}

}  // namespace scan_conversion
