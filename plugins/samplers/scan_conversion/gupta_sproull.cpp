// Lines and circles under a cone of radius 1 pixel, by tables of distances.
#include <moire/plugin.h>

#include "circles/gupta_sproull.h"
#include "lines/gupta_sproull.h"
#include "scan_converter.h"

namespace {

class ConePixels {
 public:
  struct Choices {};

  // Tables are made with the first frame, not with its first pixels.
  ConePixels(const Choices&, const scan_conversion::Drawing&) { scan_conversion::Cone::tables(); }

  std::uint32_t full() const { return scan_conversion::Cone::full; }
  template <class Put>
  void draw(const scan_conversion::Stroke& stroke, const moire::PixelArea& area, Put put) const {
    if (stroke.is_circle) return gupta_sproull_circle(rounded_circle(stroke), area, put);
    gupta_sproull_line(scan_conversion::pixel_of(stroke.from), scan_conversion::pixel_of(stroke.to), area, put);
  }
};

}  // namespace

MOIRE_SAMPLER(
    gupta_sproull, "1.0.0",
    (moire::SamplerPlugin{
        .summary = "Lines and circles of width 1 under a cone of radius 1 pixel, three pixels a column by tables; end "
                   "points, centres and radii rounded, widths and caps ignored.",
        .source = "Gupta, Sproull 1981, doi:10.1145/800224.806783, with tables computed from the cone's integrals",
        .asks = [](const moire::Settings&) { return moire::Questions::curves; },
        .make = [](const moire::Settings&) -> std::unique_ptr<moire::Sampler> {
          using Converter = scan_conversion::ScanConverter<ConePixels>;
          return std::make_unique<Converter>(Converter::Choices{});
        },
    }))
