// Lines in all directions, and those without one.
#include <catch2/catch_test_macros.hpp>

#include "kernels.h"

namespace moire::test {
namespace {

using namespace scan_conversion;

constexpr PixelArea area{-64, -64, 128, 128};

// One of the eight ways to turn and mirror the plane about a pixel's middle.
struct Turn {
  int number;
  Point operator()(Point p) const {
    const double x = p.x - 0.5, y = p.y - 0.5, u = number & 4 ? y : x, v = number & 4 ? x : y;
    return {(number & 1 ? -u : u) + 0.5, (number & 2 ? -v : v) + 0.5};
  }
};

Point middle(std::int64_t x, std::int64_t y) { return {static_cast<double>(x) + 0.5, static_cast<double>(y) + 0.5}; }

Picture drawn(const LineKernel& kernel, Point from, Point to) {
  Picture picture(area);
  kernel.draw(from, to, area, picture);
  return picture;
}

}  // namespace

TEST_CASE("a line turned or mirrored about a pixel is the turned picture, in all octants by all methods") {
  Numbers numbers(1);
  for (const LineKernel& kernel : line_kernels()) {
    const bool real = kernel.name.ends_with("real ends");
    for (int k = 0; k < 60; ++k) {
      // Multiples of 1 / 1024, so that mirroring is exact.
      const auto place = [&] { return static_cast<double>(numbers.integer(-40960, 40960)) / 1024 + 0.5; };
      const auto pixel = [&] { return middle(numbers.integer(-40, 40), numbers.integer(-40, 40)); };
      const Point from = real ? Point{place(), place()} : pixel(), to = real ? Point{place(), place()} : pixel();
      const Picture original = drawn(kernel, from, to);
      CHECK(original.again == 0);
      CHECK(original.outside == 0);
      for (int number = 1; number < 8; ++number) {
        const Turn turn{number};
        const Picture turned = drawn(kernel, turn(from), turn(to));
        int differences = 0;
        original.for_each_pixel([&](int x, int y) {
          const Point p = turn(middle(x, y));
          if (p.x >= 64 || p.y >= 64) return;
          differences += original.at(x, y) != turned.at(whole(p.x), whole(p.y)) ? 1 : 0;
        });
        if (differences > 0 || turned.again > 0) {
          FAIL_CHECK(kernel.name << ", turn " << number << " of (" << from.x << ", " << from.y << ") to (" << to.x
                                 << ", " << to.y << "): " << differences);
        }
      }
    }
  }
}

TEST_CASE("lines along pixels, down them and at 45 degrees have one pixel a column") {
  for (const LineKernel& kernel : line_kernels()) {
    if (kernel.name == "gupta_sproull" || kernel.name.ends_with("real ends")) continue;
    CAPTURE(kernel.name);
    const std::uint32_t full = kernel.name == "bresenham" ? 1 : 255;
    for (const auto& [dx, dy] : {std::pair{9, 0}, {0, 9}, {-9, 0}, {0, -9}, {9, 9}, {-9, 9}, {9, -9}, {-9, -9}}) {
      Picture picture(area);
      int puts = 0;
      kernel.draw(middle(3, 5), middle(3 + dx, 5 + dy), area, picture);
      picture.for_each_pixel([&](int x, int y) { puts += picture.at(x, y) > 0 ? 1 : 0; });
      CHECK(puts == 10);
      CHECK(picture.sum == 10 * full);
      for (int i = 0; i <= 9; ++i) CHECK(picture.at(3 + i * dx / 9, 5 + i * dy / 9) == full);
    }
  }
}

TEST_CASE("a line without length is one pixel of full weight by all methods, whether its ends are rounded or not") {
  for (const LineKernel& kernel : line_kernels()) {
    CAPTURE(kernel.name);
    const Picture picture = drawn(kernel, {-7.25, 12.75}, {-7.25, 12.75});
    CHECK(picture.at(-8, 12) == (kernel.name == "bresenham" ? 1 : 255));
    CHECK(picture.sum == picture.at(-8, 12));
  }
}

TEST_CASE("an increment that fills all bits is a line at 45 degrees and not along pixels") {
  // 999 / 1000 of 2^8 is 2^8, by the ceiling and rounded.
  constexpr std::int64_t columns = 1000;
  const PixelArea wide{0, 0, columns + 2, columns + 2};
  for (const bool ceiling : {true, false}) {
    const TwoPointLines how{.bits = 8, .ceiling = ceiling, .both_ends = false};
    Picture picture(wide);
    two_point_line(how, PixelIndex{}, PixelIndex{columns, columns - 1}, wide, picture);
    CHECK(picture.at(columns, columns) == 255);
    CHECK(picture.sum == 255 * (columns + 1));
  }
}

TEST_CASE("targets that are written place by place get the same pixels") {
  struct Placed {
    Picture& picture;
    static std::ptrdiff_t place(int x, int y) { return std::ptrdiff_t{1000} * y + x; }
    void at(std::ptrdiff_t place, std::uint32_t intensity) const {
      const auto y = (place + 500'500) / 1000 - 500;
      picture(static_cast<int>(place - 1000 * y), static_cast<int>(y), intensity);
    }
    void operator()(int x, int y, std::uint32_t intensity) const { picture(x, y, intensity); }
  };
  Numbers numbers(2);
  for (int k = 0; k < 200; ++k) {
    const auto number = [&] { return numbers.integer(-60, 60); };
    const PixelIndex from{number(), number()}, to{number(), number()};
    Picture plain(area), placed(area);
    const auto draw = [&](auto&& put) {
      two_point_line({}, from, to, area, put);
      two_point_line({.both_ends = false}, from, to, area, put);
      bresenham_line(from, to, area, put);
      gupta_sproull_line(from, to, area, put);
    };
    draw(plain);
    draw(Placed{placed});
    CHECK(plain.differences(placed) == 0);
  }
}

}  // namespace moire::test
