// Area sampling on image lines: each line's visible stretches are found exactly and weighed by the area they stand for.
#include <moire/error.h>
#include <moire/plugin.h>

#include "exact/disjoint.h"
#include "radial.h"
#include "upright.h"

namespace {

using namespace moire::parameter;

constexpr moire::Parameter parameters[] = {
    choice("method", "line", "line exact", "how a pixel's area is covered: exactly along lines, or as a whole"),
    integer("lines", 1, 1, 256, "lines per pixel", "lines across each pixel; radial lines are at least as dense"),
    choice("layout", "upright", "upright radial",
           "lines along image columns, or through the scene's pole, where they are exact"),
};

class Area final : public moire::Sampler {
 public:
  explicit Area(const moire::Settings& settings)
      : exact_(settings.text("method") == "exact"),
        lines_(static_cast<int>(settings.integer("lines"))),
        radial_(settings.text("layout") == "radial") {}

  std::unique_ptr<moire::Rendering> begin(const moire::RenderRequest& request) const override {
    if (exact_) return integrated(request.frame);
    if (radial_) return std::make_unique<area::Radial>(request, lines_);
    return std::make_unique<area::Upright>(request, lines_);
  }

 private:
  static std::unique_ptr<moire::Rendering> integrated(const moire::Frame& frame) {
    if (!frame.polygons()->disjoint()) {
      throw moire::Error("area: the scene's polygons overlap; method exact takes those that do not");
    }
    return std::make_unique<area::Disjoint>(frame);
  }

  bool exact_;
  int lines_;
  bool radial_;
};

}  // namespace

MOIRE_SAMPLER(
    area, "1.0.0",
    (moire::SamplerPlugin{
        .summary = "Exact visible stretches along image lines, weighed by area.",
        .source = "Cohen-Or 1997, section 4.3: AS (upright, one line); radial lines after Wan, Qu, Kaufman 1999",
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
        .make = [](const moire::Settings& settings) -> std::unique_ptr<moire::Sampler> {
          return std::make_unique<Area>(settings);
        },
    }))
