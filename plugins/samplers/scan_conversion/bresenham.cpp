// Bresenham's lines and circles: the nearest pixels, lit or not.
#include <moire/plugin.h>

#include "circles/midpoint.h"
#include "lines/bresenham.h"
#include "scan_converter.h"

namespace {

class NearestPixels {
 public:
  struct Choices {};

  NearestPixels(const Choices&, const scan_conversion::Drawing&) {}

  std::uint32_t full() const { return 1; }
  template <class Put>
  void draw(const scan_conversion::Stroke& stroke, const moire::PixelArea& area, Put put) const {
    if (stroke.is_circle) return midpoint_circle(rounded_circle(stroke), area, put);
    bresenham_line(scan_conversion::pixel_of(stroke.from), scan_conversion::pixel_of(stroke.to), area, put);
  }
};

}  // namespace

MOIRE_SAMPLER(bresenham, "1.0.0",
              (moire::SamplerPlugin{
                  .summary = "Lines and circles one pixel wide, the nearest pixels of each; end points, centres and "
                             "radii rounded, widths and caps ignored.",
                  .source = "Bresenham 1965, doi:10.1147/sj.41.0025; Bresenham 1977, doi:10.1145/359423.359432",
                  .asks = [](const moire::Settings&) { return moire::Questions::curves; },
                  .make = [](const moire::Settings&) -> std::unique_ptr<moire::Sampler> {
                    using Converter = scan_conversion::ScanConverter<NearestPixels>;
                    return std::make_unique<Converter>(Converter::Choices{});
                  },
              }))
