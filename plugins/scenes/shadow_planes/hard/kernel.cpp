#include "hard/kernel.h"

namespace shadow_planes {

namespace {

[[gnu::target("avx2")]] void add_wide(const KernelRow& row, int begin, int end, float part, float* cells) {
  detail::add_kernel(row, begin, end, part, cells);
}

void add_narrow(const KernelRow& row, int begin, int end, float part, float* cells) {
  detail::add_kernel(row, begin, end, part, cells);
}

const bool has_wide_vectors = __builtin_cpu_supports("avx2");

}  // namespace

void detail::add_long_run(const KernelRow& row, int begin, int end, float part, float* cells) {
  (has_wide_vectors ? add_wide : add_narrow)(row, begin, end, part, cells);
}

void add_flat(const KernelRow& row, int begin, int end, float part, float* cells) {
  const float x0 = row.x0, step = row.step, sent = row.sent, turn = row.turn;
  for (int i = begin; i < end; ++i) {
    const float x = x0 + step * static_cast<float>(i);
    cells[i] += sent + turn * x > 0 ? part : 0;
  }
}

}  // namespace shadow_planes
