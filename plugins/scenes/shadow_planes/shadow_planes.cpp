// Planar polygons and the shadows that they cast on each other.
#include <moire/error.h>
#include <moire/plugin.h>

#include "seeing/shadow_frame.h"
#include "seeing/view_settings.h"
#include "world/faces.h"
#include "world/kinds.h"
#include "world/light_settings.h"
#include "world/source_file.h"

namespace shadow_planes {

namespace {

using namespace moire::parameter;
using moire::Settings;

constexpr moire::Parameter parameters[] = {
    choice("kind", "room", kinds,
           "a furnished room, or a floor and above it: a tilted quadrilateral; one parallel to the light; three apart; "
           "a wall that stands on it, and two that overlap; eight slats"),
    file("file", "faces and a light in JSON, as plugins/scenes/shadow_planes/world/source_file.h says; none: `kind`"),
    choice("show", "all", "all first",
           "the first face alone: the others cast their shadows on it, but do not stand before it"),
    choice("shading", "diffuse", "diffuse flat",
           "by distance and by how a surface is turned to the light, or one colour wherever light falls"),
    choice("clip", "both", "both none",
           "what of an occluder is projected: what lies between receiver and light, or all of it as in the published "
           "matrix, whose shadows are false then")
        .exact_when("both"),
    choice("light.kind", "area", "area point directional", "a polygon that shines, a point, or a far one"),
    real("light.size", 1, 1e-9, 1e3, "", "of area: multiplies its lengths, about its middle; its power stays")
        .per_frame(),
    real("light.x", 0, -1e6, 1e6, "units", "moves the light along x; of directional: added to the direction towards it")
        .per_frame(),
    real("light.y", 0, -1e6, 1e6, "units", "the same along y").per_frame(),
    real("light.z", 0, -1e6, 1e6, "units", "the same upward").per_frame(),
    real("light.brightness", 0.9, 0, 1e6, "",
         "what a white surface shows that faces the light at light.distance, were all of the light in one point")
        .per_frame(),
    real("light.distance", 4, 1e-3, 1e6, "units", "of area and point").per_frame(),
    real("ambient", 0.12, 0, 1e6, "", "what a white surface shows without the light").per_frame(),
    color("sky", "#b8d4f0", "colour where there is no face").per_frame(),
    real("view.x", 1.5, -1e6, 1e6, "units", "camera, along x").per_frame(),
    real("view.y", -7.5, -1e6, 1e6, "units", "camera, along y").per_frame(),
    real("view.z", 4.5, -1e6, 1e6, "units", "camera, upward").per_frame(),
    choice("view.aim", "target", "target angles", "what says where the camera looks"),
    real("view.target_x", 0, -1e6, 1e6, "units", "of aim target: what is seen in the middle of the image, along x")
        .per_frame(),
    real("view.target_y", 0, -1e6, 1e6, "units", "the same along y").per_frame(),
    real("view.target_z", 0.7, -1e6, 1e6, "units", "the same upward").per_frame(),
    real("view.yaw_deg", 90, -1e6, 1e6, "degrees", "of aim angles: 0 along x, 90 along y").per_frame(),
    real("view.pitch_deg", -30, -90, 90, "degrees", "of aim angles: above the horizontal").per_frame(),
    real("view.roll_deg", 0, -1e6, 1e6, "degrees", "turns the camera clockwise about the direction of view")
        .per_frame(),
    real("view.fov_deg", 50, 0.01, 170, "degrees", "angle of view across the width of the image").per_frame(),
};

class ShadowPlanes final : public moire::Scene {
 public:
  explicit ShadowPlanes(const Settings& settings) : source_(source_of(settings)) {
    share_planes(source_.faces);
    if (settings.text("show") == "first") {
      for (std::size_t k = 1; k < source_.faces.size(); ++k) source_.faces[k].shown = false;
    }
    World world;
    world.faces = source_.faces;
    bsp_ = std::make_shared<const Bsp>(world);
  }

  std::unique_ptr<moire::Frame> frame(const Settings& settings, moire::ImageSize size) const override {
    World world;
    world.faces = source_.faces;
    world.light = light_of(source_.light, settings);
    const auto ambient = static_cast<float>(settings.real("ambient"));
    world.ambient = {ambient, ambient, ambient};
    world.sky = moire::parse_color(settings.text("sky"));
    const Look look{settings.text("shading") == "flat" ? Shade::flat : Shade::diffuse,
                    settings.text("clip") == "none" ? Clip::none : Clip::both};
    return std::make_unique<ShadowFrame>(std::move(world), bsp_, camera_of(settings, size), look);
  }

 private:
  static Source source_of(const Settings& settings) {
    const std::string& file = settings.text("file");
    if (file.empty()) return kind_of_name(settings.text("kind"));
    const moire::Document document{std::filesystem::path(file)};
    Source source = read_source(document);
    const std::string problem = problem_of(source.light, light_kind_of(settings));
    if (!problem.empty()) document.root()["light"].refuse(problem);
    return source;
  }

  Source source_;
  std::shared_ptr<const Bsp> bsp_;
};

moire::Questions answers(const Settings& settings) {
  using enum moire::Questions;
  const LightKind kind = light_kind_of(settings);
  const bool has_averages = settings.text("clip") == "both";
  const bool is_flat = kind == LightKind::directional || settings.text("shading") == "flat";
  return points | (kind == LightKind::area ? receivers : none) | (has_averages ? averages : none) |
         (kind != LightKind::area && is_flat ? polygons : none);
}

std::string problem(const Settings& settings) {
  if (settings.text("clip") == "none" && light_kind_of(settings) == LightKind::area)
    return "clip of \"none\" is for hard shadows, of a light.kind that is point or directional; of an area, both";
  return {};
}

}  // namespace

}  // namespace shadow_planes

MOIRE_SCENE(shadow_planes, "1.0.0",
            (moire::ScenePlugin{
                .summary = "Planar polygons under a point, directional or area light, and the shadows that they cast.",
                .source = "Blinn 1988; Heckbert and Herf 1997",
                .parameters = shadow_planes::parameters,
                .answers = shadow_planes::answers,
                .problem = shadow_planes::problem,
                .make = [](const moire::Settings& settings) -> std::unique_ptr<moire::Scene> {
                  return std::make_unique<shadow_planes::ShadowPlanes>(settings);
                },
            }))
