// Pictures of our own.
#pragma once

#include <moire/settings.h>

#include "primitives.h"

namespace primitives {

// Of the setting `kind`; those that fill the image are made for its size.
Picture built_in(const moire::Settings& settings, const Style& style, moire::ImageSize size);

}  // namespace primitives
