// Faces as obstacles of light.
#pragma once

#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "hard/shadow.h"
#include "world/world.h"

namespace shadow_planes {

// The seen side of a face, and who may shadow it.
struct Receiver {
  Plane side;                            // its normal points to the eye
  std::vector<std::uint32_t> occluders;  // by their place in the list
};

class Occluders {
 public:
  static constexpr std::uint32_t none = std::numeric_limits<std::uint32_t>::max();

  // `world` outlives this.
  Occluders(const World& world, Clip clip);

  // Distances below it are rounding: 1e-12 of the largest coordinate of faces and light.
  double tolerance() const { return tolerance_; }
  // Whether light from there falls on this side of a plane: in it, it does not.
  bool faces(const Plane& side, const Homogeneous& light) const {
    return side.of(light) > (light.w > 0 ? tolerance_ : 1e-12);
  }

  // The side of a face that the eye sees; with Clip::both, who lies wholly behind it is left out of its occluders.
  Receiver receiver(std::uint32_t face, Vector eye) const;

  // Those of a face that casts shadows. Of area lights: what lies in the light's plane is moved before it by 1e-9 of
  // the largest coordinate, so that it hides its share of the light.
  const std::vector<Convex>& parts(std::uint32_t face) const { return obstacles_[face].parts; }
  // Whether the face is seen edge-on from there and so hides nothing.
  bool is_edge_on(std::uint32_t face, const Homogeneous& light) const {
    return std::abs(obstacles_[face].plane.of(light)) <= (light.w > 0 ? tolerance_ : 1e-12);
  }

  // Whether the face crosses the open segment from a point of a receiver to the light. One that the point lies in the
  // plane of hides nothing. With Clip::none: whether the point is in the published shadow.
  bool hides(std::uint32_t face, const Plane& receiver, const Vector& point, const Homogeneous& light) const;
  // The first of the receiver's list that hides the light; or none.
  std::uint32_t first_that_hides(const Receiver& receiver, const Vector& point, const Homogeneous& light) const {
    for (const std::uint32_t face : receiver.occluders) {
      if (hides(face, receiver.side, point, light)) return face;
    }
    return none;
  }

 private:
  struct Obstacle {
    Plane plane;
    std::vector<Convex> parts;
    std::vector<std::vector<Plane>> sides;  // of each part: through its edges, the part on their upper side
  };

  bool is_in_published_shadow(const Obstacle& obstacle, const Plane& receiver, const Vector& point,
                              const Homogeneous& light) const;

  const World& world_;
  Clip clip_;
  double tolerance_ = 0;
  std::vector<Obstacle> obstacles_;
};

}  // namespace shadow_planes
