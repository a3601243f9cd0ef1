#include "view_settings.h"

#include <algorithm>
#include <cmath>

namespace heightfield {

namespace {

double spacing_y(const moire::Settings& settings) {
  const double given = settings.real("spacing_y");
  return given > 0 ? given : settings.real("spacing");
}

// Level l begins where a pixel's footprint is 2^l / level_constant voxels wide: at the slant distance, to the ground at
// its mean height, of 2^l spacing / (level_constant pixel_angle).
std::vector<double> level_starts(const Voxels& voxels, const Camera& camera, const moire::Settings& settings) {
  std::vector<double> starts{0};
  if (!settings.flag("hierarchy")) return starts;
  const double drop = settings.real("view.height") - voxels.mean_height();
  const double spacing = std::sqrt(settings.real("spacing") * spacing_y(settings));
  for (int l = 1; l < voxels.levels(); ++l) {
    const double slant = std::ldexp(spacing, l) / (settings.real("level_constant") * camera.pixel_angle());
    starts.push_back(std::sqrt(std::max(0.0, slant * slant - drop * drop)));
  }
  return starts;
}

Skip skip_of(const std::string& name) {
  return name == "auto" ? Skip::where_it_pays : name == "on" ? Skip::everywhere : Skip::nowhere;
}

}  // namespace

Camera camera_of(const moire::Settings& settings, moire::ImageSize size) {
  return {size,
          settings.real("view.yaw_deg"),
          settings.real("view.pitch_deg"),
          settings.real("view.fov_deg"),
          settings.real("spacing"),
          spacing_y(settings)};
}

View view_of(const moire::Settings& settings, const Voxels& voxels, const Camera& camera) {
  const double dx = settings.real("spacing"), dy = spacing_y(settings);
  return {
      &voxels, settings.real("view.x") / dx, settings.real("view.y") / dy,           settings.real("view.height"),  dx,
      dy,      settings.real("far"),         level_starts(voxels, camera, settings), skip_of(settings.text("skip"))};
}

Manner manner_of(const moire::Settings& settings) {
  return {settings.text("walk") == "grid", settings.text("coherence") == "resume",
          static_cast<int>(settings.integer("retrace"))};
}

}  // namespace heightfield
