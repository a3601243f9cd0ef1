#include "view_settings.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace heightfield {

namespace {

double spacing_y(const moire::Settings& settings) {
  const double given = settings.real("spacing_y");
  return given > 0 ? given : settings.real("spacing");
}

// Level l begins where level_constant times a pixel's footprint is 2^l voxels wide, or 2^(l - 1/2) where it is rounded
// to the nearest level: at the slant distance, to the ground at its mean height, of that over level_constant and
// pixel_angle.
std::vector<double> level_starts(const Voxels& voxels, const Camera& camera, const moire::Settings& settings) {
  std::vector<double> starts{0};
  const std::string& rule = settings.text("levels");
  if (rule == "none") return starts;
  const double drop = settings.real("view.height") - voxels.mean_height();
  const double spacing = std::sqrt(settings.real("spacing") * spacing_y(settings));
  const double least = rule == "round" ? spacing / std::numbers::sqrt2 : spacing;
  for (int l = 1; l < voxels.levels(); ++l) {
    const double slant = std::ldexp(least, l) / (settings.real("level_constant") * camera.pixel_angle());
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
  return {.model = {.grid = settings.text("walk") == "grid",
                    .azimuth = settings.text("azimuth") == "pixel" ? Azimuth::pixel : Azimuth::column,
                    .face = settings.text("face") == "box" ? Face::box : Face::near},
          .resume = settings.text("coherence") == "resume",
          .retrace = static_cast<int>(settings.integer("retrace")),
          .weights = settings.text("weights") == "area" ? Weights::area : Weights::height,
          .side_by_side = settings.flag("side_by_side")};
}

}  // namespace heightfield
