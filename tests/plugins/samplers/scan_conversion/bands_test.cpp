// Which pixels a circle runs between, of every radius to 65,535, against whole numbers. What must never happen: a band
// a pixel off, which all the rest of the octant would keep.
#include "circles/bands.h"

#include <catch2/catch_test_macros.hpp>

#include "picture.h"
#include "sanitized.h"

namespace moire::test {
namespace {

using namespace scan_conversion;

// h = sqrt(r^2 - j^2) in whole numbers, from row to row downward.
class ExactRows {
 public:
  ExactRows(std::int64_t radius, std::int64_t j) : square_(radius * radius - j * j), j_(j), i_(radius) {
    i_ = static_cast<std::int64_t>(std::sqrt(static_cast<double>(square_))) + 2;
    settle();
  }

  void next() {
    square_ -= 2 * j_ + 1;
    ++j_;
    settle();
  }
  std::int64_t ceiling() const { return i_; }
  // Whether d = floor(2^bits (ceil(h) - h)): 2^bits h lies in (2^bits i - d - 1, 2^bits i - d].
  bool is_rest(std::uint32_t d, int bits) const {
    const std::int64_t scaled = square_ << (2 * bits), edge = (i_ << bits) - d;
    return scaled <= edge * edge && scaled > (edge - 1) * (edge - 1);
  }

 private:
  void settle() {
    while (i_ > 0 && (i_ - 1) * (i_ - 1) >= square_) --i_;
  }

  std::int64_t square_, j_, i_;
};

// The rows of an octant in which equal values of D may hide a step, and what is exact there. Of 6 bits: h falls by more
// than 63 / 64 a row, j / h > 63 / 64, so j > (1 - 1 / 128) r / sqrt(2).
class Diagonal {
 public:
  explicit Diagonal(std::int64_t radius) : radius_(radius), last_(PixelCircle{{}, radius}.last_row()) {
    first_ = std::max<std::int64_t>(last_ - radius / 170 - 4, 0);
    RootBand band(radius, 1);
    ExactRows exact(radius, first_);
    band.go_to(first_);
    for (std::int64_t j = first_; j <= last_; ++j) {
      const auto r = static_cast<double>(radius), v = static_cast<double>(j);
      const double h = std::sqrt((r - v) * (r + v));
      rests_.push_back(std::ceil(h) - h);
      ceilings_.push_back(exact.ceiling());
      roots_are_right_ &= band.i() == exact.ceiling();
      band.next();
      exact.next();
    }
  }

  bool roots_are_right() const { return roots_are_right_; }
  // Whether a table of so many bits keeps a band on the circle: one of D rounded down as here, or as published, of
  // 2^bits - 1 and to the nearest.
  template <bool tie_rule>
  bool is_table_right(int bits, bool published = false) const {
    const Table table{*this, bits, published};
    TableBand<tie_rule, Table> band(table, std::min(bits, 8));
    band.go_to(first_);
    for (std::size_t row = 0; row < ceilings_.size(); ++row) {
      if (row > 0) band.next();
      if (band.i() != ceilings_[row]) return false;
    }
    return true;
  }

 private:
  struct Table {
    const Diagonal& rows;
    int bits_;
    bool published;
    std::int64_t radius() const { return rows.radius_; }
    int bits() const { return bits_; }
    std::uint32_t operator[](std::int64_t j) const {
      const double rest = rows.rests_[static_cast<std::size_t>(j - rows.first_)], levels = std::ldexp(1.0, bits_);
      return static_cast<std::uint32_t>(published ? (levels - 1) * rest + 0.5 : levels * rest);
    }
  };

