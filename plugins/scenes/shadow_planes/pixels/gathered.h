// Weighted sums of what reaches points of a face.
#pragma once

#include <utility>
#include <vector>

#include "pixels/seen_face.h"

namespace shadow_planes {

struct Sums {
  double light = 0;  // irradiance; where shading is flat, as `lit`
  double lit = 0;    // share of the light that is seen

  friend Sums operator+(const Sums& a, const Sums& b) { return {a.light + b.light, a.lit + b.lit}; }
  friend Sums operator*(double f, const Sums& a) { return {f * a.light, f * a.lit}; }
};

// Asks a face for points, and keeps by whom they are shadowed where that is wanted.
class Gatherer {
 public:
  struct Shadow {
    std::uint64_t point;  // by number
    std::uint32_t face;
    double weight;
  };

  Gatherer(bool is_flat, bool keeps_shadows) : is_flat_(is_flat), keeps_shadows_(keeps_shadows) {}

  // Of one point, times the weight.
  Sums at(const SeenFace& face, moire::Point p, std::span<const std::uint32_t> candidates, double weight) {
    const Reach reach = face.illumination().at(face.point(p), candidates, scratch);
    if (keeps_shadows_) {
      for (const auto& [caster, share] : scratch.hidden) {
        shadows_.push_back({points_, face.illumination().casters()[caster].face, weight * share});
      }
    }
    ++points_;
    return {weight * (is_flat_ ? reach.lit : reach.irradiance), weight * reach.lit};
  }
  std::uint64_t points() const { return points_; }

  // Shadows of points, since a mark.
  std::size_t mark() const { return shadows_.size(); }
  const std::vector<Shadow>& shadows() const { return shadows_; }
  void forget(std::size_t mark) { shadows_.resize(mark); }
  // Drops those from `from` up to the mark.
  void forget(std::size_t from, std::size_t mark) {
    shadows_.erase(shadows_.begin() + static_cast<std::ptrdiff_t>(from),
                   shadows_.begin() + static_cast<std::ptrdiff_t>(mark));
  }
  // Multiplies those of the last weights.size() points with their weights and a factor.
  void weigh(std::size_t mark, std::span<const double> weights, double factor) {
    for (std::size_t k = mark; k < shadows_.size(); ++k) {
      shadows_[k].weight *= factor * weights[static_cast<std::size_t>(shadows_[k].point - (points_ - weights.size()))];
    }
  }

  Illumination::Scratch scratch;  // of the last point

 private:
  bool is_flat_, keeps_shadows_;
  std::uint64_t points_ = 0;
  std::vector<Shadow> shadows_;
};

}  // namespace shadow_planes
