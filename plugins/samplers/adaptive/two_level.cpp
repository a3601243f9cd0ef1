#include "two_level.h"

#include <algorithm>

#include <moire/jitter.h>

#include "samples.h"

namespace adaptive {

namespace {

moire::Spacing spacing(int n) { return {1.0 / n, 1.0 / n}; }

// Calls visit(k) for each sample of the pixel in place `at` of `rows`, k from the column's first sample.
template <class Visit>
void for_each_sample(std::size_t at, std::size_t rows, int n, Visit visit) {
  const auto side = static_cast<std::size_t>(n);
  for (std::size_t strip = 0; strip < side; ++strip) {
    for (std::size_t j = 0; j < side; ++j) visit((strip * rows + at) * side + j);
  }
}

moire::PixelArea with_neighbours(const moire::PixelArea& area, moire::ImageSize image) {
  const int x0 = std::max(area.x0 - 1, 0), x1 = std::min(area.x0 + area.width + 1, image.width);
  const int y0 = std::max(area.y0 - 1, 0), y1 = std::min(area.y0 + area.height + 1, image.height);
  return {x0, y0, x1 - x0, y1 - y0};
}

// Pixels of an area, column by column.
class Marks {
 public:
  explicit Marks(const moire::PixelArea& area)
      : area_(area), marks_(static_cast<std::size_t>(area.width) * static_cast<std::size_t>(area.height)) {}

  void set(int x, int y) { marks_[index(x, y)] = 1; }
  bool at(int x, int y) const { return marks_[index(x, y)] != 0; }
  bool around(int x, int y) const {
    for (int i = std::max(x - 1, area_.x0); i < std::min(x + 2, area_.x0 + area_.width); ++i) {
      for (int j = std::max(y - 1, area_.y0); j < std::min(y + 2, area_.y0 + area_.height); ++j) {
        if (at(i, j)) return true;
      }
    }
    return false;
  }

 private:
  std::size_t index(int x, int y) const {
    return static_cast<std::size_t>(x - area_.x0) * static_cast<std::size_t>(area_.height) +
           static_cast<std::size_t>(y - area_.y0);
  }
  moire::PixelArea area_;
  std::vector<char> marks_;
};

}  // namespace

void TwoLevel::append(int x, const std::vector<int>& rows, int n, int first, std::vector<moire::SamplePoint>& points,
                      std::vector<std::size_t>& ends) const {
  for (int i = 0; i < n; ++i) {
    for (const int y : rows) {
      const moire::Pixel key = reseed_.key({x, y, request_.frame_number, request_.seed});
      for (int j = n - 1; j >= 0; --j) {
        const auto sample = static_cast<std::uint32_t>(first + i * n + j);
        points.push_back({x + moire::jittered(i, n, 1, moire::random(key, sample, 0)),
                          y + moire::jittered(j, n, 1, moire::random(key, sample, 1))});
      }
    }
    ends.push_back(points.size());
  }
}

void TwoLevel::render(moire::PixelBlock& block) const {
  const auto [coarse, fine, neighbours] = grids_;
  const moire::PixelArea area = neighbours ? with_neighbours(block, request_.frame.size()) : block;
  const auto height = static_cast<std::size_t>(area.height);
  const std::size_t in_column = height * static_cast<std::size_t>(coarse * coarse);
  std::vector<int> rows;
  for (int y = area.y0 + area.height - 1; y >= area.y0; --y) rows.push_back(y);
  const auto place = [&](int y) { return static_cast<std::size_t>(area.y0 + area.height - 1 - y); };

  // The few.
  std::vector<moire::SamplePoint> points;
  std::vector<std::size_t> ends;
  Samples few(request_, block.recording());
  for (int x = area.x0; x < area.x0 + area.width; ++x) append(x, rows, coarse, 0, points, ends);
  few.look_at(points, ends, spacing(coarse), block.counters);
  const auto column_of = [&](int x) { return static_cast<std::size_t>(x - area.x0) * in_column; };

  // Where they differ.
  Marks differing(area);
  for (int x = area.x0; x < area.x0 + area.width; ++x) {
    for (const int y : rows) {
      Range range;
      for_each_sample(place(y), height, coarse, [&](std::size_t k) { range.add(few[column_of(x) + k]); });
      if (criterion_.fires(range)) differing.set(x, y);
    }
  }

  // The many, a column at a time.
  Samples many(request_, block.recording());
  for (int x = block.x0; x < block.x0 + block.width; ++x) {
    rows.clear();
    for (int y = block.y0 + block.height - 1; y >= block.y0; --y) {
      const std::size_t slot = block.slot(x, y);
      if (neighbours ? differing.around(x, y) : differing.at(x, y)) {
        rows.push_back(y);
      } else {
        for_each_sample(place(y), height, coarse,
                        [&](std::size_t k) { few.add_to(block, slot, column_of(x) + k, 1.0 / (coarse * coarse)); });
      }
    }
    points.clear();
    ends.clear();
    many.clear();
    append(x, rows, fine, coarse * coarse, points, ends);
    many.look_at(points, ends, spacing(fine), block.counters);
    for (std::size_t at = 0; at < rows.size(); ++at) {
      for_each_sample(at, rows.size(), fine,
                      [&](std::size_t k) { many.add_to(block, block.slot(x, rows[at]), k, 1.0 / (fine * fine)); });
    }
  }
}

}  // namespace adaptive
