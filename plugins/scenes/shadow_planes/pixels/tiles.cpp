#include "pixels/tiles.h"

#include <algorithm>
#include <cmath>

#include "pixels/tile_rule.h"
#include "world/cut.h"

namespace shadow_planes {

namespace {

// Corners this near to a cut, in pixels, are on it.
constexpr double on_cut = 1e-11;
// Estimates tell rules from the next cruder ones by their terms, of which some may be small by chance: of 2.7 million
// pixels of random worlds without overlapping shadows none was off by more than twice what was estimated for its tile.
constexpr double safety = 3;
// Shares of an area below it are rounding.
constexpr double least_share = 1e-12;

// Whether more than a point of the segment is within the outline.
bool enters(const ImageSegment& segment, const Outline& outline) {
  double begin = 0, end = 1;
  const moire::Point* from = &outline.back();
  for (const moire::Point& to : outline) {
    const Line edge = edge_line(*from, to);
    from = &to;
    const double at_begin = edge(segment.from), at_end = edge(segment.to);
    if (at_begin <= 0 && at_end <= 0) return false;
    if (at_begin < 0) begin = std::max(begin, at_begin / (at_begin - at_end));
    if (at_end < 0) end = std::min(end, at_begin / (at_begin - at_end));
  }
  return begin < end;
}

}  // namespace

double Tiles::integrate() {
  for (int y = block_.y0 / side * side; y < block_.y0 + block_.height; y += side) {
    for (int x = block_.x0 / side * side; x < block_.x0 + block_.width; x += side) any_faces({x, y, side});
  }
  block_.counters.hits = block_.counters.queries;
  return safety * error_;
}

bool Tiles::is_wanted(const Tile& tile) const {
  return tile.x < block_.x0 + block_.width && tile.x + tile.side > block_.x0 && tile.y < block_.y0 + block_.height &&
         tile.y + tile.side > block_.y0;
}

void Tiles::count(const Tile& tile) {
  if (is_wanted({tile.x, tile.y, 1})) block_.counters.queries += gatherer_.points() - counted_;
  counted_ = gatherer_.points();
}

template <class Each>
void Tiles::for_quarters(const Tile& tile, Each each) {
  const int half = tile.side / 2;
  for (const int dy : {0, half}) {
    for (const int dx : {0, half}) each(Tile{tile.x + dx, tile.y + dy, half});
  }
}

void Tiles::any_faces(const Tile& tile) {
  if (!is_wanted(tile)) return;
  visible_.in(tile.window(), parts_);
  // What the image as a whole does not show is rounding along the edges of what hides it.
  std::erase_if(parts_, [&](const Part& part) { return part.face != Part::none && !faces_[part.face]; });
  const std::uint32_t first = parts_.empty() ? Part::none : parts_[0].face;
  if (std::any_of(parts_.begin(), parts_.end(), [&](const Part& part) { return part.face != first; })) {
    if (tile.side == 1) {
      mixed_pixel(tile);
    } else {
      for_quarters(tile, [&](const Tile& quarter) { any_faces(quarter); });
    }
  } else if (first != Part::none) {
    one_face(tile, *faces_[first], faces_[first]->seen.illumination().all(), 0);
  } else {
    for (int y = tile.y; y < tile.y + tile.side; ++y) {
      for (int x = tile.x; x < tile.x + tile.side; ++x) {
        if (is_wanted({x, y, 1})) block_.add(block_.slot(x, y), moire::background, 1, sky_);
      }
    }
  }
}

void Tiles::one_face(const Tile& tile, const ShadedFace& face, Candidates candidates, int depth) {
  if (!is_wanted(tile)) return;
  const moire::Rectangle w = tile.window();
  std::vector<std::uint32_t>& narrowed = candidates_[static_cast<std::size_t>(depth)];
  const std::array<Vector, 4> hull{face.seen.point({w.x0, w.y0}), face.seen.point({w.x1, w.y0}),
                                   face.seen.point({w.x1, w.y1}), face.seen.point({w.x0, w.y1})};
  face.seen.illumination().narrow(hull, candidates, narrowed);
  if (tile.side > 1) {
    const bool is_crossed = face.seen.segments().any_in({tile.x, tile.y, tile.side, tile.side});
    if (!is_crossed && interpolate(tile, face, narrowed)) return;
    for_quarters(tile, [&](const Tile& quarter) { one_face(quarter, face, narrowed, depth + 1); });
    return;
  }
  const std::size_t mark = gatherer_.mark();
  const Integral all = integral({{w.x0, w.y0}, {w.x1, w.y0}, {w.x1, w.y1}, {w.x0, w.y1}}, tile, face, narrowed);
  collect_shadows(mark, 1);
  deposit(block_.slot(tile.x, tile.y), face, 1, all.sums, shadows_);
  error_ =
      std::max(error_, all.error * (face.tolerance > 0 ? *std::max_element(face.light.begin(), face.light.end()) : 0));
  count(tile);
}

bool Tiles::interpolate(const Tile& tile, const ShadedFace& face, Candidates candidates) {
  const TileRule& rule = tile_rule(tile.side);
  const auto points = static_cast<std::size_t>(rule.points() * rule.points());
  const auto values_of = [&](std::size_t quantity) -> std::vector<double>& {
    if (values_.size() <= quantity) values_.resize(quantity + 1);
    return values_[quantity];
  };
  const std::size_t start = gatherer_.mark();
  // Where no segment crosses, whoever hides some of the light at one point does so at all.
  if (!candidates.empty()) {
    gatherer_.at(face.seen, {tile.x + 0.5 * tile.side, tile.y + 0.5 * tile.side}, candidates, 1);
    gatherer_.forget(start);
    met_.assign(gatherer_.scratch.met.begin(), gatherer_.scratch.met.end());
  } else {
    met_.clear();
  }
  shadowing_.clear();
  values_of(0).resize(points);
  values_of(1).resize(points);
  bool is_smooth = true;
  for (std::size_t k = 0; k < points; ++k) {
    const int i = static_cast<int>(k) % rule.points(), j = static_cast<int>(k) / rule.points();
    const Sums sums = gatherer_.at(face.seen, {tile.x + rule.at(i), tile.y + rule.at(j)}, met_, 1);
    values_[0][k] = sums.light;
    values_[1][k] = sums.lit;
    // Edges of casters that cross before the light may pass behind one of its edges, on a curve.
    is_smooth &= !gatherer_.scratch.overlap;
    for (std::size_t s = start; s < gatherer_.mark(); ++s) {
      const auto& [point, by, weight] = gatherer_.shadows()[s];
      const auto found = std::find(shadowing_.begin(), shadowing_.end(), by);
      const auto quantity = static_cast<std::size_t>(found - shadowing_.begin());
      if (found == shadowing_.end()) {
        shadowing_.push_back(by);
        values_of(2 + quantity).assign(points, 0);
      }
      values_[2 + quantity][k] += weight;
    }
    gatherer_.forget(start);
  }
  const double error = rule.error({values_[0].data(), points}, is_smooth);
  count(tile);
  if (!(error <= (is_smooth ? 1 : 0.25) * face.tolerance)) return false;
  const std::size_t quantities = 2 + shadowing_.size();
  if (averages_.size() < quantities) averages_.resize(quantities);
  const auto pixels = static_cast<std::size_t>(tile.side * tile.side);
  for (std::size_t q = 0; q < quantities; ++q) {
    averages_[q].resize(pixels);
    if (q == 0 || block_.recording()) rule.averages({values_[q].data(), points}, averages_[q]);
  }
  for (int y = tile.y; y < tile.y + tile.side; ++y) {
    for (int x = tile.x; x < tile.x + tile.side; ++x) {
      if (!is_wanted({x, y, 1})) continue;
      const auto k = static_cast<std::size_t>((y - tile.y) * tile.side + (x - tile.x));
      shadows_.clear();
      for (std::size_t q = 2; q < quantities; ++q) shadows_.push_back({shadowing_[q - 2], averages_[q][k]});
      std::sort(shadows_.begin(), shadows_.end());
      deposit(block_.slot(x, y), face, 1, {averages_[0][k], averages_[1][k]}, shadows_);
    }
  }
  error_ = std::max(error_, error * *std::max_element(face.light.begin(), face.light.end()));
  return true;
}

void Tiles::mixed_pixel(const Tile& tile) {
  double total = 0, error = 0;
  for (const Part& part : parts_) total += 0.5 * doubled_area(part.outline);
  const std::size_t slot = block_.slot(tile.x, tile.y);
  for (const Part& part : parts_) {
    const double area = 0.5 * doubled_area(part.outline) / total;
    if (part.face == Part::none) {
      block_.add(slot, moire::background, area, sky_);
      continue;
    }
    const ShadedFace& face = *faces_[part.face];
    const std::size_t mark = gatherer_.mark();
    const Integral all = integral(part.outline, tile, face, face.seen.illumination().all());
    collect_shadows(mark, 1 / total);
    deposit(slot, face, area, {all.sums.light / total, all.sums.lit / total}, shadows_);
    error += all.error / total * *std::max_element(face.light.begin(), face.light.end());
  }
  error_ = std::max(error_, error);
  count(tile);
}

Integral Tiles::integral(const Outline& outline, const Tile& pixel, const ShadedFace& face, Candidates candidates) {
  pieces_count_ = 1;
  if (pieces_.empty()) pieces_.emplace_back();
  pieces_[0] = outline;
  for (const SegmentIndex::Cell& cell : face.seen.segments().in_pixel(pixel.x, pixel.y)) {
    cut(face.seen.segments()[cell.segment]);
  }
  const moire::Rectangle w = pixel.window();
  const moire::Point* contact = nullptr;
  for (const moire::Point& p : face.seen.contacts()) {
    if (p.x >= w.x0 && p.x <= w.x1 && p.y >= w.y0 && p.y <= w.y1) contact = &p;
  }
  PieceIntegral pieces(face.seen, face.tolerance, gatherer_);
  Integral sum;
  for (std::size_t k = 0; k < pieces_count_; ++k) {
    const Integral one = pieces.over(pieces_[k], contact, candidates);
    sum = {sum.sums + one.sums, sum.error + one.error};
  }
  return sum;
}

// Cuts the pieces that the segment enters, along the whole of its line.
void Tiles::cut(const ImageSegment& segment) {
  const auto distance = [&](const moire::Point& p) {
    const double value = segment.line(p);
    return std::abs(value) < on_cut ? 0 : value;
  };
  const std::size_t before = pieces_count_;
  for (std::size_t k = 0; k < before; ++k) {
    bool some_within = false, some_beyond = false;
    for (const moire::Point& p : pieces_[k]) {
      const double value = distance(p);
      some_within |= value > 0;
      some_beyond |= value < 0;
    }
    if (!some_within || !some_beyond || !enters(segment, pieces_[k])) continue;
    split(pieces_[k], distance, within_, beyond_);
    std::swap(pieces_[k], within_);
    if (pieces_count_ == pieces_.size()) pieces_.emplace_back();
    std::swap(pieces_[pieces_count_++], beyond_);
  }
}

void Tiles::collect_shadows(std::size_t mark, double factor) {
  shadows_.clear();
  for (std::size_t k = mark; k < gatherer_.mark(); ++k) {
    shadows_.push_back({gatherer_.shadows()[k].face, gatherer_.shadows()[k].weight});
  }
  gatherer_.forget(mark);
  std::stable_sort(shadows_.begin(), shadows_.end(), [](const auto& p, const auto& q) { return p.first < q.first; });
  std::size_t faces = 0;
  for (std::size_t k = 0; k < shadows_.size(); ++k) {
    if (faces > 0 && shadows_[faces - 1].first == shadows_[k].first) {
      shadows_[faces - 1].second += factor * shadows_[k].second;
    } else {
      shadows_[faces++] = {shadows_[k].first, factor * shadows_[k].second};
    }
  }
  shadows_.resize(faces);
}

void Tiles::deposit(std::size_t slot, const ShadedFace& face, double area, Sums sums, const Shadows& shadows) {
  const double light = std::max(sums.light, 0.0);
  block_.fill([&](auto add) {
    const auto channel = [&](std::size_t k) { return area * face.ambient[k] + light * face.light[k]; };
    add.sum(slot, {area, channel(0), channel(1), channel(2)});
    if (!block_.recording()) return;
    // Interpolation may take a share a little below 0; together they are the area.
    const double least = least_share * area;
    const auto kept = [&](double weight) { return weight > least ? weight : 0; };
    const double lit_weight = kept(sums.lit);
    double seen = lit_weight;
    for (const auto& [by, weight] : shadows) seen += kept(weight);
    const double unlit_weight = kept(area - seen);
    const double scale = area / (seen + unlit_weight);
    const std::uint32_t k = face.seen.face();
    if (lit_weight > 0) add.record(slot, lit(k), scale * lit_weight, face.color(light / (scale * lit_weight)));
    for (const auto& [by, weight] : shadows) {
      if (kept(weight) > 0) add.record(slot, shadowed(k, by), scale * weight, face.color(0));
    }
    if (unlit_weight > 0) add.record(slot, unlit(k), scale * unlit_weight, face.color(0));
  });
}

}  // namespace shadow_planes
