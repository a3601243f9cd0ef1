// Worlds, cameras and frames of the scene's own making, as its settings give them.
#pragma once

#include <memory>
#include <string>

#include "seeing/shadow_frame.h"
#include "seeing/view_settings.h"
#include "support/plugins.h"
#include "world/faces.h"
#include "world/kinds.h"
#include "world/light_settings.h"

namespace moire::test {

inline Settings shadow_settings(const Changes& changes = {}) {
  return changed(scene_plugin("shadow_planes").parameters, changes);
}

// A built-in world. Requires: settings of the scene without a file.
inline shadow_planes::World built_in_world(const Settings& settings) {
  shadow_planes::Source source = shadow_planes::kind_of_name(settings.text("kind"));
  shadow_planes::share_planes(source.faces);
  shadow_planes::World world;
  world.faces = source.faces;
  world.light = light_of(source.light, settings);
  return world;
}

inline std::unique_ptr<shadow_planes::ShadowFrame> frame_of(const shadow_planes::World& world,
                                                            const shadow_planes::Camera& camera,
                                                            const shadow_planes::Look& look = {}) {
  return std::make_unique<shadow_planes::ShadowFrame>(world, std::make_shared<const shadow_planes::Bsp>(world), camera,
                                                      look);
}

inline Hit hit_at(const Frame& frame, const SamplePoint& point) {
  Hit hit;
  Counters counters;
  frame.trace({&point, 1}, {&hit, 1}, counters);
  return hit;
}

}  // namespace moire::test
