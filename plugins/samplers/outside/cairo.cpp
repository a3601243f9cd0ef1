// An outside mark: what Cairo paints.
#include <moire/plugin.h>

#include "cairo_canvas.h"
#include "painter.h"

MOIRE_SAMPLER(
    cairo, "1.0.0",
    (moire::SamplerPlugin{
        .summary = "Cairo's own picture, for comparison: layer over layer, 8 bits, numbers blended as stored.",
        .source = "cairographics.org",
        .asks = [](const moire::Settings&) { return moire::Questions::polygons; },
        .is_optional = true,
        .make = [](const moire::Settings&) -> std::unique_ptr<moire::Sampler> {
          return std::make_unique<outside::Painter>(outside::cairo_canvas);
        },
    }))
