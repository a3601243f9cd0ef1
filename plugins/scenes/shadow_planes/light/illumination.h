// How much of the light reaches points of a receiver, and what hides the rest.
#pragma once

#include <memory>
#include <span>
#include <vector>

#include "light/casters.h"
#include "light/edge_sum.h"
#include "light/pieces.h"

namespace shadow_planes {

// What reaches a point.
struct Reach {
  // Of an area light of radiance 1, a point light of radiant intensity 1, a directional light of irradiance 1.
  double irradiance = 0;
  double lit = 0;  // share of the light's area that is seen; 0 or 1 of lights without area
};

class Illumination {
 public:
  // What a caster hides that none before it hides, as a share of the light's area.
  struct Hidden {
    std::uint32_t caster;
    double share;
  };
  // What at() finds out beside its result, and room to work in. One a thread.
  struct Scratch {
    std::vector<Hidden> hidden;
    std::vector<std::uint32_t> met;  // casters that hide something, were they alone
    bool overlap = false;            // two of them hide one part of the light

    struct Shade {
      Piece outline;
      std::size_t light_part, first_line, lines;
    };
    Pieces pieces;
    std::vector<BorderLine> lines;
    std::vector<Shade> shades;
    std::vector<Piece> whole, rest, dark;
    EdgeSum sum;
  };

  virtual ~Illumination() = default;

  // Of the point x on the receiver. `candidates`, rising: casters that can hide some of the light from x; others are
  // not looked at.
  virtual Reach at(Vector x, std::span<const std::uint32_t> candidates, Scratch& scratch) const = 0;

  // Replaces `out` by those of the candidates that may hide some of the light from a point of the convex hull of these
  // points of the receiver.
  virtual void narrow(std::span<const Vector> hull, std::span<const std::uint32_t> candidates,
                      std::vector<std::uint32_t>& out) const = 0;

  const Plane& side() const { return side_; }
  const std::vector<Caster>& casters() const { return casters_; }
  // All casters.
  std::span<const std::uint32_t> all() const { return all_; }

 protected:
  Illumination(const World& world, std::uint32_t receiver, const Plane& side);

 private:
  Plane side_;
  std::vector<Caster> casters_;
  std::vector<std::uint32_t> all_;
};

// `side`: the receiver's plane, its normal to the side that is looked at.
std::unique_ptr<const Illumination> illumination_of(const World& world, std::uint32_t receiver, const Plane& side);

}  // namespace shadow_planes
