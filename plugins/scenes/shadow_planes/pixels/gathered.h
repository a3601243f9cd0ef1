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
};

// Asks a face for points, and keeps by whom they are shadowed where that is wanted.
class Gatherer {
 public:
  Gatherer(bool is_flat, bool keeps_shadows) : is_flat_(is_flat), keeps_shadows_(keeps_shadows) {}

  // Of one point, times the weight.
  Sums at(const SeenFace& face, moire::Point p, std::span<const std::uint32_t> candidates, double weight) {
    ++evaluations;
    const Reach reach = face.illumination().at(face.point(p), candidates, scratch);
    if (keeps_shadows_) {
      for (const auto& [caster, share] : scratch.hidden) {
        shadows_.push_back({face.illumination().casters()[caster].face, weight * share});
      }
    }
    return {weight * (is_flat_ ? reach.lit : reach.irradiance), weight * reach.lit};
  }

  bool keeps_shadows() const { return keeps_shadows_; }
  // Faces and the weights they shadow, since a mark.
  std::size_t mark() const { return shadows_.size(); }
  void forget(std::size_t mark) { shadows_.resize(mark); }
  // Drops those from `from` up to the mark.
  void forget(std::size_t from, std::size_t mark) {
    shadows_.erase(shadows_.begin() + static_cast<std::ptrdiff_t>(from),
                   shadows_.begin() + static_cast<std::ptrdiff_t>(mark));
  }
  const std::vector<std::pair<std::uint32_t, double>>& shadows() const { return shadows_; }

  Illumination::Scratch scratch;  // of the last point
  std::uint64_t evaluations = 0;

 private:
  bool is_flat_, keeps_shadows_;
  std::vector<std::pair<std::uint32_t, double>> shadows_;
};

}  // namespace shadow_planes
