#include "light/area_light.h"

#include <algorithm>
#include <limits>

#include "light/triangle_rule.h"

namespace shadow_planes {

namespace {

// Below this ratio of the light's size to its distance Lambert's sum, whose terms cancel, has fewer good digits than
// quadrature of the kernel, which is then all but linear.
constexpr double far_away = 1e-3;
// Rounding of a line's value at a point, in units of the terms that it sums.
constexpr double rounding = 2 * std::numeric_limits<double>::epsilon();

double sum_of(Vector p) { return std::abs(p.x) + std::abs(p.y) + std::abs(p.z); }

}  // namespace

AreaLight::AreaLight(const World& world, std::uint32_t receiver, const Plane& side)
    : Illumination(world, receiver, side), front_(world.light.plane.normal) {
  // Axes that are exact where the light's plane is upright to one.
  const Vector n = front_, size{std::abs(n.x), std::abs(n.y), std::abs(n.z)};
  const Vector axis = size.x <= size.y && size.x <= size.z ? Vector{1, 0, 0}
                      : size.y <= size.z                   ? Vector{0, 1, 0}
                                                           : Vector{0, 0, 1};
  along_ = cross(n, axis);
  along_ = (1 / length(along_)) * along_;
  across_ = cross(along_, n);
  normal_ = turned(side.normal);

  std::size_t corners = 0;
  for (const Convex& part : world.light.parts) {
    for (const Vector& p : part) origin_ = origin_ + p;
    corners += part.size();
  }
  if (corners > 0) origin_ = (1 / static_cast<double>(corners)) * origin_;
  // In the plane even where the corners are not quite.
  origin_ = origin_ - world.light.plane.distance(origin_) * n;

  const auto flattened = [&](const Convex& part) {
    std::vector<moire::Point> flat;
    for (const Vector& p : part) {
      const Vector at = placed(p);
      flat.push_back({at.x, at.y});
    }
    return flat;
  };
  double before = 0;
  for (const Convex& part : world.light.parts) {
    area_ += 0.5 * doubled_area(flattened(part));
    std::vector<moire::Point> seen = flattened(clipped(part, side));
    const double area = seen.size() < 3 ? 0 : 0.5 * doubled_area(seen);
    if (!(area > 0)) continue;
    before += area;
    for (const moire::Point& p : seen) radius_ = std::max({radius_, std::abs(p.x), std::abs(p.y)});
    parts_.push_back(std::move(seen));
  }
  if (before > 0) front_share_ = before < area_ ? before / area_ : 1;

  for (const Caster& caster : casters()) {
    Flat flat{caster.face,
              {turned(caster.plane.normal), caster.plane.distance(origin_)},
              0,
              corners_.size(),
              caster.corners.size()};
    for (const Vector& p : caster.corners) {
      corners_.push_back(placed(p));
      flat.size = std::max(flat.size, sum_of(corners_.back() - corners_[flat.first]));
    }
    flats_.push_back(flat);
  }
}

Reach AreaLight::at(Vector x, std::span<const std::uint32_t> candidates, Scratch& scratch) const {
  scratch.hidden.clear();
  scratch.met.clear();
  scratch.overlap = false;
  const Vector p = placed(x);
  if (!(p.z > 0) || parts_.empty()) return {};
  const bool is_far = radius_ * radius_ < far_away * far_away * dot(p, p);
  Reach reach{0, front_share_};
  double far_irradiance = 0;
  scratch.sum.begin(p, normal_);
  for (const auto& part : parts_) {
    if (is_far) {
      far_irradiance += irradiance_from_afar(part.data(), part.size(), p);
    } else {
      scratch.sum.add(part.data(), part.size());
    }
  }
  if (!candidates.empty()) {
    scratch.pieces.clear();
    scratch.lines.clear();
    scratch.shades.clear();
    scratch.dark.clear();
    for (const std::uint32_t caster : candidates) {
      add_hidden(caster, p, reach.lit, scratch);
    }
    for (const Piece& piece : scratch.dark) {
      const moire::Point* corners = &scratch.pieces[piece.first];
      if (is_far) {
        far_irradiance -= irradiance_from_afar(corners, piece.count, p);
      } else {
        scratch.sum.subtract(corners, piece.count);
      }
    }
  }
  // What rounding leaves of a light that several casters hide together.
  if (!(reach.lit > 1e-14 * front_share_)) return {};
  reach.irradiance = std::max(is_far ? far_irradiance : scratch.sum.total(), 0.0);
  return reach;
}

void AreaLight::narrow(std::span<const Vector> hull, std::span<const std::uint32_t> candidates,
                       std::vector<std::uint32_t>& out) const {
  out.clear();
  for (const std::uint32_t caster : candidates) {
    const Flat& flat = flats_[caster];
    const Vector* corners = corners_.data() + flat.first;
    // The volume that a point, an edge and a corner of the light span is linear in the point: an edge whose plane has
    // all of the light beyond it for all corners of the hull has it there for all points between them.
    double above = 0, below = 0;
    for (const Vector& x : hull) {
      const double height = flat.plane.distance(placed(x));
      above = std::max(above, height);
      below = std::min(below, height);
    }
    const double sign = above > 0 ? -1 : 1;
    bool hides = true;
    if (above == 0 || below == 0) {
      for (std::size_t k = 0; k < flat.count && hides; ++k) {
        const Vector a = corners[k], b = corners[k + 1 < flat.count ? k + 1 : 0];
        hides = std::any_of(hull.begin(), hull.end(), [&](const Vector& x) {
          const Vector p = placed(x), m = sign * cross(a - p, b - p);
          const Line line{m.x, m.y, -dot(m, p)};
          return std::any_of(parts_.begin(), parts_.end(), [&](const std::vector<moire::Point>& part) {
            return std::any_of(part.begin(), part.end(), [&](const moire::Point& c) { return line(c) > 0; });
          });
        });
      }
    }
    if (hides) out.push_back(caster);
  }
}

void AreaLight::add_hidden(std::uint32_t caster, Vector p, double& lit, Scratch& scratch) const {
  Pieces& pieces = scratch.pieces;
  const std::size_t first_line = scratch.lines.size();
  if (!borders(flats_[caster], p, scratch)) return;
  const std::size_t lines = scratch.lines.size() - first_line;
  const double least = 1e-15 * area_;
  double share = 0;
  bool met = false;
  for (std::size_t part = 0; part < parts_.size(); ++part) {
    Piece outline = pieces.add(parts_[part]);
    for (std::size_t k = first_line; k < first_line + lines && outline.count >= 3; ++k) {
      const BorderLine& border = scratch.lines[k];
      if (pieces.divide(outline, border, nullptr) == Side::beyond) outline.count = 0;
    }
    if (outline.count < 3 || pieces.doubled_area(outline) <= 2 * least) continue;
    met = true;
    // Less what others hide already, cut away edge by edge.
    scratch.whole.assign(1, outline);
    for (const Scratch::Shade& shade : scratch.shades) {
      if (shade.light_part != part) continue;
      scratch.rest.clear();
      for (Piece piece : scratch.whole) {
        const auto begin = scratch.lines.begin() + static_cast<std::ptrdiff_t>(shade.first_line);
        const auto end = begin + static_cast<std::ptrdiff_t>(shade.lines);
        if (std::any_of(begin, end,
                        [&](const BorderLine& border) { return pieces.side(piece, border) == Side::beyond; })) {
          scratch.rest.push_back(piece);
          continue;
        }
        for (auto border = begin; border != end && piece.count >= 3; ++border) {
          Piece beyond = piece;
          const Side side = pieces.divide(piece, *border, &beyond);
          if (side == Side::within) continue;
          if (side == Side::beyond) piece.count = 0;
          if (beyond.count >= 3) scratch.rest.push_back(beyond);
        }
        if (piece.count >= 3 && pieces.doubled_area(piece) > 2 * least) scratch.overlap = true;
      }
      std::swap(scratch.whole, scratch.rest);
    }
    scratch.shades.push_back({outline, part, first_line, lines});
    for (const Piece& piece : scratch.whole) {
      const double area = 0.5 * pieces.doubled_area(piece);
      if (!(area > 0)) continue;
      share += area / area_;
      scratch.dark.push_back(piece);
    }
  }
  if (!met) return;
  scratch.met.push_back(caster);
  if (!(share > 0)) return;
  // Together they hide no more than there is.
  share = std::min(share, lit);
  lit -= share;
  scratch.hidden.push_back({caster, share});
}

bool AreaLight::borders(const Flat& caster, Vector p, Scratch& scratch) const {
  const Vector* corners = corners_.data() + caster.first;
  const Vector first = corners[0] - p;
  // Edge-on, the sign of the volume that caster and point span is rounding alone.
  const double volume = caster.plane.distance(p);
  if (std::abs(volume) <= 1e-12 * (caster.size + sum_of(first))) return false;
  const double sign = volume > 0 ? -1 : 1;
  const std::size_t mark = scratch.lines.size();
  Vector from = corners[caster.count - 1] - p;
  for (std::size_t k = 0; k < caster.count; ++k) {
    const Vector to = corners[k] - p;
    const Vector m = sign * cross(from, to);
    from = to;
    const BorderLine border{{m.x, m.y, -dot(m, p)},
                            rounding * (std::abs(m.x) * (radius_ + std::abs(p.x)) +
                                        std::abs(m.y) * (radius_ + std::abs(p.y)) + std::abs(m.z) * p.z)};
    bool some_within = false, some_beyond = false;
    for (const auto& part : parts_) {
      for (const moire::Point& corner : part) {
        const double value = border.line(corner);
        some_within |= value > border.tolerance;
        some_beyond |= value < -border.tolerance;
      }
    }
    if (!some_within) {
      scratch.lines.resize(mark);
      return false;
    }
    // A line with all of the light within bounds nothing.
    if (some_beyond) scratch.lines.push_back(border);
  }
  return true;
}

double AreaLight::irradiance_from_afar(const moire::Point* corners, std::size_t count, Vector p) const {
  double sum = 0;
  for (std::size_t k = 2; k < count; ++k) {
    const moire::Point &a = corners[0], &b = corners[k - 1], &c = corners[k];
    const double area = 0.5 * ((b.x - a.x) * (c.y - a.y) - (c.x - a.x) * (b.y - a.y));
    for (const TrianglePoint& at : seven_points) {
      const Vector r{at.a * a.x + at.b * b.x + at.c * c.x - p.x, at.a * a.y + at.b * b.y + at.c * c.y - p.y, -p.z};
      // Cosine at the receiver times cosine at the light over distance squared, of a radiance of 1.
      const double squared = dot(r, r);
      sum += at.weight * area * (dot(normal_, r) / squared) * (p.z / squared);
    }
  }
  return sum;
}

}  // namespace shadow_planes
