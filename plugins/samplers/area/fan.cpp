#include "fan.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace area {

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

// Appends where the boundary c + (along - reference) slope crosses whole across coordinates, in rising order of along.
void crossings(double c, double slope, double reference, double low, double high, std::vector<double>& out) {
  if (slope == 0) return;
  const double a = c + (low - reference) * slope;
  const double b = c + (high - reference) * slope;
  const double first = std::ceil(std::min(a, b)), last = std::floor(std::max(a, b));
  const std::size_t begin = out.size();
  for (double i = first; i <= last; ++i) {
    const double along = reference + (i - c) / slope;
    if (along > low && along < high) out.push_back(along);
  }
  if (slope < 0) std::reverse(out.begin() + static_cast<std::ptrdiff_t>(begin), out.end());
}

// All along coordinates between which a wedge overlaps the same pixels: ends, whole rows, crossings of both boundaries.
std::vector<double> breakpoints(double low, double high, std::vector<double> a, const std::vector<double>& b) {
  std::vector<double> rows{low};
  for (double row = std::floor(low) + 1; row < high; ++row) rows.push_back(row);
  rows.push_back(high);
  std::vector<double> both(a.size() + b.size()), all(rows.size() + both.size());
  std::merge(a.begin(), a.end(), b.begin(), b.end(), both.begin());
  std::merge(rows.begin(), rows.end(), both.begin(), both.end(), all.begin());
  all.erase(std::unique(all.begin(), all.end()), all.end());
  return all;
}

// Within a stretch all places count alike, though a wedge gets wider with the distance from its apex. Parts of length l
// at distance r misjudge what their halves show by l^2 / 8 r of a pixel at most: here by 1 / (8 lines), no more than
// one line does that stands for its wedge.
std::vector<double> divided(const std::vector<double>& ends, double apex, int lines) {
  std::vector<double> all{ends.front()};
  for (std::size_t k = 0; k + 1 < ends.size(); ++k) {
    const double begin = ends[k], length = ends[k + 1] - begin;
    const double distance = std::min(std::abs(begin - apex), std::abs(ends[k + 1] - apex));
    const double parts = std::ceil(length / std::sqrt((distance + 1.0 / lines) / lines));
    for (double part = 1; part < parts; ++part) all.push_back(begin + length * part / parts);
    all.push_back(ends[k + 1]);
  }
  return all;
}

}  // namespace

Fan::Fan(moire::ImageSize size, moire::Pole pole, int lines, bool transposed, bool ahead)
    : transposed_(transposed),
      pole_across_(transposed ? pole.y : pole.x),
      pole_along_(transposed ? pole.x : pole.y),
      pole_w_(pole.w),
      across_size_(transposed ? size.height : size.width),
      along_size_(transposed ? size.width : size.height),
      lines_(lines),
      apex_(pole_w_ != 0 ? pole_along_ / pole_w_ : (ahead ? -infinity : infinity)) {
  low_ = ahead ? std::max(0.0, apex_) : 0.0;
  high_ = ahead ? along_size_ : std::min<double>(along_size_, apex_);
  if (!(low_ < high_)) return;
  reference_ = ahead ? high_ : low_;
  rising_ = (low_ + high_) / 2 * pole_w_ > pole_along_;

  // The lines through the corners of the fan's part of the image, projected onto the reference line; none of them
  // more oblique than 45 degrees.
  const double d = pole_along_ - reference_ * pole_w_;
  double c0 = infinity, c1 = -infinity;
  for (double along : {low_, high_}) {
    for (double across : {0.0, static_cast<double>(across_size_)}) {
      const double c = along == apex_
                           ? std::copysign(infinity, across * pole_w_ - pole_across_)
                           : (across * d - (along - reference_) * pole_across_) / (pole_along_ - along * pole_w_);
      c0 = std::min(c0, c);
      c1 = std::max(c1, c);
    }
  }
  if (pole_w_ != 0) {
    c0 = std::max(c0, pole_across_ / pole_w_ - std::abs(d / pole_w_));
    c1 = std::min(c1, pole_across_ / pole_w_ + std::abs(d / pole_w_));
  }
  if (!(c0 < c1)) return;
  wedges_ = static_cast<int>(std::ceil((c1 - c0) * lines));
  start_ = c0;
  step_ = (c1 - c0) / wedges_;
}

