// Lines and circles, from JSON or built in, moved by the view and each by itself.
#include <moire/plugin.h>

#include "seeing/frame.h"
#include "seeing/placement.h"
#include "world/built_in.h"
#include "world/reading.h"

namespace primitives {

namespace {

using namespace moire::parameter;
using moire::Settings;

constexpr moire::Parameter parameters[] = {
    file("file", "lines and circles, in JSON; none: those of a kind"),
    choice("kind", "mixed", "mixed fan circles random line circle",
           "a picture of both; lines from one point; circles about one point; any; one line; one circle"),
    integer("count", 40, 0, 1000000, "", "of fan, circles, random: how many"),
    integer("seed", 1, 0, 1000000000, "", "of random"),
    real("x", 0, -largest_length, largest_length, "pixels",
         "of line, circle: how far right of the image's middle its own is")
        .per_frame(),
    real("y", 0, -largest_length, largest_length, "pixels", "of line, circle: how far below").per_frame(),
    real("length", 100, 0, largest_length, "pixels", "of line").per_frame(),
    real("angle_deg", 30, -1e6, 1e6, "degrees", "of line, fan: clockwise, of the (first) line").per_frame(),
    real("radius", 50, 0, largest_length, "pixels", "of circle").per_frame(),
    real("velocity.x", 0, -largest_length, largest_length, "pixels/time", "of line, circle").per_frame(),
    real("velocity.y", 0, -largest_length, largest_length, "pixels/time", "of line, circle").per_frame(),
    real("spin_deg", 0, -1e6, 1e6, "degrees/time", "of line: clockwise about its middle").per_frame(),
    color("color", "#000000", "of what has none of its own"),
    real("width", 1, 0, largest_length, "pixels",
         "of what has none of its own; random: the smallest; mixed: of the thin ones"),
    choice("cap", "butt", "butt square round", "how lines end that do not say it"),
    color("background", "#ffffff", "colour where nothing is drawn, unless the file names its own").per_frame(),
    flag("scale_widths", true, "zooming changes widths, too; else they are in pixels of the image"),
    real("tolerance", 0.01, 1e-4, 10, "pixels",
         "of polygons: how far chords may be from their arc; their area is the arc's"),
    real("time", 0, -1e6, 1e6, "", "when: velocities and spins are per unit of it").per_frame(),
    real("view.x", 0, -1e9, 1e9, "pixels", "how far right of the picture's (0, 0) the image's middle is").per_frame(),
    real("view.y", 0, -1e9, 1e9, "pixels", "how far below the picture's (0, 0) the image's middle is").per_frame(),
    real("view.zoom", 1, 1e-6, 1e6, "", "enlarges about the image's middle").per_frame(),
    real("view.rotation_deg", 0, -1e6, 1e6, "degrees", "turns the picture clockwise about the image's middle")
        .per_frame(),
};

Style style_of(const Settings& settings) {
  const std::string& cap = settings.text("cap");
  return {moire::parse_color(settings.text("color")), settings.real("width"),
          cap == "round"    ? moire::Cap::round
          : cap == "square" ? moire::Cap::square
                            : moire::Cap::butt};
}

class Primitives final : public moire::Scene {
 public:
  explicit Primitives(const Settings& settings) : style_(style_of(settings)) {
    const std::string& file = settings.text("file");
    if (!file.empty()) read_ = read_picture(moire::Document(std::filesystem::path(file)), style_);
  }

  std::unique_ptr<moire::Frame> frame(const Settings& settings, moire::ImageSize size) const override {
    std::optional<Picture> made;
    if (!read_) made = built_in(settings, style_, size);
    const Picture& picture = read_ ? *read_ : *made;
    const moire::Color background = picture.background.value_or(moire::parse_color(settings.text("background")));
    return std::make_unique<PrimitivesFrame>(placed(picture.primitives, settings.real("time"), view_of(settings, size)),
                                             size, background, settings.real("tolerance"));
  }

 private:
  Style style_;
  std::optional<Picture> read_;
};

}  // namespace

}  // namespace primitives

MOIRE_SCENE(primitives, "1.0.0",
            (moire::ScenePlugin{
                .summary = "Lines and circles of any width, from JSON or built in.",
                .source = "Jang 1997: lines and circles with real end points and radii; Wu 1991",
                .parameters = primitives::parameters,
                .answers =
                    [](const moire::Settings&) {
                      using enum moire::Questions;
                      return points | lines | polygons | curves;
                    },
                .make = [](const moire::Settings& settings) -> std::unique_ptr<moire::Scene> {
                  return std::make_unique<primitives::Primitives>(settings);
                },
            }))
