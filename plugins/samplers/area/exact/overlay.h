// What is visible of ordered polygons, resolved once: the boundaries between visible layers, all over the plane.
//
// The picture is the background plus, for each boundary, the change of colour across it wherever it lies to the right:
// a sum, so that boundaries may be added up in any order, without layers and without sorting.
#pragma once

#include <cstdint>
#include <vector>

#include <moire/geometry.h>

#include "exact/layers.h"

namespace area {

class Overlay {
 public:
  // From upper to lower end; `left` and `right` are what is visible on its sides.
  struct Boundary {
    moire::Point upper, lower;
    std::uint32_t left, right;
  };

  // Boundaries that are level are left out.
  explicit Overlay(Layers layers);

  const Layers& layers() const { return layers_; }
  const std::vector<Boundary>& boundaries() const { return boundaries_; }

 private:
  Layers layers_;
  std::vector<Boundary> boundaries_;
};

}  // namespace area
