// The order of faces from any eye: a binary space partition (Fuchs, Kedem, Naylor 1980, doi:10.1145/800250.807481).
#pragma once

#include <memory>
#include <vector>

#include "world/world.h"

namespace shadow_planes {

class Bsp {
 public:
  // A part of a face, cut by the planes of others.
  struct Fragment {
    std::uint32_t face;
    Convex outline;
  };

  explicit Bsp(const World& world);
  ~Bsp();

  // No fragment hides one before it. Of those in one plane the first face of the list comes first; what the eye sees
  // edge-on is left out.
  std::vector<const Fragment*> front_to_back(Vector eye) const;

 private:
  struct Node;
  static std::unique_ptr<const Node> node_of(std::vector<Fragment> fragments, const World& world, double tolerance);

  std::unique_ptr<const Node> root_;
};

}  // namespace shadow_planes
