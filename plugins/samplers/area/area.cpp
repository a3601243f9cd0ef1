// Area sampling: exact visible stretches along image lines, or the exact visible area of polygons, lines and circles.
#include <moire/error.h>
#include <moire/plugin.h>

#include "exact/catmull.h"
#include "exact/curves/curve_areas.h"
#include "exact/disjoint.h"
#include "exact/prepared.h"
#include "exact/sweep.h"
#include "radial.h"
#include "upright.h"

namespace {

using namespace moire::parameter;

constexpr moire::Parameter parameters[] = {
    choice("method", "line", "line exact", "exact along lines, or over the area of all polygons or curves"),
    integer("lines", 1, 1, 256, "lines per pixel", "lines across each pixel; radial lines are at least as dense"),
    choice("layout", "upright", "upright radial",
           "lines along image columns, or through the scene's pole, where they are exact"),
    choice("integrator", "auto", "auto sweep prepared catmull",
           "for method exact: closed forms of lines and circles where the scene has them, else the sweep; a sweep over "
           "rows of polygons; what is visible found once and kept for other frames of the same polygons; the z-list "
           "and recursive clipper of 1978. Of polygons the image is the same"),
    flag("jagged", false, "catmull without its pixel integrator: what is seen at the pixel's middle"),
};

class Area final : public moire::Sampler {
 public:
  explicit Area(const moire::Settings& settings)
      : lines_(static_cast<int>(settings.integer("lines"))),
        exact_(settings.text("method") == "exact"),
        radial_(settings.text("layout") == "radial"),
        jagged_(settings.flag("jagged")),
        integrator_(settings.text("integrator")) {}

  std::unique_ptr<moire::Rendering> begin(const moire::RenderRequest& request) const override {
    if (exact_) return integrated(request);
    if (radial_) return std::make_unique<area::Radial>(request, lines_);
    return std::make_unique<area::Upright>(request, lines_);
  }

 private:
  std::unique_ptr<moire::Rendering> integrated(const moire::RenderRequest& request) const {
    if (integrator_ == "auto" && request.frame.curves()) return std::make_unique<area::CurveAreas>(request.frame);
    if (request.frame.polygons()->disjoint()) return std::make_unique<area::Disjoint>(request.frame);
    if (integrator_ == "catmull") return std::make_unique<area::Catmull>(request, jagged_);
    if (integrator_ == "prepared") return std::make_unique<area::Prepared>(request);
    return std::make_unique<area::Sweep>(request);
  }

  int lines_;
  bool exact_, radial_, jagged_;
  std::string integrator_;
};

}  // namespace

MOIRE_SAMPLER(
    area, "1.0.0",
    (moire::SamplerPlugin{
        .summary = "Exact visible area: of stretches along image lines, or of polygons.",
        .source = "Cohen-Or 1997, section 4.3: AS (upright, one line); radial lines after Wan, Qu, Kaufman 1999; "
                  "Catmull 1978",
        .parameters = parameters,
        .asks =
            [](const moire::Settings& settings) {
              if (settings.text("method") == "exact") return moire::Questions::polygons;
              return settings.text("layout") == "radial" ? moire::Questions::radial_lines : moire::Questions::lines;
            },
        .reference =
            [](moire::Questions answered, int effort, moire::Settings& settings) {
              if ((answered & moire::Questions::polygons) != moire::Questions::none) {
                settings.set("method", std::string("exact"));
                return moire::Trust::exact;
              }
              if ((answered & moire::Questions::lines) == moire::Questions::none) return moire::Trust::none;
              const bool radial = (answered & moire::Questions::radial_lines) != moire::Questions::none;
              settings.set("layout", std::string(radial ? "radial" : "upright"));
              settings.set("lines", std::int64_t{16} * effort);
              return moire::Trust::many_lines;
            },
        .continues =
            [](const moire::Settings& settings) {
              return settings.text("method") == "exact" && settings.text("integrator") == "prepared";
            },
        .make = [](const moire::Settings& settings) -> std::unique_ptr<moire::Sampler> {
          return std::make_unique<Area>(settings);
        },
    }))
