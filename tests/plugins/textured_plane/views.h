// Small textures and the views of them that leave nothing out.
#pragma once

#include <vector>

#include "textured_plane/texels.h"
#include "textured_plane/view.h"

namespace moire::test {

using textured_plane::Camera;
using textured_plane::Texels;

// Colours at random, always the same.
Texels random_texels(int width, int height, Wrap wrap);

// Without roll, along the texture's axes: pitches from straight down to upward, the horizon in the picture, above and
// below it, magnified and minified, far limits within the picture and out of it.
std::vector<Camera> aligned_views();

// The same with roll, and with yaws off the axes.
std::vector<Camera> turned_views();

}  // namespace moire::test
