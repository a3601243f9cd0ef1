// What blocks there are must not depend on threads, and no pixel is ever rendered twice or not at all.
#include "run/workers.h"

#include <array>
#include <atomic>
#include <catch2/catch_test_macros.hpp>
#include <chrono>
#include <mutex>
#include <set>
#include <stdexcept>
#include <thread>

namespace moire::test {

namespace {

// Deposits in each pixel the number of its block's first column, once.
class Numbers final : public Rendering {
 public:
  void render(PixelBlock& block) const override {
    for (std::size_t slot = 0; slot < block.slots(); ++slot) block.add(slot, background, 1, {});
    block.counters.queries += block.slots();
  }
};

class Blank final : public Frame {
 public:
  explicit Blank(ImageSize size, Blend blend = Blend::linear) : size_(size), blend_(blend) {}
  ImageSize size() const override { return size_; }
  Blend blend() const override { return blend_; }
  void trace(std::span<const SamplePoint>, std::span<Hit>, Counters&) const override {}

 private:
  ImageSize size_;
  Blend blend_;
};

class Throwing final : public Rendering {
 public:
  void render(PixelBlock& block) const override {
    if (block.x0 > 0) throw std::runtime_error("no block but the first");
  }
};

}  // namespace

TEST_CASE("every pixel is rendered once, in blocks of whole columns numbered from the left") {
  constexpr ImageSize size{70, 3};
  for (const int threads : {1, 2}) {
    for (const int width : {1, 7, 32, 70, 1000}) {
      CAPTURE(threads, width);
      const Workers workers(threads, width);
      std::vector<std::atomic<int>> visits(70);
      std::vector<std::atomic<int>> calls(workers.blocks(size));
      std::atomic<bool> all_right = true;
      workers.render(Numbers(), Blank(size), true, [&](std::size_t index, const PixelBlock& block) {
        ++calls[index];
        all_right = all_right && block.x0 == static_cast<int>(index) * width && block.y0 == 0 &&
                    block.height == size.height && block.recording() && block.counters.queries == block.slots();
        for (int x = block.x0; x < block.x0 + block.width; ++x) ++visits[static_cast<std::size_t>(x)];
        for (std::size_t slot = 0; slot < block.slots(); ++slot) all_right = all_right && block.weight(slot) == 1;
      });
      CHECK(all_right);
      CHECK(std::all_of(calls.begin(), calls.end(), [](int count) { return count == 1; }));
      CHECK(std::all_of(visits.begin(), visits.end(), [](int count) { return count == 1; }));
    }
  }
}

TEST_CASE("blocks know what their frame averages") {
  for (const Blend blend : {Blend::linear, Blend::as_stored}) {
    for (const bool recording : {false, true}) {
      int blocks = 0;
      Workers(1, 4).render(Numbers(), Blank({9, 2}, blend), recording, [&](std::size_t, const PixelBlock& block) {
        ++blocks;
        CHECK(block.blend() == blend);
      });
      CHECK(blocks == 3);
    }
  }
}

TEST_CASE("blocks are as wide as asked for, but the last") {
  CHECK(Workers(1, 32).blocks({64, 1}) == 2);
  CHECK(Workers(1, 32).blocks({65, 1}) == 3);
  CHECK(Workers(1, 32).blocks({1, 1}) == 1);
}

TEST_CASE("without a number of threads there are as many as cores, at least one") {
  CHECK(Workers(3).threads() == 3);
  CHECK(Workers(0).threads() >= 1);
}

TEST_CASE("what a renderer throws comes out of the call, from any thread") {
  for (const int threads : {1, 2}) {
    const Workers workers(threads, 1);
    CHECK_THROWS_AS(workers.render(Throwing(), Blank({9, 2}), false, [](std::size_t, const PixelBlock&) {}),
                    std::runtime_error);
    // And the workers go on working.
    std::atomic<int> blocks = 0;
    workers.render(Numbers(), Blank({9, 2}), false, [&](std::size_t, const PixelBlock&) { ++blocks; });
    CHECK(blocks == 9);
  }
}

TEST_CASE("what a consumer throws comes out of the call, whatever it is") {
  for (const int threads : {1, 2}) {
    CHECK_THROWS_AS(Workers(threads, 1)
                        .render(Numbers(), Blank({9, 2}), false,
                                [](std::size_t index, const PixelBlock&) {
                                  if (index == 5) throw 7;
                                }),
                    int);
  }
}

TEST_CASE("two threads are at work at once, also beside workers that have one") {
  const Workers one(1), two(2);
  std::atomic<int> begun = 0;
  std::array<bool, 2> met{};
  two.for_each(2, [&](std::size_t index) {
    ++begun;
    // One after the other they would wait in vain.
    const auto end = std::chrono::steady_clock::now() + std::chrono::seconds(20);
    while (begun < 2 && std::chrono::steady_clock::now() < end) std::this_thread::yield();
    met[index] = begun == 2;
  });
  CHECK(met == std::array{true, true});
}

TEST_CASE("work is called once for each number below the count, and what it throws comes out") {
  for (const int threads : {1, 2}) {
    const Workers workers(threads);
    std::vector<std::atomic<int>> calls(100);
    workers.for_each(calls.size(), [&](std::size_t index) { ++calls[index]; });
    CHECK(std::all_of(calls.begin(), calls.end(), [](int count) { return count == 1; }));
    workers.for_each(0, [](std::size_t) { throw 7; });
    CHECK_THROWS_AS(workers.for_each(9,
                                     [](std::size_t index) {
                                       if (index == 5) throw 7;
                                     }),
                    int);
  }
}

}  // namespace moire::test
