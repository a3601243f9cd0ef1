// Where along a line pixels are put.
#pragma once

#include <concepts>
#include <cstddef>

#include "octant.h"

namespace scan_conversion {

// Targets whose pixels lie at even distances say so: put.place(x, y) is linear in x and y, and put.at(place, intensity)
// does what put(x, y, intensity) does. Lines then go from place to place by additions alone.
template <class Put>
concept Placed = requires(Put& put) {
  { put.place(0, 0) } -> std::same_as<std::ptrdiff_t>;
};

// At (column, row) of an octant, from column to column.
template <class Put>
class Pen {
 public:
  Pen(Put& put, const Octant& octant, std::int64_t column, std::int64_t row)
      : put_(put),
        at_(place(static_cast<int>(octant.x(column, row)), static_cast<int>(octant.y(column, row)))),
        column_(place(octant.column.x, octant.column.y) - place(0, 0)),
        row_(place(octant.row.x, octant.row.y) - place(0, 0)) {}

  void put(std::uint32_t intensity) { put_at(at_, intensity); }
  void put_above(std::uint32_t intensity) { put_at(at_ + row_, intensity); }
  void put_below(std::uint32_t intensity) { put_at(at_ - row_, intensity); }
  // To the next column, `rows` of them higher: 0 or 1.
  void move(int rows) { at_ = at_ + column_ + (row_ & -rows); }

 private:
  struct Pair {
    int x, y;
    friend Pair operator+(Pair a, Pair b) { return {a.x + b.x, a.y + b.y}; }
    friend Pair operator-(Pair a, Pair b) { return {a.x - b.x, a.y - b.y}; }
    friend Pair operator&(Pair a, int mask) { return {a.x & mask, a.y & mask}; }
  };
  using Place = std::conditional_t<Placed<Put>, std::ptrdiff_t, Pair>;

  Place place(int x, int y) const {
    if constexpr (Placed<Put>) {
      return put_.place(x, y);
    } else {
      return {x, y};
    }
  }
  void put_at(Place place, std::uint32_t intensity) {
    if constexpr (Placed<Put>) {
      put_.at(place, intensity);
    } else {
      put_(place.x, place.y, intensity);
    }
  }

  Put& put_;
  Place at_, column_, row_;
};

}  // namespace scan_conversion
