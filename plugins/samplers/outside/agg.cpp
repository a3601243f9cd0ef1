// An outside mark: what the Anti-Grain Geometry (AGG) paints.
#include <moire/plugin.h>

#include "agg_canvas.h"
#include "painter.h"

MOIRE_SAMPLER(agg, "1.0.0",
              (moire::SamplerPlugin{
                  .summary = "AGG's own picture, for comparison: layer over layer, 8 bits, numbers blended as stored.",
                  .source = "Anti-Grain Geometry 2.6, scanline_u8",
                  .asks = [](const moire::Settings&) { return moire::Questions::polygons; },
                  .is_optional = true,
                  .make = [](const moire::Settings&) -> std::unique_ptr<moire::Sampler> {
                    return std::make_unique<outside::Painter>(outside::agg_canvas);
                  },
              }))
