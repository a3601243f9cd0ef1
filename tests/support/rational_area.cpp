// All heights in the pixel at which an edge ends, crosses another or passes a side of the pixel cut it into slabs. No
// two edges cross inside a slab, so in order of their x at its middle they bound trapezoids, each of one visible
// polygon. Doubles are whole numbers of a small enough unit; ratios of such numbers are never reduced, because finding
// common divisors costs more than the few digits that they would save.
#include "support/rational_area.h"

#include <algorithm>
#include <bit>
#include <boost/multiprecision/cpp_int.hpp>
#include <cmath>
#include <cstdint>
#include <set>
#include <tuple>

namespace moire::test {

namespace {

namespace mp = boost::multiprecision;

// Of any length; up to 1,024 bits without asking for memory.
using Integer =
    mp::number<mp::cpp_int_backend<1024, 0, mp::signed_magnitude, mp::unchecked, std::allocator<mp::limb_type>>,
               mp::et_off>;

// over / under. Requires: under > 0.
struct Ratio {
  Integer over, under;
};

bool operator<(const Ratio& a, const Ratio& b) { return a.over * b.under < b.over * a.under; }
bool operator==(const Ratio& a, const Ratio& b) { return a.over * b.under == b.over * a.under; }

// Of an edge, whichever way it goes, `upper` is the end of smaller y, and `turn` says whether the edge goes down.
struct Edge {
  std::size_t polygon;
  int turn;
  Point upper, lower;
  double left, right;
  Integer x, y, dx, dy;  // `upper` from the pixel's corner, and from there to `lower`
  std::size_t first_slab, end_slab;

  auto ends() const { return std::tie(upper.x, upper.y, lower.x, lower.y); }
  Integer y_end() const { return y + dy; }
};

// The power of two that its last digit counts.
int last_digit(double value) {
  int exponent;
  const auto digits = static_cast<std::int64_t>(std::ldexp(std::frexp(value, &exponent), 53));
  return exponent - 53 + std::countr_zero(static_cast<std::uint64_t>(digits));
}

// How many units, of which a pixel has a power of two, so that all corners are whole numbers of them.
int unit_bits(std::span<const FlatPolygon> polygons) {
  int bits = 0;
  for (const FlatPolygon& polygon : polygons) {
    for (const auto& contour : polygon.contours) {
      for (const Point& p : contour) {
        for (const double value : {p.x, p.y}) {
          if (value != 0) bits = std::max(bits, -last_digit(value));
        }
      }
    }
  }
  return bits;
}

Integer in_units(double value, int bits) {
  int exponent;
  const auto digits = static_cast<std::int64_t>(std::ldexp(std::frexp(value, &exponent), 53));
  const int shift = exponent - 53 + bits;
  return shift >= 0 ? Integer(digits) << shift : Integer(digits >> -shift);
}

class SlabbedPixel {
 public:
  SlabbedPixel(std::span<const FlatPolygon> polygons, int x, int y)
      : polygons_(polygons), bits_(unit_bits(polygons)), side_(Integer(1) << bits_), pixel_left_(x) {
    find_edges(x, y);
    // Duplicates come one after another.
    std::sort(edges_.begin(), edges_.end(), [](const Edge& a, const Edge& b) { return a.ends() < b.ends(); });
    find_cuts();
    for (Edge& edge : edges_) {
      edge.first_slab = slab_at({edge.y, 1});
      edge.end_slab = slab_at({edge.y_end(), 1});
    }
  }

  std::vector<double> areas() {
    areas_.assign(polygons_.size() + 1, 0);
    for (std::size_t slab = 0; slab + 1 < cuts_.size(); ++slab) add_slab(slab);
    std::vector<double> result;
    for (const Integer& area : areas_) result.push_back(std::ldexp(area.convert_to<double>(), -area_bits));
    return result;
  }

 private:
  static constexpr int area_bits = 180;  // of the fixed point in which areas are summed

  // The edges that end or pass in the pixel's row, those on the right of the pixel left out. Level edges bound no
  // trapezoid; where they begin and end, others do.
  void find_edges(int x, int y) {
    const Integer x0 = in_units(x, bits_), y0 = in_units(y, bits_);
    for (std::size_t k = 0; k < polygons_.size(); ++k) {
      for (const auto& contour : polygons_[k].contours) {
        for (std::size_t i = 0; i < contour.size(); ++i) {
          const Point p = contour[i], q = contour[(i + 1) % contour.size()];
          if (p.y == q.y) continue;
          const Point& upper = p.y < q.y ? p : q;
          const Point& lower = p.y < q.y ? q : p;
          const auto [left, right] = std::minmax(p.x, q.x);
          if (lower.y <= y || upper.y >= y + 1 || left >= x + 1) continue;
          Edge edge{k, p.y < q.y ? 1 : -1, upper, lower, left, right, {}, {}, {}, {}, 0, 0};
          edge.x = in_units(upper.x, bits_) - x0;
          edge.y = in_units(upper.y, bits_) - y0;
          edge.dx = in_units(lower.x, bits_) - x0 - edge.x;
          edge.dy = in_units(lower.y, bits_) - y0 - edge.y;
          edges_.push_back(std::move(edge));
        }
      }
    }
  }

  void find_cuts() {
    cuts_ = {{0, 1}, {side_, 1}};
    for (std::size_t i = 0; i < edges_.size(); ++i) {
      const Edge& edge = edges_[i];
      add_cut({edge.y, 1});
      add_cut({edge.y_end(), 1});
      if (edge.right <= pixel_left_) continue;
      add_passage(edge, 0);
      add_passage(edge, side_);
      for (std::size_t j = 0; j < i; ++j) {
        if (edges_[j].right > pixel_left_) add_crossing(edge, edges_[j]);
      }
    }
    std::sort(cuts_.begin(), cuts_.end());
    cuts_.erase(std::unique(cuts_.begin(), cuts_.end()), cuts_.end());
  }

