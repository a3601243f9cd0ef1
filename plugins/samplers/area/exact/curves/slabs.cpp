#include "exact/curves/slabs.h"

#include <algorithm>
#include <cmath>

#include "exact/curves/arc.h"
#include "exact/curves/ramp.h"

namespace area {

namespace {

// A line that rises less than this across the square is level.
constexpr double least_rise = 1e-30;

// Crossings so far beside the square count as in it: more than rounding moves those that matter.
constexpr double beside = 0x1p-20;
bool is_in_reach(double x) { return x > -beside && x < 1 + beside; }

// From so many covers on a square is cut in four, if that parts them.
constexpr std::size_t many_covers = 10;
// A square of depth 26 holds 2^-52 of the pixel, which is below rounding errors.
constexpr int deepest = 26;

// The roots of t^2 - 2 p t - q, if there are two. The larger one first found, the other from their product.
template <class Visit>
void roots(double p, double q, Visit visit) {
  const double d = p * p + q;
  if (!(d >= 0)) return;
  const double larger = p < 0 ? p - std::sqrt(d) : p + std::sqrt(d);
  visit(larger);
  if (larger != 0) visit(-q / larger);
}

// How many points of x have the circle to their right and to their left at a height; half of its width there.
struct Chord {
  double q, half;  // the circle's x solves x^2 - 2 center x - q = 0

