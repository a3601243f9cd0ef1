// Where a circle h(j) = sqrt(r^2 - j^2) runs in the rows of its first octant, row by row:
//   go_to(j)    to a row
//   next()      to the next one
//   i()         of the pixel outside, ceil(h)
//   inner()     intensity of pixel i - 1, of 2^grey_bits - 1; that of pixel i is its bitwise inverse
// Convention, that of lines: inner = floor(2^m (ceil(h) - h)).
#pragma once

#include <vector>

#include "octants.h"

namespace scan_conversion {

// By a root in every row; the right rows to radii of 2^26.
class RootBand {
 public:
  RootBand(std::int64_t radius, int grey_bits)
      : radius_(static_cast<double>(radius)), scale_(std::ldexp(1.0, grey_bits)) {}

  void go_to(std::int64_t j) {
    j_ = static_cast<double>(j);
    set();
  }
  void next() {
    j_ += 1;
    set();
  }
  std::int64_t i() const { return static_cast<std::int64_t>(ceiling_); }
  std::uint32_t inner() const { return static_cast<std::uint32_t>(static_cast<std::int32_t>(rest_ * scale_)); }

 private:
  void set() {
    const double h = std::sqrt((radius_ - j_) * (radius_ + j_));
    ceiling_ = std::ceil(h);
    rest_ = ceiling_ - h;
  }

  double radius_, scale_, j_ = 0, ceiling_ = 0, rest_ = 0;
};

// Wu's D(r, j), one radius of it: ceil(h) - h in rows 0 .. last_row + 1, rounded down to `bits`. The published table,
// of all radii to the largest, holds sqrt(2) / 4 times its square.
class RootTable {
 public:
  RootTable(std::int64_t radius, int bits);

  std::int64_t radius() const { return radius_; }
  int bits() const { return bits_; }
  std::uint32_t operator[](std::int64_t j) const { return values_[static_cast<std::size_t>(j)]; }

 private:
  std::int64_t radius_;
  int bits_;
  std::vector<std::uint32_t> values_;
};

// The band moves left where D falls from row to row. Where D stays equal it has moved one pixel or none: told by the
// slope, 2 j > i; without this rule by none, which fails from r = 505 on if D has 8 bits, and from none to 65,535 if it
// has 16.
template <bool tie_rule, class Table = RootTable>
class TableBand {
 public:
  TableBand(const Table& table, int grey_bits) : table_(table), shift_(table.bits() - grey_bits) {}

  void go_to(std::int64_t j) {
    RootBand root(table_.radius(), 1);
    root.go_to(j);
    i_ = root.i();
    d_ = table_[j];
    j_ = j;
  }
  void next() {
    const std::uint32_t before = d_;
    d_ = table_[++j_];
    i_ -= d_ < before || (tie_rule && d_ == before && 2 * j_ > i_) ? 1 : 0;
  }
  std::int64_t i() const { return i_; }
  std::uint32_t inner() const { return d_ >> shift_; }

 private:
  const Table& table_;
  int shift_;
  std::int64_t i_ = 0, j_ = 0;
  std::uint32_t d_ = 0;
};

// The pixel nearest to the circle, i = round(h), by the midpoint's side of it: in whole numbers, of any radius.
class MidpointBand {
 public:
  explicit MidpointBand(std::int64_t radius) : radius_(radius) {}

  void go_to(std::int64_t j) {
    j_ = j;
    const double square = static_cast<double>(radius_ - j) * static_cast<double>(radius_ + j);
    i_ = static_cast<std::int64_t>(std::sqrt(std::max(square, 0.0))) + 2;
    const SignedWide side = SignedWide{i_ - radius_} * (i_ + radius_) - i_ + SignedWide{j} * j;
    side_ = static_cast<std::int64_t>(side);
    step_left();
  }
  void next() {
    side_ += 2 * j_ + 1;
    ++j_;
    step_left();
  }
  std::int64_t i() const { return i_; }

 private:
  void step_left() {
    while (side_ >= 0 && i_ > 0) side_ -= 2 * --i_;
  }

  // side = i^2 - i + j^2 - r^2: below 0 where the midpoint (i - 1/2, j) lies inside.
  std::int64_t radius_, i_ = 0, j_ = 0, side_ = 0;
};

}  // namespace scan_conversion
