// Where a line f(i) = rise i / columns runs, column by column, each method by its own arithmetic:
//   row_at(i)   floor(f(i)), of any column
//   go_to(i)    to a column
//   next()      to the next one; how many rows it lies higher
//   upper()     intensity of row floor(f) + 1, of 2^grey_bits - 1
//   lower()     intensity of row floor(f)
// Convention: upper = floor(2^m (f - floor(f))), and lower is its bitwise inverse; they add up to 2^m - 1.
#pragma once

#include <algorithm>
#include <limits>

#include "../pixels.h"

namespace scan_conversion {

// Where f starts and how fast it rises. Whole numbers where ends are; with real ends column 0 is not where the line
// begins.
struct Slope {
  double columns = 1, rise = 0;
  double before = 0;  // columns from the line's begin to the middle of column 0
  double start = 0;   // f at the line's begin, from row 0 upward

  double at(double i) const { return start + (i + before) * rise / columns; }
};

// Wu's: f's fraction is a whole number D of the word's bits that grows by d a column, a row where it overflows. Words
// of fewer bits are kept in the upper ones of `Word`.
template <class Word>
class Accumulator {
 public:
  static constexpr int width = std::numeric_limits<Word>::digits;

  // Requires: d < 2^width.
  Accumulator(Word d, Word first, int grey_bits)
      : step_(d), first_(first), d_(first), shift_(width - grey_bits), full_((std::uint32_t{1} << grey_bits) - 1) {}

  std::int64_t row_at(std::int64_t i) const { return static_cast<std::int64_t>(sum(i) >> width); }
  void go_to(std::int64_t i) { d_ = static_cast<Word>(sum(i)); }
  int next() {
    d_ += step_;
    return d_ < step_ ? 1 : 0;
  }
  std::uint32_t upper() const { return static_cast<std::uint32_t>(d_ >> shift_); }
  std::uint32_t lower() const { return upper() ^ full_; }

 private:
  Wide sum(std::int64_t i) const { return static_cast<Wide>(i) * step_ + first_; }

  Word step_, first_, d_;
  int shift_;
  std::uint32_t full_;
};

// (rise i) / columns with a division of doubles in every column, exact while products stay below 2^53.
template <bool real_ends>
class Direct {
 public:
  Direct(const Slope& slope, int grey_bits) : slope_(slope), scale_(std::ldexp(1.0, grey_bits)) {
    full_ = static_cast<std::uint32_t>(scale_) - 1;
    go_to(0);
  }

  std::int64_t row_at(std::int64_t i) const { return static_cast<std::int64_t>(f(static_cast<double>(i))); }
  void go_to(std::int64_t i) {
    i_ = static_cast<double>(i);
    set();
  }
  int next() {
    const std::int64_t before = row_;
    i_ += 1;
    set();
    return static_cast<int>(row_ - before);
  }
  std::uint32_t upper() const { return static_cast<std::uint32_t>(static_cast<std::int32_t>(fraction_ * scale_)); }
  std::uint32_t lower() const { return upper() ^ full_; }

 protected:
  double fraction() const { return fraction_; }
  double scale() const { return scale_; }

 private:
  double f(double i) const {
    // At the first column rounding may lead below row 0.
    if constexpr (real_ends) return std::max(slope_.at(i), 0.0);
    return slope_.rise * i / slope_.columns;
  }
  void set() {
    const double y = f(i_);
    row_ = static_cast<std::int64_t>(y);
    fraction_ = y - static_cast<double>(row_);
  }

  Slope slope_;
  double scale_, i_ = 0, fraction_ = 0;
  std::int64_t row_ = 0;
  std::uint32_t full_;
};

// Fujimoto and Iwata's, as the text compares with it: each pixel's intensity from its own distance to the line,
// measured down the column, I = tent(j - f).
template <bool real_ends>
class PerPixel : public Direct<real_ends> {
 public:
  using Direct<real_ends>::Direct;

  // The last level that starts below the weight: what the upper pixel's level leaves of 2^m - 1.
  std::uint32_t lower() const {
    return static_cast<std::uint32_t>(static_cast<std::int32_t>(std::ceil((1 - this->fraction()) * this->scale()))) - 1;
  }
};

// Slopes 0 and 1, where the fraction never changes.
class Straight {
 public:
  Straight(int rise, std::uint32_t upper, int grey_bits)
      : rise_(rise), upper_(upper), lower_(((std::uint32_t{1} << grey_bits) - 1) ^ upper) {}

  std::int64_t row_at(std::int64_t i) const { return rise_ * i; }
  void go_to(std::int64_t) {}
  int next() const { return rise_; }
  std::uint32_t upper() const { return upper_; }
  std::uint32_t lower() const { return lower_; }

 private:
  int rise_;
  std::uint32_t upper_, lower_;
};

}  // namespace scan_conversion