  Chord(const LocalDisk& disk, double y) : q(disk.excess + y * (2 * disk.y - y)) {
    const double square = disk.x * disk.x + q;
    half = square > 0 ? std::sqrt(square) : 0;
  }
  double left(const LocalDisk& disk) const { return disk.x > 0 ? -q / (disk.x + half) : disk.x - half; }
  double right(const LocalDisk& disk) const { return disk.x < 0 ? q / (half - disk.x) : disk.x + half; }
};

}  // namespace

void Slabs::clear() {
  lines_.clear();
  arcs_.clear();
  covers_.clear();
}

void Slabs::begin_cover(std::uint32_t layer) {
  covers_.push_back({layer, lines_.size(), lines_.size(), arcs_.size(), arcs_.size(), 0});
}

const std::vector<double>& Slabs::integrate(std::size_t layers) {
  areas_.assign(layers + 1, 0.0);
  const std::size_t given = covers_.size();
  look_at({0, 0, 1}, 0, given);
  integrate(given, covers_.size(), 1, 0);
  return areas_;
}

void Slabs::integrate(std::size_t first, std::size_t end, double area, int depth) {
  if (first == end) {
    areas_.back() += area;
    return;
  }
  if (covers_[first].size() == 0) {
    areas_[covers_[first].layer] += area;
    return;
  }
  const std::size_t count = end - first, lines = lines_.size(), arcs = arcs_.size();
  if (count < many_covers) return cut(first, end, area);
  if (depth == deepest) {
    // Who is there is all the same; that the sum is right is not.
    areas_[covers_[first].layer] += area;
    return;
  }
  // The time that a square takes grows with the cube of its covers.
  const std::size_t begin = covers_.size();
  std::size_t quarters[5] = {begin};
  double cubes = 0;
  for (int k = 0; k < 4; ++k) {
    look_at({0.5 * (k % 2), 0.5 * (k / 2), 0.5}, first, end);
    quarters[k + 1] = covers_.size();
    const auto part = static_cast<double>(quarters[k + 1] - quarters[k]) / static_cast<double>(count);
    cubes += part * part * part;
  }
  const bool is_parted = cubes < 1.5;
  if (is_parted) {
    for (int k = 0; k < 4; ++k) integrate(quarters[k], quarters[k + 1], area / 4, depth + 1);
  }
  covers_.resize(begin);
  lines_.resize(lines);
  arcs_.resize(arcs);
  if (!is_parted) cut(first, end, area);
}

void Slabs::look_at(const Box& box, std::size_t first, std::size_t end) {
  for (std::size_t k = first; k < end; ++k) {
    const Cover cover = covers_[k];
    Cover seen{cover.layer, lines_.size(), lines_.size(), arcs_.size(), arcs_.size(), 0};
    bool is_out = false;
    for (std::size_t n = cover.lines; n < cover.lines_end && !is_out; ++n) {
      const HalfPlane side = lines_[n].side;
      const HalfPlane here{side.a * box.side, side.b * box.side, side.at(box.x, box.y)};
      const double least = here.c + std::min(here.a, 0.0) + std::min(here.b, 0.0);
      const double most = here.c + std::max(here.a, 0.0) + std::max(here.b, 0.0);
      if (least >= 0) continue;
      is_out = most <= 0;
      Line line{here, 0, 0};
      if (std::abs(here.a) <= least_rise * std::abs(here.b)) {
        line.side.a = 0;
      } else {
        line.x0 = -here.c / here.a, line.slope = -here.b / here.a;
      }
      lines_.push_back(line);
      ++seen.needed;
    }
    for (std::size_t n = cover.arcs; n < cover.arcs_end && !is_out; ++n) {
      const Arc arc = arcs_[n];
      const LocalDisk& disk = arc.disk;
      const double side = box.side;
      const LocalDisk here{disk.at(box.x, box.y) / (side * side), (disk.x - box.x) / side, (disk.y - box.y) / side,
                           disk.radius / side};
      // Its excess is least in a corner, and most in the place nearest to its centre.
      const double least = std::min({here.excess, here.at(1, 0), here.at(0, 1), here.at(1, 1)});
      const double most = here.at(std::clamp(here.x, 0.0, 1.0), std::clamp(here.y, 0.0, 1.0));
      if (arc.sign > 0 ? least >= 0 : most <= 0) continue;
      is_out = arc.sign > 0 ? most <= 0 : least >= 0;
      arcs_.push_back({here, arc.sign});
      if (arc.sign > 0) ++seen.needed;
    }
    if (is_out) {
      lines_.resize(seen.lines), arcs_.resize(seen.arcs);
      continue;
    }
    seen.lines_end = lines_.size(), seen.arcs_end = arcs_.size();
    covers_.push_back(seen);
    if (seen.size() == 0) return;
  }
}

void Slabs::cut(std::size_t first, std::size_t end, double area) {
  find_events(first, end);
  find_strands(first, end);
  for (std::size_t k = 0; k + 1 < events_.size(); ++k) {
    if (events_[k] < events_[k + 1]) slab(first, end, events_[k], events_[k + 1], area);
  }
}

// Whether lines that cross at x, in the square's rows, have one order above and another below as the square sees it.
// Beside the square they may cross on that side of it where both of them leave it, or come from.
bool Slabs::is_order_seen(double x, const Line& one, const Line& other) {
  if (x < 0) {
    return std::max(one.x0, other.x0) > 0 && std::max(one.x0 + one.slope, other.x0 + other.slope) > 0;
  }
  if (x > 1) {
    return std::min(one.x0, other.x0) < 1 && std::min(one.x0 + one.slope, other.x0 + other.slope) < 1;
  }
  return true;
}

void Slabs::find_events(std::size_t first, std::size_t end) {
  events_.assign({0, 1});
  const std::size_t lines = covers_[first].lines, lines_end = covers_[end - 1].lines_end;
  const std::size_t arcs = covers_[first].arcs, arcs_end = covers_[end - 1].arcs_end;
  for (std::size_t k = lines; k < lines_end; ++k) {
    const Line& one = lines_[k];
    if (one.is_level()) {
      event(-one.side.c / one.side.b);
      continue;
    }
    for (std::size_t n = k + 1; n < lines_end; ++n) {
      const Line& other = lines_[n];
      if (other.is_level()) continue;
      const double apart = other.x0 - one.x0, closing = one.slope - other.slope;
      if (!(apart * (apart - closing) < 0)) continue;
      const double y = apart / closing;
      const Line& steep = std::abs(one.slope) < std::abs(other.slope) ? one : other;
      if (is_order_seen(steep.x0 + steep.slope * y, one, other)) event(y);
    }
    for (std::size_t n = arcs; n < arcs_end; ++n) line_events(one, arcs_[n]);
  }
  for (std::size_t k = arcs; k < arcs_end; ++k) {
    const LocalDisk& disk = arcs_[k].disk;
    const auto at_height = [&](double y) { event(y); };
    // The upper and the lower end, as the line through the centre meets the circle; halves are cut in quarters.
    roots(disk.y, disk.excess + disk.x * disk.x, at_height);
    event(disk.y);
    roots(disk.y, disk.excess, at_height);
    roots(disk.y, disk.at(1, 0), at_height);
    for (std::size_t n = k + 1; n < arcs_end; ++n) arc_events(arcs_[k], arcs_[n]);
  }
  std::sort(events_.begin(), events_.end());
}

// Where a line meets a circle.
void Slabs::line_events(const Line& line, const Arc& arc) {
  // From the line's place nearest to the corner, in its direction.
  const HalfPlane& side = line.side;
  const double length = std::sqrt(side.a * side.a + side.b * side.b);
  if (!(length > 0)) return;
  const double dx = -side.b / length, dy = side.a / length, far = -side.c / length;
  const double x = far * (side.a / length), y = far * (side.b / length);
  const LocalDisk& disk = arc.disk;
  roots((disk.x - x) * dx + (disk.y - y) * dy, disk.at(x, y), [&](double t) {
    if (is_in_reach(x + t * dx)) event(y + t * dy);
  });
}

// Two circles meet on the line of equal excess.
void Slabs::arc_events(const Arc& one, const Arc& other) {
  const HalfPlane equal{2 * (one.disk.x - other.disk.x), 2 * (one.disk.y - other.disk.y),
                        one.disk.excess - other.disk.excess};
  line_events({equal, 0, 0}, one.disk.radius < other.disk.radius ? one : other);
}

// All boundaries that may be in a slab, in any order, and what is counted left of all of them.
void Slabs::find_strands(std::size_t first, std::size_t end) {
  strands_.clear();
  start_.assign(end - first, 0);
  for (std::size_t c = first; c < end; ++c) {
    const Cover& cover = covers_[c];
    const auto place = static_cast<std::uint32_t>(c - first);
    for (std::size_t k = cover.lines; k < cover.lines_end; ++k) {
      if (lines_[k].is_level()) continue;
      const bool begins = lines_[k].side.a > 0;
      strands_.push_back({0, k, place, begins ? 1 : -1, Edge::line});
      if (!begins) ++start_[place];
    }
    for (std::size_t k = cover.arcs; k < cover.arcs_end; ++k) {
      strands_.push_back({0, k, place, arcs_[k].sign, Edge::left_arc});
      strands_.push_back({0, k, place, -arcs_[k].sign, Edge::right_arc});
    }
  }
}

// The area to the left of a boundary; nothing where it is not in the slab.
std::optional<double> Slabs::left_of(const Strand& strand, double top, double bottom) const {
  const double height = bottom - top;
  if (strand.edge == Edge::line) {
    const Line& line = lines_[strand.piece];
    return height * covered(line.x0 + line.slope * top, line.x0 + line.slope * bottom);
  }
  const LocalDisk& disk = arcs_[strand.piece].disk;
  const double middle = top + height / 2;
  if (!(disk.x * disk.x + disk.excess + middle * (2 * disk.y - middle) > 0)) return {};
  const Chord above(disk, top), below(disk, bottom);
  const bool is_left = strand.edge == Edge::left_arc;
  const double x_above = is_left ? above.left(disk) : above.right(disk);
  const double x_below = is_left ? below.left(disk) : below.right(disk);
  // A slab sees less than a quarter of a circle, which is never beyond its ends.
  if (x_above <= 0 && x_below <= 0) return 0.0;
  if (x_above >= 1 && x_below >= 1) return height;
  const double run = x_below - x_above, chord = height * (x_above + x_below) / 2;
  const double bulge = segment_area(run * run + height * height, 1 / disk.radius);
  return std::min(height, std::max(0.0, is_left ? chord - bulge : chord + bulge));
}

void Slabs::slab(std::size_t first, std::size_t end, double top, double bottom, double area) {
  const double height = bottom - top, middle = top + height / 2;
  counts_ = start_;
  for (std::size_t c = first; c < end; ++c) {
    for (std::size_t k = covers_[c].lines; k < covers_[c].lines_end; ++k) {
      const Line& line = lines_[k];
      if (line.is_level() && line.side.b * middle + line.side.c >= 0) ++counts_[c - first];
    }
  }
  for (Strand& strand : strands_) {
    const std::optional<double> left = left_of(strand, top, bottom);
    strand.is_there = left.has_value();
    strand.area = left.value_or(0);
  }
  // From slab to slab few change places.
  for (std::size_t k = 1; k < strands_.size(); ++k) {
    if (!(strands_[k].area < strands_[k - 1].area)) continue;
    const Strand moved = strands_[k];
    std::size_t n = k;
    for (; n > 0 && moved.area < strands_[n - 1].area; --n) strands_[n] = strands_[n - 1];
    strands_[n] = moved;
  }
  double before = 0;
  const auto give = [&](double until) {
    if (until == before) return;
    std::size_t front = 0;
    while (front < end - first && counts_[front] != covers_[first + front].needed) ++front;
    (front == end - first ? areas_.back() : areas_[covers_[first + front].layer]) += (until - before) * area;
    before = until;
  };
  for (const Strand& strand : strands_) {
    if (!strand.is_there) continue;
    give(strand.area);
    counts_[strand.cover] += strand.step;
  }
  give(height);
}

}  // namespace area
