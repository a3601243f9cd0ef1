#include "run/workers.h"

#include <algorithm>
#include <atomic>
#include <csignal>
#include <optional>

#include <tbb/enumerable_thread_specific.h>
#include <tbb/global_control.h>
#include <tbb/info.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

namespace moire {

namespace {

volatile std::sig_atomic_t interrupted = 0;

void note_interrupt(int) {
  interrupted = 1;
  std::signal(SIGINT, SIG_DFL);
}

}  // namespace

void catch_interrupts() { std::signal(SIGINT, note_interrupt); }
bool stop_requested() { return interrupted != 0; }

struct Workers::Arena {
  explicit Arena(int threads) : arena(threads) {
    // The smallest of all limits holds, so there is one only where it raises that of the cores.
    if (threads > tbb::info::default_concurrency())
      limit.emplace(tbb::global_control::max_allowed_parallelism, static_cast<std::size_t>(threads));
  }
  std::optional<tbb::global_control> limit;
  tbb::task_arena arena;
};

Workers::Workers(int threads, int block_width)
    : threads_(threads > 0 ? threads : tbb::info::default_concurrency()),
      block_width_(block_width),
      arena_(std::make_unique<Arena>(threads_)) {}

Workers::~Workers() = default;

void Workers::run_blocks(const Frame& frame, bool recording, Blocks order, BlockWork* work) const {
  const ImageSize size = frame.size();
  const Blend blend = frame.blend();
  const auto area = [&](std::size_t index) {
    const int first = static_cast<int>(index) * thickness(order);
    if (order == Blocks::rows) return PixelArea{0, first, size.width, std::min(thickness(order), size.height - first)};
    return PixelArea{first, 0, std::min(thickness(order), size.width - first), size.height};
  };
  const auto one = [&](std::size_t index, std::optional<PixelBlock>& block) {
    if (block) {
      block->move_to(area(index));
    } else {
      block.emplace(area(index), recording, order, blend);
    }
    (*work)(index, *block);
  };

  tbb::enumerable_thread_specific<std::optional<PixelBlock>> own;
  for_each(blocks(size, order), [&](std::size_t index) { one(index, own.local()); });
}

void Workers::for_each(std::size_t count, const std::function<void(std::size_t)>& work) const {
  const auto checked = [&](std::size_t index) {
    if (stop_requested()) throw Interrupted{};
    work(index);
  };
  if (threads_ == 1) {
    for (std::size_t index = 0; index < count; ++index) checked(index);
    return;
  }
  arena_->arena.execute([&] {
    tbb::parallel_for(
        tbb::blocked_range<std::size_t>(0, count, 1),
        [&](const auto& range) {
          for (std::size_t index = range.begin(); index < range.end(); ++index) checked(index);
        },
        tbb::simple_partitioner());
  });
}

}  // namespace moire