void Fan::stretches(int index, int x0, int x1, Stretches& out) const {
  out.clear();
  const double a = start_ + index * step_, b = start_ + (index + 1) * step_, middle = start_ + (index + 0.5) * step_;
  const auto outside = [](double p, double q, int begin, int end) {
    return std::max(p, q) <= begin || std::min(p, q) >= end;
  };
  const int across_begin = transposed_ ? 0 : x0, across_end = transposed_ ? across_size_ : x1;
  if (outside(std::min(across(a, low_), across(a, high_)), std::max(across(b, low_), across(b, high_)), across_begin,
              across_end)) {
    return;
  }

  const double along_from = rising_ ? low_ : high_, along_to = rising_ ? high_ : low_;
  const auto point = [&](double along) {
    return transposed_ ? moire::Point{along, across(middle, along)} : moire::Point{across(middle, along), along};
  };
  out.from = point(along_from);
  out.to = point(along_to);
  const double distance_per_along = std::hypot(1.0, slope(middle));
  out.along_per_distance = 1 / distance_per_along;

  std::vector<double> of_a, of_b;
  crossings(a, slope(a), reference_, low_, high_, of_a);
  crossings(b, slope(b), reference_, low_, high_, of_b);
  std::vector<double> ends = divided(breakpoints(low_, high_, std::move(of_a), of_b), apex_, lines_);
  if (!rising_) std::reverse(ends.begin(), ends.end());

  const auto distance = [&](double along) { return std::abs(along - along_from) * distance_per_along; };
  for (std::size_t k = 0; k + 1 < ends.size(); ++k) {
    const double along = (ends[k] + ends[k + 1]) / 2;
    // Of the lower end: the middle of a very short stretch may round up into the next row.
    const int row = static_cast<int>(std::min(ends[k], ends[k + 1]));
    if (transposed_ && (row < x0 || row >= x1)) continue;
    const double left = across(a, along), right = across(b, along);
    const std::size_t before = out.shares.size();
    const int begin = std::max(across_begin, static_cast<int>(std::floor(std::max(left, -1.0))));
    for (int i = begin; i < across_end && i < right; ++i) {
      const double width = std::min(right, i + 1.0) - std::max(left, static_cast<double>(i));
      if (width <= 0) continue;
      out.shares.push_back(transposed_ ? Share{row, i, width} : Share{i, row, width});
    }
    if (out.shares.size() == before && out.cuts.empty()) continue;
    if (out.cuts.empty()) {
      out.cuts.push_back(distance(ends[k]));
      out.first.push_back(0);
    }
    out.cuts.push_back(distance(ends[k + 1]));
    out.first.push_back(out.shares.size());
  }
  // A wedge leaves the columns once. Only then can it be told: near the apex, where a wedge is narrower than rounding
  // errors, stretches within the columns may seem to overlap no pixel.
  while (out.first.size() > 1 && out.first.end()[-1] == out.first.end()[-2]) {
    out.first.pop_back();
    out.cuts.pop_back();
  }
}

std::vector<Fan> fans(moire::ImageSize size, moire::Pole pole, int lines) {
  std::vector<Fan> result;
  const bool at_infinity = pole.w == 0;
  for (bool transposed : {false, true}) {
    if (at_infinity && transposed != (std::abs(pole.x) > std::abs(pole.y))) continue;
    for (bool ahead : {false, true}) {
      if (at_infinity && ahead) continue;
      Fan fan(size, pole, lines, transposed, ahead);
      if (fan.wedges() > 0) result.push_back(fan);
    }
  }
  return result;
}

}  // namespace area
