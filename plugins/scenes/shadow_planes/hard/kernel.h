// Irradiance from one point of an area light along a row of cells.
#pragma once

namespace shadow_planes {

// Seen from the light's foot on the receiver's plane, x is how far along the row a cell's middle is: x0 + step * i.
struct KernelRow {
  float x0, step;
  float square;      // of the light's distance from the row's line
  float sent, turn;  // what the light sends to x = 0, times the receiver's cosine, and how that changes with x
};

namespace detail {

// A plain loop that compilers turn into vectors. A cell's value depends on its index alone, not on where a run begins,
// and without contraction of products it has the same bits in vectors of any width.
[[gnu::always_inline]] inline void add_kernel(const KernelRow& row, int begin, int end, float part, float* cells) {
  const float x0 = row.x0, step = row.step, square = row.square, sent = part * row.sent, turn = part * row.turn;
  for (int i = begin; i < end; ++i) {
    const float x = x0 + step * static_cast<float>(i);
    const float r2 = square + x * x;
    const float share = sent + turn * x;
    cells[i] += (share > 0 ? share : 0) / (r2 * r2);
  }
}

void add_long_run(const KernelRow& row, int begin, int end, float part, float* cells);

}  // namespace detail

// Adds part max(0, sent + turn x) / (square + x^2)^2 to cells begin .. end - 1 of a row.
inline void add_kernel(const KernelRow& row, int begin, int end, float part, float* cells) {
  if (end - begin == 1) {  // at a shadow's edge
    detail::add_kernel(row, begin, begin + 1, part, cells);
  } else {
    detail::add_long_run(row, begin, end, part, cells);
  }
}

// Adds `part` where sent + turn x is above 0.
void add_flat(const KernelRow& row, int begin, int end, float part, float* cells);

}  // namespace shadow_planes
