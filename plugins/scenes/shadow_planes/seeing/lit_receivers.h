// The receivers of an area light, and the maps of their irradiance.
#pragma once

#include <vector>

#include <moire/receivers.h>

#include "seeing/first_faces.h"
#include "seeing/shading.h"

namespace shadow_planes {

// Receivers are the faces whose seen side some of the light falls on, in the order of the list; their parallelograms
// are rectangles along their longest edges.
class LitReceivers final : public moire::Receivers {
 public:
  // All outlive this.
  LitReceivers(const World& world, const Occluders& occluders, const Shading& shading, const FirstFaces& faces,
               Shade shade);

  std::uint32_t count() const override { return static_cast<std::uint32_t>(frames_.size()); }
  Extent extent(std::uint32_t receiver) const override { return {frames_[receiver].width, frames_[receiver].height}; }
  void locate(std::span<const moire::SamplePoint> points, std::span<moire::ReceiverPoint> out,
              moire::Counters& counters) const override;
  void add_hard_shadows(std::uint32_t receiver, std::span<const moire::LightPoint> lights, moire::ShadowEdges edges,
                        moire::IrradianceMap& map) const override;
  moire::Hit shaded(std::uint32_t receiver, double irradiance) const override;

 private:
  // The rectangle around a receiver: along and down are of length 1 and at right angles.
  struct RectangleAround {
    std::uint32_t face;
    Vector corner, along, down;
    double width, height;
  };
  static RectangleAround around(std::uint32_t face, const World& world);
  class Batch;

  const World& world_;
  const Occluders& occluders_;
  const Shading& shading_;
  const FirstFaces& faces_;
  Shade shade_;
  std::vector<RectangleAround> frames_;
  std::vector<std::uint32_t> receiver_of_;  // of each face; ReceiverPoint::none if it is none
};

}  // namespace shadow_planes
