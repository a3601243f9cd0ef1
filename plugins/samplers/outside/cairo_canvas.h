// A canvas that Cairo paints.
#pragma once

#include <memory>

#include "canvas.h"
#include "painted_layers.h"

namespace outside {

std::unique_ptr<Canvas> cairo_canvas(const Painting& painting);

}  // namespace outside
