#include "seeing/shadow_frame.h"

#include <utility>

namespace shadow_planes {

ShadowFrame::ShadowFrame(World world, std::shared_ptr<const Bsp> bsp, const Camera& camera, const Look& look)
    : world_(std::move(world)),
      bsp_(std::move(bsp)),
      camera_(camera),
      look_(look),
      occluders_(world_, look.clip),
      shading_(world_, occluders_, camera.eye, look.shade),
      faces_(world_, camera),
      receivers_(world_, occluders_, shading_, faces_, look.shade) {}

void ShadowFrame::trace(std::span<const moire::SamplePoint> points, std::span<moire::Hit> hits,
                        moire::Counters& counters) const {
  counters.queries += points.size();
  faces_.look(
      points,
      [&](std::size_t k, std::uint32_t face, const Vector& p) {
        ++counters.hits;
        hits[k] = shading_.at(face, p, static_cast<double>(points[k].u), static_cast<double>(points[k].v));
      },
      [&](std::size_t k) {
        hits[k] = {moire::background, world_.sky};
      });
}

const moire::Polygons* ShadowFrame::polygons() const {
  const LightKind kind = world_.light.kind;
  const bool is_flat = kind == LightKind::directional || (kind == LightKind::point && look_.shade == Shade::flat);
  return is_flat ? this : nullptr;
}

const moire::Averages* ShadowFrame::averages() const {
  if (look_.clip == Clip::none) return nullptr;
  std::call_once(averages_once_, [this] {
    visible_.emplace(*bsp_, camera_);
    averages_.emplace(world_, camera_, *visible_, PixelAverages::Options{.is_flat = look_.shade == Shade::flat});
  });
  return &*averages_;
}

void ShadowFrame::stream(const moire::Rectangle& window, moire::PolygonSink& sink) const {
  std::call_once(polygons_once_,
                 [this] { polygons_.emplace(world_, *bsp_, camera_, occluders_, shading_, look_.clip); });
  polygons_->stream(window, sink);
}

}  // namespace shadow_planes
