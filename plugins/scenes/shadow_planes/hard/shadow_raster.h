// Which cells of a map the hard shadows of one light point leave lit.
#pragma once

#include <algorithm>
#include <bit>
#include <cstdint>
#include <vector>

#include <moire/receivers.h>

#include "seeing/outline.h"

namespace shadow_planes {

class ShadowRaster {
 public:
  ShadowRaster(int columns, int rows, moire::ShadowEdges edges);

  // No shadows.
  void clear();
  // A convex shadow in coordinates of cells, within the map. Where shadows overlap they count once: by area, the part
  // of a new one that no other covers is cut into convex pieces.
  void add(const Outline& shadow);
  // After all are added: rows may be asked for.
  void sort();

  // Calls lit(begin, end, part) for runs of cells of a row, left to right, that are lit in this part (0 .. 1) of each
  // cell; those in full shadow are left out. By area, parts are exact but for rounding.
  template <class Lit>
  void row(int j, Lit lit) {
    gather(j);
    double covered = 0;
    int begin = 0;
    const auto run_to = [&](int end) {
      const double part = is_by_area_ ? 1 - covered : (covered > 0.5 ? 0 : 1);
      // Sums of doubles return to 0 and 1 but for rounding.
      if (end > begin && part > rounding) lit(begin, end, part > 1 - rounding ? 1 : part);
      begin = end;
    };
    for (std::size_t word = 0; word < touched_.size(); ++word) {
      for (std::uint64_t bits = touched_[word]; bits != 0; bits &= bits - 1) {
        const std::size_t cell = 64 * word + static_cast<std::size_t>(std::countr_zero(bits));
        run_to(std::min(static_cast<int>(cell), columns_));
        covered += change_[cell];
        change_[cell] = 0;
      }
      touched_[word] = 0;
    }
    run_to(columns_);
  }

 private:
  static constexpr double rounding = 1e-9;

  // From its upper end (x0, y0) down; `sign` 1: what is right of it is covered from here, -1: no longer.
  struct Edge {
    double x0, y0, x1, y1, slope, sign;
  };

  void add_piece(const Outline& piece);
  // The changes of coverage along a row.
  void gather(int j);
  void cover(const Edge& edge, int j);
  void change(int cell, double by) {
    change_[static_cast<std::size_t>(cell)] += by;
    touched_[static_cast<std::size_t>(cell) / 64] |= std::uint64_t{1} << (cell % 64);
  }

  int columns_, rows_;
  bool is_by_area_;
  std::vector<Outline> shadows_;
  std::vector<moire::Rectangle> boxes_;
  std::vector<Edge> edges_;
  std::vector<std::uint32_t> first_, order_;  // of row j: edges order_[first_[j]] up to order_[first_[j + 1]]
  std::vector<double> change_;                // of coverage, from this cell on
  std::vector<std::uint64_t> touched_;        // a bit a cell
  std::vector<Outline> pieces_, next_;
  Outline inside_, outside_;
};

}  // namespace shadow_planes
