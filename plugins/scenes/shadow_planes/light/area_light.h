// A polygonal light as a point of a receiver sees it: what is left of it behind all casters, and its irradiance.
//
// The light's plane is z = 0 of the coordinates used here, its front is above. A caster hides from x the part of the
// light between the planes through x and its edges, which meet the light's plane in lines: all cutting is done there,
// in the plane, where areas are shares of the light. What several casters hide is cut into disjoint convex pieces.
// Irradiance of a piece is Lambert's sum over its edges (Lambert 1760; in the form of Baum, Rushmeier, Winget 1989,
// doi:10.1145/74333.74367, eq. 4).
#pragma once

#include "light/illumination.h"

namespace shadow_planes {

class AreaLight : public Illumination {
 public:
  AreaLight(const World& world, std::uint32_t receiver, const Plane& side);

  Reach at(Vector x, std::span<const std::uint32_t> candidates, Scratch& scratch) const override;
  void narrow(std::span<const Vector> hull, std::span<const std::uint32_t> candidates,
              std::vector<std::uint32_t>& out) const override;

 private:
  struct Flat {
    std::uint32_t face;
    Plane plane;
    double size;
    std::size_t first, count;  // of corners_
  };

  Vector placed(Vector p) const { return turned(p - origin_); }
  Vector turned(Vector v) const { return {dot(v, across_), dot(v, along_), dot(v, front_)}; }
  // Appends the lines that bound what the caster hides from p. False: nothing that the light has.
  bool borders(const Flat& caster, Vector p, Scratch& scratch) const;
  // Takes from `lit` what the caster hides first.
  void add_hidden(std::uint32_t caster, Vector p, double& lit, Scratch& scratch) const;
  // By quadrature of the kernel.
  double irradiance_from_afar(const moire::Point* corners, std::size_t count, Vector p) const;

  Vector origin_, across_, along_, front_;
  Vector normal_;  // of the receiver
  std::vector<std::vector<moire::Point>>
      parts_;                          // of the light, as far as they are before the receiver; positive areas
  double radius_ = 0;                  // of the light around the origin
  double area_ = 0, front_share_ = 0;  // of the whole light; the share of it before the receiver
  std::vector<Flat> flats_;            // the casters
  std::vector<Vector> corners_;
};

}  // namespace shadow_planes
