// Things that reach from one y to another, sorted into buckets of rows, so that any rows can be begun with.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

namespace area {

class RowBuckets {
 public:
  static constexpr int rows_each = 16;

  RowBuckets() = default;
  // `count` things in the rows [0, rows): thing k from top(k) to bottom(k), anywhere. In a bucket they are in rising
  // order of top(k), then of k.
  template <class Top, class Bottom>
  RowBuckets(std::size_t count, int rows, Top top, Bottom bottom) : buckets_((rows + rows_each - 1) / rows_each) {
    begins_.assign(static_cast<std::size_t>(buckets_) + 1, 0);
    struct Reach {
      int first, last;
    };
    std::vector<Reach> reaches(count);
    for (std::uint32_t k = 0; k < count; ++k) reaches[k] = {bucket_of(top(k)), bucket_of(bottom(k))};
    const auto for_each_entry = [&](auto visit) {
      for (std::uint32_t k = 0; k < count; ++k) {
        for (int b = reaches[k].first; b <= reaches[k].last; ++b) visit(static_cast<std::size_t>(b), k);
      }
    };
    // Sorted by counting: in the end begins_[b] is where bucket b begins.
    for_each_entry([&](std::size_t b, std::uint32_t) { ++begins_[b]; });
    std::size_t sum = 0;
    for (std::size_t& begin : begins_) sum += std::exchange(begin, sum);
    entries_.resize(sum);
    for_each_entry([&](std::size_t b, std::uint32_t k) { entries_[begins_[b]++] = k; });
    for (std::size_t b = begins_.size() - 1; b > 0; --b) begins_[b] = begins_[b - 1];
    begins_[0] = 0;
    for (std::size_t b = 0; b + 1 < begins_.size(); ++b) {
      std::sort(entries_.begin() + static_cast<std::ptrdiff_t>(begins_[b]),
                entries_.begin() + static_cast<std::ptrdiff_t>(begins_[b + 1]),
                [&](std::uint32_t i, std::uint32_t j) { return top(i) < top(j) || (top(i) == top(j) && i < j); });
    }
  }

  // What reaches some of the rows [rows_each b, rows_each (b + 1)).
  std::span<const std::uint32_t> operator[](int b) const {
    const auto begin = begins_[static_cast<std::size_t>(b)];
    return std::span(entries_).subspan(begin, begins_[static_cast<std::size_t>(b) + 1] - begin);
  }

  // Calls work(bucket, first row, end row) for the rows [first, end), bucket by bucket.
  template <class Work>
  static void for_each(int first, int end, Work work) {
    for (int y = first; y < end;) {
      const int next = std::min(end, (y / rows_each + 1) * rows_each);
      work(y / rows_each, y, next);
      y = next;
    }
  }

 private:
  int bucket_of(double y) const {
    const double bucket = std::floor(y / rows_each);
    return bucket < 0 ? 0 : bucket >= buckets_ ? buckets_ - 1 : static_cast<int>(bucket);
  }

  int buckets_ = 0;
  std::vector<std::size_t> begins_;
  std::vector<std::uint32_t> entries_;
};

}  // namespace area
