// A terrain of voxels: boxes with flat tops over a regular grid, a colour each, mirrored to infinity.
#include <algorithm>

#include <moire/plugin.h>

#include "frame.h"
#include "terrain.h"
#include "view_settings.h"

namespace heightfield {

namespace {

using namespace moire::parameter;

constexpr moire::Parameter parameters[] = {
    file("height", "image of heights, first channel, in the file's own numbers; none: a generated terrain"),
    file("color", "image of colours over the same ground; needed with a height image"),
    choice("generate", "fractal", "fractal", "the terrain made where no height image is given"),
    integer("size", 1024, 1, 8192, "voxels", "side of a generated terrain"),
    integer("seed", 1, 0, std::int64_t{1} << 53, "", "which generated terrain"),
    real("relief", 100, 0, 1e6, "units", "height of a generated terrain's summits above its lowlands"),
    choice("grid", "height", "height color",
           "the image whose pixels are the voxels; the other one is averaged over them"),
    real("spacing", 1, 1e-9, 1e9, "units", "side of a voxel from west to east"),
    real("spacing_y", 0, 0, 1e9, "units", "side of a voxel from north to south; 0: square voxels"),
    real("height_scale", 1, -1e9, 1e9, "units", "height for a step of one in the image's numbers"),
    real("height_exponent", 1, 1e-3, 1e3, "", "bends heights between the lowest and the highest: 2 flattens lowlands"),
    real("height_offset", 0, -1e9, 1e9, "units", "added to all heights"),
    real("far", 4000, 0, 1e9, "units",
         "horizontal distance from the camera where the terrain ends; 0: none, 1e9: as good as endless")
        .per_frame(),
    color("sky", "#b8d4f0", "colour where no terrain is seen").per_frame(),
    choice("walk", "grid", "grid major", "visit every voxel under a ray, or one a step along its major axis")
        .per_frame()
        .exact_when("grid"),
    choice("coherence", "resume", "none resume", "a ray goes on where the one below it ended, or starts afresh")
        .per_frame(),
    integer("retrace", 0, 0, 1 << 20, "voxels", "how far a resuming ray goes back first").per_frame(),
    choice(
        "skip", "auto", "auto on off",
        "pass over voxels that their block's summit shows to be hidden: where a walk finds long runs of them, always "
        "or never; the result is the same")
        .per_frame(),
    choice("azimuth", "pixel", "pixel column",
           "points and upright lines look each pixel's own way, or that of their column in the middle row")
        .per_frame()
        .exact_when("pixel"),
    choice("face", "box", "box near", "of a voxel its box is seen, or a thin wall on its near side")
        .per_frame()
        .exact_when("box"),
    choice("weights", "area", "area height",
           "what lines see is weighed by its length in the image, or by its height where it stands")
        .per_frame()
        .exact_when("area"),
    choice("levels", "none", "none floor round",
           "walk over mean voxels of a power-of-two width: level_constant times a pixel's footprint, rounded")
        .per_frame()
        .exact_when("none"),
    real("level_constant", 0.9, 1e-3, 1e3, "", "voxel width over footprint width, before it is rounded").per_frame(),
    flag("side_by_side", true,
         "upright lines are followed many at once in the machine's vectors, where they can be; the result is the same")
        .per_frame(),
    real("view.x", 512, -1e9, 1e9, "units", "camera, eastward from the north-west corner").per_frame(),
    real("view.y", 980, -1e9, 1e9, "units", "camera, southward from the north-west corner").per_frame(),
    real("view.height", 120, -1e9, 1e9, "units",
         "camera above datum, where heights are 0; below the top of its voxel it sees that voxel alone")
        .per_frame(),
    real("view.yaw_deg", -90, -1e6, 1e6, "degrees", "direction of view: 0 east, 90 south").per_frame(),
    real("view.pitch_deg", -14, -90, 90, "degrees", "direction of view above the horizontal").per_frame(),
    real("view.fov_deg", 50, 0.01, 170, "degrees", "angle of view across the width of the image").per_frame(),
};

// Whether the terrain is seen as it is: no setting in place that makes it another one.
bool is_exact(const moire::Settings& settings) {
  return std::all_of(std::begin(parameters), std::end(parameters),
                     [&](const moire::Parameter& p) { return p.exact.empty() || settings.text(p.name) == p.exact; });
}

class Heightfield final : public moire::Scene {
 public:
  explicit Heightfield(const moire::Settings& settings)
      : voxels_(load_terrain(settings)), texture_(voxels_.texture()) {}

  std::unique_ptr<moire::Frame> frame(const moire::Settings& settings, moire::ImageSize size) const override {
    const Camera camera = camera_of(settings, size);
    Look look(size, view_of(settings, voxels_, camera), camera, manner_of(settings));
    return std::make_unique<HeightfieldFrame>(std::move(look), moire::parse_color(settings.text("sky")), texture_,
                                              is_exact(settings));
  }

 private:
  Voxels voxels_;
  moire::Texture texture_;
};

}  // namespace

}  // namespace heightfield

MOIRE_SCENE(heightfield, "1.0.0",
            (moire::ScenePlugin{
                .summary = "A terrain of coloured voxels under a camera, from images or generated.",
                .source = "Cohen-Or 1997, sections 3 and 4",
                .parameters = heightfield::parameters,
                .answers =
                    [](const moire::Settings& settings) {
                      using enum moire::Questions;
                      const moire::Questions always = points | lines | radial_lines | surface;
                      return heightfield::is_exact(settings) ? always | polygons : always;
                    },
                .problem = [](const moire::Settings& settings) -> std::string {
                  const bool has_height = !settings.text("height").empty(), has_color = !settings.text("color").empty();
                  if (has_height && !has_color) return "has a height image and no color; give both";
                  if (!has_height && has_color) return "has a color image and no height; give both";
                  return {};
                },
                .make = [](const moire::Settings& settings) -> std::unique_ptr<moire::Scene> {
                  return std::make_unique<heightfield::Heightfield>(settings);
                },
            }))
