// Pictures made from blocks: the same colours whatever the order of slots, and light whatever was averaged.
#include "metrics/picture.h"

#include <catch2/catch_test_macros.hpp>
#include <random>

namespace moire::test {

namespace {

// Pixels without a deposit, of weight 1, of other weights, and many alike.
PixelBlock some_block(PixelArea area, Blocks order, Blend blend) {
  PixelBlock block(area, true, order, blend);
  for (int y = area.y0; y < area.y0 + area.height; ++y) {
    for (int x = area.x0; x < area.x0 + area.width; ++x) {
      std::mt19937 random(static_cast<unsigned>(1000 * y + x));
      const auto channel = [&] { return static_cast<float>(random() % 256) / 255; };
      const std::size_t slot = block.slot(x, y);
      switch (random() % 4) {
        case 0:
          break;
        case 1:
          block.add(slot, 1, 1, {0.25F, 0.5F, 1});
          break;
        case 2:
          block.add(slot, 1, 0.25, {channel(), channel(), channel()});
          block.add(slot, 2, 0.75, {channel(), channel(), channel()});
          break;
        default:
          block.add(slot, 3, 0.3, {channel(), channel(), channel()});
      }
    }
  }
  return block;
}

constexpr Color untouched{7, 8, 9};

Picture with(const PixelBlock& block, ImageSize size) {
  Picture picture{size, std::vector<Color>(static_cast<std::size_t>(size.width) * static_cast<std::size_t>(size.height),
                                           untouched)};
  put(block, picture);
  return picture;
}

}  // namespace

TEST_CASE("a block is put where it lies, each pixel with its own colour, and nothing else is touched") {
  constexpr ImageSize size{23, 19};
  for (const Blocks order : {Blocks::columns, Blocks::rows}) {
    for (const Blend blend : {Blend::linear, Blend::as_stored}) {
      for (const PixelArea area :
           {PixelArea{0, 0, 23, 19}, {5, 0, 4, 19}, {0, 7, 23, 6}, {22, 18, 1, 1}, {3, 2, 9, 7}}) {
        const PixelBlock block = some_block(area, order, blend);
        const Picture picture = with(block, size);
        for (int y = 0; y < size.height; ++y) {
          for (int x = 0; x < size.width; ++x) {
            const bool is_inside =
                x >= area.x0 && x < area.x0 + area.width && y >= area.y0 && y < area.y0 + area.height;
            const Color expected = is_inside ? block.color(block.slot(x, y)) : untouched;
            CAPTURE(x, y, area.x0, area.y0, area.width, area.height);
            REQUIRE(picture.pixels[static_cast<std::size_t>(y * size.width + x)] == expected);
          }
        }
      }
    }
  }
}

TEST_CASE("averages of light stay as they are; averages of code values become light when they are pixels") {
  const auto half_white = [](Blend blend) {
    PixelBlock block({0, 0, 1, 1}, false, Blocks::columns, blend);
    block.add(0, 1, 0.5, {1, 1, 1});
    block.add(0, 2, 0.5, {0, 0.5F, 1});
    return block.color(0);
  };
  CHECK(half_white(Blend::linear) == Color{0.5F, 0.75F, 1});
  // Code values 0.5 and 0.75 are light 0.21404 and 0.52252 (IEC 61966-2-1); white stays white.
  const Color stored = half_white(Blend::as_stored);
  CHECK(stored.r == static_cast<float>(std::pow((0.5 + 0.055) / 1.055, 2.4)));
  CHECK(stored.g == static_cast<float>(std::pow((0.75 + 0.055) / 1.055, 2.4)));
  CHECK(stored.b == 1);
}

TEST_CASE("a pixel without a deposit is black, whatever is averaged") {
  for (const Blend blend : {Blend::linear, Blend::as_stored})
    CHECK(PixelBlock({0, 0, 1, 1}, false, Blocks::rows, blend).color(0) == Color{0, 0, 0});
}

}  // namespace moire::test
