// Wu's two-point scheme: two pixels around the curve in every column or row, each by how near it is.
#include <moire/plugin.h>

#include <map>

#include "circles/two_point.h"
#include "lines/real_ends.h"
#include "scan_converter.h"

namespace {

using namespace moire::parameter;
using namespace scan_conversion;

constexpr moire::Parameter parameters[] = {
    choice("method", "accumulator", "accumulator direct fujimoto_iwata",
           "of lines: Wu's integer that overflows; (rise i) / columns by a division of doubles in every column; each "
           "pixel from its own distance, as Fujimoto and Iwata. Between rounded end points the pixels are the same"),
    integer("bits", 32, 8, 64, "bits",
            "of the accumulator, n: lines drawn from both ends are exact to sqrt(2^(n - m + 1)) columns, m the "
            "grey_bits, from one end to sqrt(2^(n - m)); lines too long for 32 get 64 if the step is the ceiling"),
    integer("grey_bits", 8, 1, 16, "bits", "intensities are of 2^m - 1: m bits of the fraction, and their inverse"),
    choice("step", "ceiling", "ceiling rounded",
           "the accumulator's increment of slope k: ceil(k 2^n), or as published floor(k 2^n + 1/2), with which some "
           "pixels are one level or more off whatever n is"),
    choice("ends", "integer", "integer real",
           "end points, centres and radii: in the middles of pixels, as published; or where they are, with columns at "
           "a line's ends by the part covered, and lines drawn from one end, circles by roots"),
    choice("drawn", "both_ends", "both_ends one_end",
           "of lines with rounded ends: halves towards the middle, as published, so that the second one is that of the "
           "reversed line, which may differ by a level; or all columns seen from the first end"),
    choice("circles", "direct", "direct table wide_table",
           "with rounded ends: by a root in each row; or the published table of D, with m bits, at least 8, and a rule "
           "for equal values, or with 16 bits and none; tables to a radius of 65,535"),
};

// Radii with a table of their own; larger ones get roots.
constexpr std::int64_t largest_table = 65535;

struct Choices {
  TwoPointLines lines;
  bool real_ends = false;
  std::string circles;

  explicit Choices(const moire::Settings& settings)
      : real_ends(settings.text("ends") == "real"), circles(settings.text("circles")) {
    const std::string& method = settings.text("method");
    lines.method = method == "direct"           ? LineMethod::direct
                   : method == "fujimoto_iwata" ? LineMethod::fujimoto_iwata
                                                : LineMethod::accumulator;
    lines.bits = static_cast<int>(settings.integer("bits"));
    lines.grey_bits = static_cast<int>(settings.integer("grey_bits"));
    lines.ceiling = settings.text("step") == "ceiling";
    lines.both_ends = settings.text("drawn") == "both_ends";
  }
};

class TwoPoints {
 public:
  using Choices = ::Choices;

  TwoPoints(const Choices& choices, const Drawing& drawing) : choices_(choices) {
    if (choices_.real_ends || choices_.circles == "direct") return;
    const int bits = choices_.circles == "wide_table" ? 16 : std::max(choices_.lines.grey_bits, 8);
    for (const Stroke& stroke : drawing.strokes()) {
      if (!stroke.is_circle) continue;
      const std::int64_t radius = rounded_circle(stroke).radius;
      if (radius >= smallest_octants && radius <= largest_table) tables_.try_emplace(radius, radius, bits);
    }
  }

  std::uint32_t full() const { return choices_.lines.full(); }
  template <class Put>
  void draw(const Stroke& stroke, const moire::PixelArea& area, Put put) const {
    if (stroke.is_circle) {
      choices_.real_ends ? draw_real_circle(stroke, area, put) : draw_circle(rounded_circle(stroke), area, put);
    } else if (choices_.real_ends) {
      two_point_line(choices_.lines, stroke.from, stroke.to, area, put);
    } else {
      two_point_line(choices_.lines, pixel_of(stroke.from), pixel_of(stroke.to), area, put);
    }
  }

 private:
  template <class Put>
  void draw_circle(const PixelCircle& circle, const moire::PixelArea& area, Put& put) const {
    const auto [x, y] = circle.center;
    if (circle.radius == 0) return two_point_line(choices_.lines, circle.center, circle.center, area, put);
    if (circle.radius < smallest_octants) {
      const moire::Point middle{static_cast<double>(x) + 0.5, static_cast<double>(y) + 0.5};
      return small_circle(middle, static_cast<double>(circle.radius), full(), area, put);
    }
    const int bits = choices_.lines.grey_bits;
    const auto table = tables_.find(circle.radius);
    if (table == tables_.end()) return two_point_circle(circle, RootBand(circle.radius, bits), full(), area, put);
    if (choices_.circles == "table")
      return two_point_circle(circle, TableBand<true>(table->second, bits), full(), area, put);
    two_point_circle(circle, TableBand<false>(table->second, bits), full(), area, put);
  }
  template <class Put>
  void draw_real_circle(const Stroke& circle, const moire::PixelArea& area, Put& put) const {
    if (circle.radius < smallest_octants) return small_circle(circle.center, circle.radius, full(), area, put);
    two_point_circle(circle.center, circle.radius, choices_.lines.grey_bits, area, put);
  }

  Choices choices_;
  std::map<std::int64_t, RootTable> tables_;
};

}  // namespace

MOIRE_SAMPLER(two_point, "1.0.0",
              (moire::SamplerPlugin{
                  .summary = "Lines and circles one pixel wide, two pixels a column by how near they are; widths and "
                             "caps ignored, radii below 3 by area.",
                  .source = "Wu 1991, doi:10.1145/122718.122734, and Fujimoto, Iwata 1983, after Jang 1997, with its "
                            "slips mended",
                  .parameters = parameters,
                  .asks = [](const moire::Settings&) { return moire::Questions::curves; },
                  .make = [](const moire::Settings& settings) -> std::unique_ptr<moire::Sampler> {
                    return std::make_unique<ScanConverter<TwoPoints>>(Choices(settings));
                  },
              }))
