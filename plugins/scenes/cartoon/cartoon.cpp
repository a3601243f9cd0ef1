// Layers of flat opaque polygons, from SVG or JSON, or a small cartoon of our own.
#include <cmath>
#include <deque>
#include <mutex>

#include <moire/plugin.h>

#include "own/own_cartoon.h"
#include "reading/paint.h"
#include "reading/reading.h"
#include "seeing/frame.h"
#include "seeing/placement.h"

namespace cartoon {

namespace {

using namespace moire::parameter;

constexpr moire::Parameter parameters[] = {
    file("file", "the drawing, in SVG or JSON; none: a cat before a picket fence"),
    choice("unsupported", "refuse", "refuse skip",
           "what flat opaque layers cannot show (strokes, gradients, transparency, text ...) is listed and the drawing "
           "refused, or it is left out"),
    choice("blend", "linear", "linear as_stored",
           "what averages are taken of: light, or the numbers that files store, as most 2-D renderers do"),
    color("background", "#ffffff", "colour where nothing is drawn, unless the drawing names its own").per_frame(),
    real("tolerance", 0.05, 1e-4, 100, "pixels",
         "how far from its curve a chord may be: curve P over h takes chords no longer than sqrt(8 tolerance / |P''|)"),
    real("view.x", 0, -1e9, 1e9, "units", "how far right of the view box's middle the image's middle is").per_frame(),
    real("view.y", 0, -1e9, 1e9, "units", "how far below the view box's middle the image's middle is").per_frame(),
    real("view.zoom", 1, 1e-6, 1e6, "", "1: the view box just fits into the image").per_frame(),
    real("view.rotation_deg", 0, -1e6, 1e6, "degrees", "turns the drawing clockwise about the image's middle")
        .per_frame(),
};

class Cartoon final : public moire::Scene {
 public:
  explicit Cartoon(const moire::Settings& settings)
      : drawing_(drawing_of(settings)),
        blend_(settings.text("blend") == "as_stored" ? moire::Blend::as_stored : moire::Blend::linear),
        tolerance_(settings.real("tolerance")) {}

  std::unique_ptr<moire::Frame> frame(const moire::Settings& settings, moire::ImageSize size) const override {
    const Placement placement = placement_of(*drawing_.view_box, settings, size);
    const Rgb background = drawing_.background.value_or(parse_hex(settings.text("background")));
    return std::make_unique<CartoonFrame>(outlines_at(placement.scale), placement.map, size,
                                          color_of(background, blend_), blend_);
  }

 private:
  static Drawing drawing_of(const moire::Settings& settings) {
    const std::string& file = settings.text("file");
    if (file.empty()) return own_cartoon();
    return read_drawing_file(file, settings.text("unsupported") == "skip" ? Unmodelled::skip : Unmodelled::refuse);
  }

  // Outlines for all scales from one power of two to the next, so that they stay the same while a zoom stays there.
  std::shared_ptr<const Outlines> outlines_at(double scale) const {
    const int power = static_cast<int>(std::ceil(std::log2(scale)));
    const std::lock_guard lock(mutex_);
    for (const Prepared& prepared : prepared_) {
      if (prepared.power == power) return prepared.outlines;
    }
    constexpr std::size_t most = 4;
    if (prepared_.size() == most) prepared_.pop_front();
    prepared_.push_back({power, std::make_shared<const Outlines>(drawing_, std::ldexp(tolerance_, -power), blend_)});
    return prepared_.back().outlines;
  }

  struct Prepared {
    int power;  // of 2: no scale above it
    std::shared_ptr<const Outlines> outlines;
  };

  Drawing drawing_;
  moire::Blend blend_;
  double tolerance_;
  mutable std::mutex mutex_;
  mutable std::deque<Prepared> prepared_;  // the latest last
};

}  // namespace

}  // namespace cartoon

MOIRE_SCENE(cartoon, "1.0.0",
            (moire::ScenePlugin{
                .summary = "Layers of flat opaque polygons, from SVG or JSON or built in.",
                .source = "Catmull 1978: cartoon animation",
                .parameters = cartoon::parameters,
                .answers =
                    [](const moire::Settings&) {
                      using enum moire::Questions;
                      return points | lines | polygons;
                    },
                .make = [](const moire::Settings& settings) -> std::unique_ptr<moire::Scene> {
                  return std::make_unique<cartoon::Cartoon>(settings);
                },
            }))
