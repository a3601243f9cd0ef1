// A world of planar faces under one light, seen by a camera.
#pragma once

#include <memory>
#include <mutex>
#include <optional>

#include <moire/frame.h>

#include "pixels/pixel_averages.h"
#include "seeing/bsp.h"
#include "seeing/first_faces.h"
#include "seeing/lit_receivers.h"
#include "seeing/shading.h"
#include "seeing/shadow_polygons.h"
#include "seeing/visible_parts.h"

namespace shadow_planes {

// How a world is looked at.
struct Look {
  Shade shade = Shade::diffuse;
  Clip clip = Clip::both;
};

class ShadowFrame final : public moire::Frame, private moire::Polygons {
 public:
  // `bsp`: of these faces. Requires: Clip::both if the light is an area.
  ShadowFrame(World world, std::shared_ptr<const Bsp> bsp, const Camera& camera, const Look& look);

  moire::ImageSize size() const override { return camera_.size; }
  void trace(std::span<const moire::SamplePoint> points, std::span<moire::Hit> hits,
             moire::Counters& counters) const override;
  const moire::Polygons* polygons() const override;
  const moire::Receivers* receivers() const override {
    return world_.light.kind == LightKind::area ? &receivers_ : nullptr;
  }
  const moire::Averages* averages() const override;

 private:
  // Polygons.
  bool disjoint() const override { return false; }
  void stream(const moire::Rectangle& window, moire::PolygonSink& sink) const override;
  moire::Color background_color() const override { return world_.sky; }

  World world_;
  std::shared_ptr<const Bsp> bsp_;
  Camera camera_;
  Look look_;
  Occluders occluders_;
  Shading shading_;
  FirstFaces faces_;
  LitReceivers receivers_;
  // Made when they are first asked for.
  mutable std::once_flag polygons_once_;
  mutable std::optional<ShadowPolygons> polygons_;
  mutable std::once_flag averages_once_;
  mutable std::optional<VisibleParts> visible_;
  mutable std::optional<PixelAverages> averages_;
};

}  // namespace shadow_planes
