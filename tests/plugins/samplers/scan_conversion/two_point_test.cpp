// Two-point lines between middles of pixels, held to exact whole numbers: upper = floor(2^m frac(i dy / dx)), column by
// column. What must never happen: a pixel another level off, at any length that the accumulator's bits allow.
#include "lines/two_point.h"

#include <catch2/catch_test_macros.hpp>
#include <vector>

#include "picture.h"
#include "sanitized.h"

namespace moire::test {
namespace {

using namespace scan_conversion;

// The exact line from (0, 0) to (dx, dy): of every column the pixel at its bottom, whether the other one lies above or
// below, and that one's intensity; to which put() compares what is drawn.
class ExactLine {
 public:
  ExactLine(std::int64_t dx, std::int64_t dy, bool both_ends, int grey_bits = 8)
      : dx_(dx), full_((1U << grey_bits) - 1), columns_(static_cast<std::size_t>(dx + 1)) {
    const std::int64_t mirrored = both_ends ? (dx + 1) / 2 : 0;
    // 2^m i dy = level dx + rest.
    const std::int64_t scaled = dy << grey_bits, whole_step = scaled / dx, rest_step = scaled % dx;
    std::int64_t level = 0, rest = 0;
    for (std::int64_t i = 0; i <= dx; ++i) {
      const auto row = static_cast<int>(level >> grey_bits);
      const auto upper = static_cast<std::uint32_t>(level) & full_;
      if (i <= dx - mirrored) columns_[static_cast<std::size_t>(i)] = {row, 1, upper};
      if (i < mirrored) columns_[static_cast<std::size_t>(dx - i)] = {static_cast<int>(dy) - row, -1, upper};
      level += whole_step;
      rest += rest_step;
      if (rest >= dx) {
        rest -= dx;
        ++level;
      }
    }
  }

  // The same picture: pixels of no intensity may differ.
  bool looks_like(const ExactLine& other) const {
    for (std::size_t i = 0; i < columns_.size(); ++i) {
      for (int y = columns_[i].row - 1; y <= columns_[i].row + 1; ++y) {
        if (intensity(columns_[i], y) != other.intensity(other.columns_[i], y)) return false;
      }
    }
    return true;
  }
  // Whether this is how the line is drawn, pixel for pixel. Lines along pixels leave out the pixels of no intensity.
  bool is_drawn(const TwoPointLines& how, std::int64_t dy) {
    put_ = {};
    const PixelArea everywhere{-10, -10, 200000, 200000};
    two_point_line(how, {0, 0}, {dx_, dy}, everywhere, [this](int x, int y, std::uint32_t intensity) {
      const Column& column = columns_[static_cast<std::size_t>(x)];
      const int above = (y - column.row) * column.up;
      const std::uint32_t expected = above == 0 ? full_ ^ column.upper : column.upper;
      put_.wrong |= static_cast<std::uint32_t>(above & ~1) | (expected ^ intensity);
      put_.sum += intensity;
      ++put_.count;
    });
    const std::int64_t pixels = (dy == 0 || dy == dx_ ? 1 : 2) * (dx_ + 1);
    return put_.wrong == 0 && put_.count == pixels && put_.sum == full_ * static_cast<std::uint64_t>(dx_ + 1);
  }

 private:
  struct Column {
    int row, up;
    std::uint32_t upper;
  };
  std::uint32_t intensity(const Column& column, int y) const {
    return y == column.row ? full_ ^ column.upper : y == column.row + column.up ? column.upper : 0;
  }
  struct Seen {
    std::uint32_t wrong = 0;
    std::uint64_t sum = 0;
    std::int64_t count = 0;
  };