  std::int64_t radius_, last_, first_;
  std::vector<double> rests_;  // ceil(h) - h
  std::vector<std::int64_t> ceilings_;
  bool roots_are_right_ = true;
};

template <class Band>
bool is_right_everywhere(Band band, std::int64_t radius) {
  ExactRows exact(radius, 0);
  band.go_to(0);
  const std::int64_t last = PixelCircle{{}, radius}.last_row();
  for (std::int64_t j = 0; j <= last; ++j) {
    if (band.i() != exact.ceiling()) return false;
    band.next();
    exact.next();
  }
  return true;
}

constexpr std::int64_t largest = 65535;

}  // namespace

TEST_CASE("bands follow every circle of radius 3 to 65,535; published ones without a rule fail at the radii measured") {
  // Of a published table without a rule: its first failing radius, and how many of 65,535.
  struct Failures {
    int bits;
    std::int64_t first;
    int count;
    std::int64_t seen_first = 0;
    int seen = 0;
  };
  Failures failures[] = {{8, 505, 64162},    {9, 901, 62791},   {10, 1690, 60039}, {11, 3124, 54536}, {12, 6446, 43533},
                         {13, 13551, 22471}, {14, 25767, 5115}, {15, 47181, 228},  {16, 0, 0}};
  for (std::int64_t radius = 3; radius <= (sanitized ? 4000 : largest); ++radius) {
    const Diagonal diagonal(radius);
    const bool right = diagonal.roots_are_right() && diagonal.is_table_right<true>(8) &&
                       diagonal.is_table_right<true>(7) && diagonal.is_table_right<true>(6) &&
                       diagonal.is_table_right<false>(16);
    if (!right) FAIL_CHECK("radius " << radius);
    for (Failures& table : failures) {
      if (diagonal.is_table_right<false>(table.bits, true)) continue;
      if (table.seen++ == 0) table.seen_first = radius;
    }
  }
  for (const Failures& table : failures) {
    CAPTURE(table.bits);
    if (sanitized && table.bits > 11) continue;
    CHECK(table.seen_first == table.first);
    if (!sanitized) CHECK(table.seen == table.count);
  }
}

TEST_CASE("all bands are right in every row, and intensities to the last level") {
  Numbers numbers(2);
  for (int k = 0; k < (sanitized ? 20 : 200); ++k) {
    const std::int64_t radius = k < 100 ? k + 3 : numbers.integer(3, largest);
    const std::int64_t last = PixelCircle{{}, radius}.last_row();
    CAPTURE(radius);
    const RootTable narrow(radius, 8), wide(radius, 16);
    CHECK(is_right_everywhere(RootBand(radius, 8), radius));
    CHECK(is_right_everywhere(TableBand<true>(narrow, 8), radius));
    CHECK(is_right_everywhere(TableBand<false>(wide, 8), radius));
    ExactRows exact(radius, 0);
    TableBand<false> band(wide, 8);
    band.go_to(0);
    int wrong = 0;
    for (std::int64_t j = 0; j <= last; ++j) {
      wrong += exact.is_rest(narrow[j], 8) && exact.is_rest(band.inner(), 8) && exact.is_rest(wide[j] >> 4, 12) ? 0 : 1;
      exact.next();
      band.next();
    }
    CHECK(wrong == 0);
  }
}

TEST_CASE("the midpoint band is the nearest pixel, of any radius") {
  Numbers numbers(3);
  for (int k = 0; k < 2000; ++k) {
    const std::int64_t radius = k < 300 ? k + 1 : numbers.integer(1, std::int64_t{1} << (k % 40 + 1));
    const std::int64_t start = numbers.integer(0, PixelCircle{{}, radius}.last_row());
    MidpointBand band(radius);
    band.go_to(start);
    for (std::int64_t j = start; j <= std::min({start + 40, PixelCircle{{}, radius}.last_row() + 1, radius - 1});
         ++j, band.next()) {
      // (i - 1/2)^2 + j^2 < r^2 < (i + 1/2)^2 + j^2, four times and without the quarters that decide nothing.
      const auto i = static_cast<SignedWide>(band.i());
      const SignedWide square = (SignedWide{radius} - j) * (SignedWide{radius} + j);
      if (!(i * i - i < square && square <= i * i + i)) FAIL_CHECK("radius " << radius << ", row " << j);
    }
  }
}

TEST_CASE("an octant's last row is floor(r / sqrt(2))") {
  for (const std::int64_t radius : {0, 1, 2, 3, 7, 10, 65535, 1 << 30}) {
    const std::int64_t row = PixelCircle{{}, radius}.last_row();
    CHECK(2 * row * row <= radius * radius);
    CHECK(2 * (row + 1) * (row + 1) > radius * radius);
  }
}

}  // namespace moire::test
