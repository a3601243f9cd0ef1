// The threads of a run, and Ctrl-C.
#pragma once

#include <functional>
#include <memory>

#include <moire/sampler.h>

namespace moire {

// Thrown where work was given up because stop_requested().
struct Interrupted {};

// From now on Ctrl-C asks the run to stop cleanly; a second one ends the program at once.
void catch_interrupts();
bool stop_requested();

// Renders frames block by block, on one thread or on many: the result is the same.
class Workers {
 public:
  static constexpr int default_block_width = 32;

  // 0 threads: as many as the machine has cores. Blocks of columns are block_width wide, blocks of rows half as high.
  explicit Workers(int threads, int block_width = default_block_width);
  ~Workers();

  int threads() const { return threads_; }

  // The blocks that a rendering gets: those it likes best, but the fragments of all renderings come in equal blocks.
  static Blocks order(const Rendering& rendering, bool recording) {
    return recording ? Blocks::columns : rendering.blocks();
  }

  // Calls consume(index, block) for every finished block of `frame`, which the rendering is of, many at once; blocks
  // are numbered from the left, or from the top. Throws what a renderer or consumer throws, or Interrupted.
  template <class Consume>
  void render(const Rendering& rendering, const Frame& frame, bool recording, Consume consume) const {
    render_runs(rendering, frame, recording, [&](std::size_t index, PixelBlock& block) {
      block.settle();
      consume(index, block);
    });
  }

  // The same for a consumer that takes runs as runs (Tally::Run).
  template <class Consume>
  void render_runs(const Rendering& rendering, const Frame& frame, bool recording, Consume consume) const {
    for_each_block(frame, recording, order(rendering, recording), [&](std::size_t index, PixelBlock& block) {
      rendering.render(block);
      consume(index, block);
    });
  }

  // Calls work(index, block) for every block of the frame, empty.
  template <class Work>
  void for_each_block(const Frame& frame, bool recording, Blocks order, Work work) const {
    Call<Work> call{work};
    run_blocks(frame, recording, order, &call);
  }

  // Calls work(0) .. work(count - 1), many at once. Throws what `work` throws, or Interrupted.
  void for_each(std::size_t count, const std::function<void(std::size_t)>& work) const;

  std::size_t blocks(ImageSize size, Blocks order = Blocks::columns) const {
    const int length = order == Blocks::columns ? size.width : size.height;
    return static_cast<std::size_t>((length + thickness(order) - 1) / thickness(order));
  }

 private:
  struct BlockWork {
    virtual ~BlockWork() = default;
    virtual void operator()(std::size_t index, PixelBlock& block) = 0;
  };
  template <class Work>
  struct Call final : BlockWork {
    explicit Call(Work& w) : work(w) {}
    void operator()(std::size_t index, PixelBlock& block) override { work(index, block); }
    Work& work;
  };
  void run_blocks(const Frame& frame, bool recording, Blocks order, BlockWork* work) const;
  // Of rows, so many that those of a wide image stay in a core's own cache.
  int thickness(Blocks order) const { return order == Blocks::columns ? block_width_ : (block_width_ + 1) / 2; }

  int threads_, block_width_;
  struct Arena;
  std::unique_ptr<Arena> arena_;
};

}  // namespace moire
