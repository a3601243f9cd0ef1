// Two-point lines: in every column the two pixels around the line, each by how near it is. After Wu 1991,
// doi:10.1145/122718.122734, mended: weights at the right pixels, the middle column once, slope 1 a case of its own.
#pragma once

#include "columns.h"
#include "octant.h"
#include "pen.h"
#include "reach.h"

namespace scan_conversion {

enum class LineMethod { accumulator, direct, fujimoto_iwata };

struct TwoPointLines {
  LineMethod method = LineMethod::accumulator;
  int bits = 32;        // n of the accumulator
  int grey_bits = 8;    // m: intensities are of 2^m - 1
  bool ceiling = true;  // d = ceil(k 2^n), else floor(k 2^n + 1/2)
  bool both_ends = true;

  std::uint32_t full() const { return (std::uint32_t{1} << grey_bits) - 1; }
  // Whether a line of so many columns, that many of them counted from one end, is too long for d = ceil(k 2^n) to be
  // exact, and a word of 64 bits may mend it. The error grows by less than 2^-n a column counted and the fraction is
  // 1 / columns of a level short of the next one, or more: exact while counted * columns <= 2^(n - m).
  bool is_wide(double columns, double counted) const {
    return bits > 32 || (bits == 32 && ceiling && counted * columns > std::ldexp(1.0, bits - grey_bits));
  }
  int word_bits(bool wide) const { return wide && bits <= 32 ? 64 : bits; }
  // d of n bits, 2^n where it does not fit. Requires: 0 <= rise <= columns, 0 < columns.
  Wide increment(std::int64_t rise, std::int64_t columns, int n) const;
  Wide increment(double slope, int n) const;
};

inline Wide TwoPointLines::increment(std::int64_t rise, std::int64_t columns, int n) const {
  const auto divide = [this, columns](auto numerator) {
    const auto c = static_cast<decltype(numerator)>(columns);
    return ceiling ? (numerator + c - 1) / c : (2 * numerator + c) / (2 * c);
  };
  const Wide numerator = static_cast<Wide>(rise) << n;
  // The machine divides 64 bits much faster.
  if (numerator >> 60 == 0) return divide(static_cast<std::uint64_t>(numerator));
  return divide(numerator);
}
inline Wide TwoPointLines::increment(double slope, int n) const {
  const double scaled = std::ldexp(slope, n);
  return static_cast<Wide>(ceiling ? std::ceil(scaled) : std::floor(scaled + 0.5));
}

namespace two_point {

// One after another: the pixels of `columns`.
template <class Walk, class Put>
void draw(const Octant& octant, Walk walk, Range columns, Put&& put) {
  if (columns.empty()) return;
  walk.go_to(columns.first);
  Pen pen(put, octant, columns.first, walk.row_at(columns.first));
  for (std::int64_t i = columns.first; i < columns.end; ++i) {
    const std::uint32_t lower = walk.lower(), upper = walk.upper();
    const int rows = walk.next();
    pen.put(lower);
    pen.put_above(upper);
    pen.move(rows);
  }
}

// The same columns from both ends at once, which share all that is computed. Requires: the line rises.
template <class Walk, class Put>
void draw(const Octant& a, const Octant& b, Walk walk, Range columns, Put&& put) {
  if (columns.empty()) return;
  walk.go_to(columns.first);
  const std::int64_t row = walk.row_at(columns.first);
  Pen near(put, a, columns.first, row), far(put, b, columns.first, row);
  for (std::int64_t i = columns.first; i < columns.end; ++i) {
    const std::uint32_t lower = walk.lower(), upper = walk.upper();
    const int rows = walk.next();
    near.put(lower);
    near.put_above(upper);
    far.put(lower);
    far.put_above(upper);
    near.move(rows);
    far.move(rows);
  }
}

template <class Walk, class Put>
void draw_visible(const Octant& octant, const Walk& walk, Range columns, const moire::PixelArea& area, Put& put) {
  const Visible part = visible(octant, columns, area, 0, 1, [&](std::int64_t i) { return walk.row_at(i); });
  if (part.all) {
    draw(octant, walk, part.columns, put);
  } else {
    draw(octant, walk, part.columns, Clipped{area, put});
  }
}

// From one end or from both towards the middle, where the column of an even number belongs to the first.
template <class Walk, class Put>
void draw_line(bool both_ends, const Octant& near, bool inside, const Walk& walk, const moire::PixelArea& area,
               Put& put) {
  const auto draw_columns = [&](const Octant& octant, Range columns) {
    inside ? draw(octant, walk, columns, put) : draw_visible(octant, walk, columns, area, put);
  };
  if (!both_ends) return draw_columns(near, {0, near.columns + 1});
  const Octant far = reversed(near);
  const std::int64_t mirrored = (near.columns + 1) / 2;
  if (inside) {
    draw(near, far, walk, {0, mirrored}, put);
  } else {
    draw_columns(near, {0, mirrored});
    draw_columns(far, {0, mirrored});
  }
  if (near.columns % 2 == 0) draw_columns(near, {mirrored, mirrored + 1});
}

// Lines along pixels and along their diagonals: one pixel a column.
template <class Put>
void draw_single(PixelIndex from, PixelIndex to, std::uint32_t full, const moire::PixelArea& area, Put& put) {
  const Octant octant = octant_of(from, to);
  const int rise = octant.rise == 0 ? 0 : 1;
  const auto row_at = [rise](std::int64_t i) { return rise * i; };
  const Range columns = visible(octant, {0, octant.columns + 1}, area, 0, 0, row_at).columns;
  for (std::int64_t i = columns.first; i < columns.end; ++i) {
    put(static_cast<int>(octant.x(i, rise * i)), static_cast<int>(octant.y(i, rise * i)), full);
  }
}

}  // namespace two_point

// Calls use(walk) with the line's columns by the method asked for. Requires: 0 < rise < columns.
template <class Use>
void with_columns(const TwoPointLines& how, const Octant& octant, Use use) {
  const Slope slope{static_cast<double>(octant.columns), static_cast<double>(octant.rise)};
  if (how.method == LineMethod::direct) return use(Direct<false>(slope, how.grey_bits));
  if (how.method == LineMethod::fujimoto_iwata) return use(PerPixel<false>(slope, how.grey_bits));
  const bool wide = how.is_wide(slope.columns, how.both_ends ? slope.columns / 2 : slope.columns);
  const int n = how.word_bits(wide);
  const Wide d = how.increment(octant.rise, octant.columns, n);
  if (d >> n != 0) return use(Straight(1, 0, how.grey_bits));
  if (wide) return use(Accumulator<std::uint64_t>(static_cast<std::uint64_t>(d << (64 - n)), 0, how.grey_bits));
  use(Accumulator<std::uint32_t>(static_cast<std::uint32_t>(d << (32 - n)), 0, how.grey_bits));
}

// From the middle of one pixel to that of another.
template <class Put>
void two_point_line(const TwoPointLines& how, PixelIndex from, PixelIndex to, const moire::PixelArea& area, Put&& put) {
  const Octant octant = octant_of(from, to);
  if (octant.rise == 0 || octant.rise == octant.columns) {
    return two_point::draw_single(from, to, how.full(), area, put);
  }
  const bool inside = is_inside(from, to, area);
  with_columns(how, octant,
               [&](const auto& walk) { two_point::draw_line(how.both_ends, octant, inside, walk, area, put); });
}

}  // namespace scan_conversion