  std::int64_t dx_;
  std::uint32_t full_;
  std::vector<Column> columns_;
  Seen put_;
};

constexpr LineMethod methods[] = {LineMethod::accumulator, LineMethod::direct, LineMethod::fujimoto_iwata};

// Of the lines of dx columns, those that are not drawn as they are exactly.
int failures(const TwoPointLines& how, std::int64_t dx) {
  int count = 0;
  for (std::int64_t dy = 0; dy <= dx; ++dy) {
    count += ExactLine(dx, dy, how.both_ends, how.grey_bits).is_drawn(how, dy) ? 0 : 1;
  }
  return count;
}

// The first dx at which some line fails; 0 if none does up to `last`.
std::int64_t first_failure(const TwoPointLines& how, std::int64_t last) {
  for (std::int64_t dx = 1; dx <= last; ++dx) {
    if (failures(how, dx) > 0) return dx;
  }
  return 0;
}

}  // namespace

TEST_CASE("two-point lines by all methods are the exact ones, every line of up to 1,024 columns") {
  const std::int64_t last = sanitized ? 160 : 1024;
  std::int64_t lines = last;  // at 45 degrees, or along pixels: one pixel a column, tested apart
  for (std::int64_t dx = 1; dx <= last; ++dx) {
    for (std::int64_t dy = 1; dy < dx; ++dy, ++lines) {
      const std::int64_t whole_step = 256 * dy / dx, rest_step = 256 * dy % dx;
      for (const LineMethod method : methods) {
        with_columns({.method = method, .both_ends = false}, octant_of({0, 0}, {dx, dy}), [&](auto walk) {
          // 256 i dy = level dx + rest.
          std::int64_t level = 0, rest = 0, row = 0, wrong = 0;
          walk.go_to(0);
          for (std::int64_t i = 0; i <= dx; ++i) {
            wrong |= ((row << 8) + walk.upper() - level) | (walk.lower() ^ walk.upper() ^ 255);
            row += walk.next();
            const bool carries = rest + rest_step >= dx;
            rest += rest_step - (carries ? dx : 0);
            level += whole_step + (carries ? 1 : 0);
          }
          if (wrong != 0) FAIL_CHECK("dx " << dx << ", dy " << dy << ", method " << int(method));
        });
      }
    }
  }
  CHECK(lines == last * (last + 1) / 2);
}

TEST_CASE("two-point lines are exact from one end and from both, every line of up to 200 columns") {
  for (const LineMethod method : methods) {
    for (const bool both_ends : {false, true}) {
      CHECK(first_failure({.method = method, .both_ends = both_ends}, sanitized ? 60 : 200) == 0);
    }
  }
}

TEST_CASE("long two-point lines are exact: 32 bits to 5,792 columns, 64 beyond") {
  Numbers numbers(1);
  const TwoPointLines narrow;
  CHECK_FALSE(narrow.is_wide(5792, 5792 / 2.0));
  CHECK(narrow.is_wide(5793, 5793 / 2.0));
  CHECK_FALSE(narrow.is_wide(4096, 4096));
  CHECK(narrow.is_wide(4097, 4097));
  CHECK_FALSE(TwoPointLines{.bits = 31}.is_wide(5793, 5793));
  CHECK_FALSE(TwoPointLines{.ceiling = false}.is_wide(5793, 5793));
  for (int k = 0; k < (sanitized ? 30 : 600); ++k) {
    const std::int64_t dx = numbers.integer(1025, k % 3 == 0 ? 65535 : 5792), dy = numbers.integer(0, dx);
    for (const bool both_ends : {false, true}) {
      ExactLine exact(dx, dy, both_ends);
      for (const LineMethod method : methods) {
        CAPTURE(dx, dy, both_ends, int(method));
        CHECK(exact.is_drawn({.method = method, .both_ends = both_ends}, dy));
      }
    }
  }
}

TEST_CASE("two-point lines are exact with 1 to 16 bits of grey") {
  for (const int grey_bits : {1, 4, 12, 16}) {
    for (const LineMethod method : methods) {
      CAPTURE(grey_bits, int(method));
      CHECK(first_failure({.method = method, .bits = 64, .grey_bits = grey_bits}, 90) == 0);
    }
  }
}

TEST_CASE("an accumulator of fewer bits fails first where it was measured to, never below its bound") {
  struct Case {
    int bits;
    std::int64_t both_ends, one_end;
  };
  // From one end the bound sqrt(2^(n - m)) is sharp.
  for (const auto& [bits, both_ends, one_end] :
       {Case{16, 33, 17}, {18, 51, 33}, {20, 101, 65}, {22, 195, 129}, {24, 381, 257}}) {
    if (sanitized && bits > 20) continue;
    CAPTURE(bits);
    CHECK(first_failure({.bits = bits}, 400) == both_ends);
    CHECK(first_failure({.bits = bits, .both_ends = false}, 400) == one_end);
    CHECK(static_cast<double>(both_ends * both_ends) > std::ldexp(1.0, bits - 8 + 1));
  }
}

TEST_CASE("the published rounding of the increment fails from 6 columns on, whatever the bits") {
  for (const int bits : {16, 24, 32, 64}) {
    CAPTURE(bits);
    CHECK(first_failure({.bits = bits, .ceiling = false}, 400) == 6);
    CHECK(first_failure({.bits = bits, .ceiling = false, .both_ends = false}, 400) == 3);
  }
}

TEST_CASE("lines of 2^k columns show none of that") {
  for (const bool ceiling : {false, true}) {
    CHECK(failures({.bits = 16, .ceiling = ceiling, .both_ends = false}, 256) == 0);
    CHECK(failures({.bits = 24, .ceiling = ceiling, .both_ends = false}, 512) == 0);
  }
}

TEST_CASE("of lines of up to 256 columns 23 % are not the same from one end and from both") {
  int lines = 0, different = 0;
  for (std::int64_t dx = 1; dx <= 256; ++dx) {
    for (std::int64_t dy = 0; dy <= dx; ++dy, ++lines) {
      different += ExactLine(dx, dy, true).looks_like(ExactLine(dx, dy, false)) ? 0 : 1;
    }
  }
  CHECK(std::abs(static_cast<double>(different) / lines - 0.23) < 0.005);
}

}  // namespace moire::test