  void add_cut(Ratio y) {
    if (y.over > 0 && y.over < side_ * y.under) cuts_.push_back(std::move(y));
  }

  // Where the edge is at this x: y + dy (x - edge.x) / dx.
  void add_passage(const Edge& edge, const Integer& x) {
    if (edge.dx == 0) return;
    const int sign = edge.dx < 0 ? -1 : 1;
    const Integer along = (x - edge.x) * sign, length = edge.dx * sign;
    if (along > 0 && along < length) add_cut({edge.y * length + edge.dy * along, length});
  }

  // a + s (da) = b + t (db), hence s = (b - a) x db / (da x db) and t = (b - a) x da / (da x db). Edges that have an
  // end in common meet nowhere else, or all along.
  void add_crossing(const Edge& a, const Edge& b) {
    if (a.upper == b.upper || a.upper == b.lower || a.lower == b.upper || a.lower == b.lower) return;
    if (a.right < b.left || b.right < a.left || a.lower.y < b.upper.y || b.lower.y < a.upper.y) return;
    Integer under = a.dx * b.dy - a.dy * b.dx;
    if (under == 0) return;
    const Integer x = b.x - a.x, y = b.y - a.y;
    Integer s = x * b.dy - y * b.dx, t = x * a.dy - y * a.dx;
    if (under < 0) under = -under, s = -s, t = -t;
    if (s >= 0 && s <= under && t >= 0 && t <= under) add_cut({a.y * under + s * a.dy, under});
  }

  // The number of cuts above this height.
  std::size_t slab_at(const Ratio& y) const {
    return static_cast<std::size_t>(std::lower_bound(cuts_.begin(), cuts_.end(), y) - cuts_.begin());
  }

  // An edge at a slab's middle: x = over / (edge.dy * middle.under), clamped to the pixel, and rounded down to 2^-62 of
  // its side, so that unequal `rounded` tell the order.
  struct Crossing {
    const Edge* edge;
    Integer over;
    std::int64_t rounded;

    friend bool operator<(const Crossing& a, const Crossing& b) {
      if (a.rounded != b.rounded) return a.rounded < b.rounded;
      return a.over * b.edge->dy < b.over * a.edge->dy;
    }
  };

  void add_slab(std::size_t slab) {
    const Ratio &top = cuts_[slab], &bottom = cuts_[slab + 1];
    const Integer under = top.under * bottom.under;
    const Ratio middle{top.over * bottom.under + bottom.over * top.under, 2 * under};
    const Ratio height{bottom.over * top.under - top.over * bottom.under, under};

    std::vector<int> winding(polygons_.size());
    crossings_.clear();
    for (const Edge& edge : edges_) {
      if (slab < edge.first_slab || slab >= edge.end_slab) continue;
      if (edge.right <= pixel_left_) {
        winding[edge.polygon] += edge.turn;
      } else if (!crossings_.empty() && crossings_.back().edge->ends() == edge.ends()) {
        crossings_.push_back(crossings_.back());
        crossings_.back().edge = &edge;
      } else {
        crossings_.push_back(crossing(edge, middle));
      }
    }
    std::sort(crossings_.begin(), crossings_.end());

    // From left to right. At `left` the polygon `front` came to sight.
    std::set<std::size_t> present{polygons_.size()};
    for (std::size_t k = 0; k < polygons_.size(); ++k) {
      if (is_inside(k, winding[k])) present.insert(k);
    }
    Ratio left{0, 1};
    std::size_t front = *present.begin();
    const auto visible_until = [&](const Ratio& x) {
      // (x - left) / middle.under wide, in units.
      areas_[front] += ((x.over * left.under - left.over * x.under) * height.over << area_bits) /
                       (x.under * left.under * middle.under * height.under << 2 * bits_);
    };
    for (const Crossing& crossing : crossings_) {
      const Edge& edge = *crossing.edge;
      winding[edge.polygon] += edge.turn;
      if (is_inside(edge.polygon, winding[edge.polygon])) {
        present.insert(edge.polygon);
      } else {
        present.erase(edge.polygon);
      }
      if (*present.begin() == front) continue;
      const Ratio x{crossing.over, edge.dy};
      visible_until(x);
      left = x;
      front = *present.begin();
    }
    visible_until({side_ * middle.under, 1});
  }

  Crossing crossing(const Edge& edge, const Ratio& y) const {
    const Integer width = side_ * y.under * edge.dy;
    Integer over = edge.x * edge.dy * y.under + (y.over - edge.y * y.under) * edge.dx;
    if (over < 0) over = 0;
    if (over > width) over = width;
    const auto rounded = static_cast<std::int64_t>((over << 62) / width);
    return {&edge, std::move(over), rounded};
  }

  bool is_inside(std::size_t polygon, int winding) const {
    return polygons_[polygon].rule == FillRule::nonzero ? winding != 0 : winding % 2 != 0;
  }

  std::span<const FlatPolygon> polygons_;
  int bits_;
  Integer side_;  // of the pixel
  double pixel_left_;
  std::vector<Edge> edges_;
  std::vector<Ratio> cuts_;  // downward, from the pixel's top to its bottom
  std::vector<Crossing> crossings_;
  std::vector<Integer> areas_;
};

}  // namespace

std::vector<double> visible_areas(std::span<const FlatPolygon> polygons, int x, int y) {
  return SlabbedPixel(polygons, x, y).areas();
}

}  // namespace moire::test
