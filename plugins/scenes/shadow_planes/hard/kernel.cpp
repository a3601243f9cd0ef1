#include "hard/kernel.h"

namespace shadow_planes {

// Plain loops that compilers turn into vectors: a cell's value depends on its index alone, not on where a run begins.
void add_kernel(const KernelRow& row, int begin, int end, float part, float* cells) {
  const float x0 = row.x0, step = row.step, square = row.square, sent = part * row.sent, turn = part * row.turn;
  for (int i = begin; i < end; ++i) {
    const float x = x0 + step * static_cast<float>(i);
    const float r2 = square + x * x;
    const float share = sent + turn * x;
    cells[i] += (share > 0 ? share : 0) / (r2 * r2);
  }
}

void add_flat(const KernelRow& row, int begin, int end, float part, float* cells) {
  const float x0 = row.x0, step = row.step, sent = row.sent, turn = row.turn;
  for (int i = begin; i < end; ++i) {
    const float x = x0 + step * static_cast<float>(i);
    cells[i] += sent + turn * x > 0 ? part : 0;
  }
}

}  // namespace shadow_planes
