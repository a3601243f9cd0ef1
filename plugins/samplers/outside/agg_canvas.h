// A canvas that the Anti-Grain Geometry paints.
#pragma once

#include <memory>

#include "canvas.h"
#include "painted_layers.h"

namespace outside {

std::unique_ptr<Canvas> agg_canvas(const Painting& painting);

}  // namespace outside
