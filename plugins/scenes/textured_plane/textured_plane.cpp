// A textured plane in perspective: an image, or a checkerboard, up to a limit before the horizon.
#include <moire/plugin.h>

#include "frame.h"
#include "texels.h"

namespace textured_plane {

namespace {

using namespace moire::parameter;

constexpr moire::Parameter parameters[] = {
    file("texture", "image that lies on the plane; none: a checkerboard"),
    choice("wrap", "repeat", "repeat mirror clamp", "how the image goes on beyond its border; a checkerboard repeats"),
    real("scale", 1, 1e-6, 1e6, "units", "side of a texel of the image"),
    real("cell", 16, 1e-6, 1e6, "units", "side of a cell of the checkerboard"),
    color("light", "#ffffff", "colour of the cell at the corner where x and y are 0, and of every other one"),
    color("dark", "#000000", "colour of the other cells"),
    real("far", 2000, 0, 1e9, "units",
         "how far ahead of the camera, along the plane in the direction of view, the texture ends: on a line parallel "
         "to the horizon; the ground beyond is one element, of the texture's mean colour")
        .per_frame(),
    color("sky", "#b8d4f0", "colour above the horizon").per_frame(),
    real("tolerance", 1e-4, 1e-9, 1, "",
         "of exact averages in views with roll, or with a yaw that is no multiple of 90: how large the error of a "
         "block's mean may be, by its area in the pixel; its sum over a pixel is bounded and reported")
        .per_frame(),
    real("view.x", 100, -1e9, 1e9, "units", "camera, eastward from the texture's north-west corner").per_frame(),
    real("view.y", 100, -1e9, 1e9, "units", "camera, southward from the texture's north-west corner").per_frame(),
    real("view.height", 40, 1e-6, 1e9, "units", "camera above the plane").per_frame(),
    real("view.yaw_deg", -90, -1e6, 1e6, "degrees", "direction of view: 0 east, 90 south").per_frame(),
    real("view.pitch_deg", -10, -90, 90, "degrees", "direction of view above the horizontal").per_frame(),
    real("view.roll_deg", 0, -1e6, 1e6, "degrees", "turns the camera clockwise about the direction of view")
        .per_frame(),
    real("view.fov_deg", 50, 0.01, 170, "degrees", "angle of view across the width of the image").per_frame(),
};

class TexturedPlane final : public moire::Scene {
 public:
  explicit TexturedPlane(const moire::Settings& settings)
      : texels_(load_texels(settings)), texel_size_(texel_size(settings)) {}

  std::unique_ptr<moire::Frame> frame(const moire::Settings& settings, moire::ImageSize size) const override {
    return std::make_unique<PlaneFrame>(camera_of(settings, size, texel_size_), *texels_,
                                        moire::parse_color(settings.text("sky")), settings.real("tolerance"));
  }

 private:
  std::unique_ptr<Texels> texels_;
  double texel_size_;
};

}  // namespace

}  // namespace textured_plane

MOIRE_SCENE(textured_plane, "1.0.0",
            (moire::ScenePlugin{
                .summary = "A plane in perspective with an image on it, or a checkerboard.",
                .source = "Heckbert 1989, Fundamentals of Texture Mapping and Image Warping, section 2.2.3: the "
                          "projective map of a plane",
                .parameters = textured_plane::parameters,
                .answers =
                    [](const moire::Settings&) {
                      using enum moire::Questions;
                      return points | surface | averages;
                    },
                .make = [](const moire::Settings& settings) -> std::unique_ptr<moire::Scene> {
                  return std::make_unique<textured_plane::TexturedPlane>(settings);
                },
            }))
