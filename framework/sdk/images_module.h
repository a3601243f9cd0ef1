// The module that knows OpenImageIO, opened when it is first needed. OpenImageIO brings some 260 libraries, half a
// second of every start, so that nothing else may link it.
#pragma once

#include "images/images.h"
#include "images/oiio_texture.h"

namespace moire {

struct ImagesModule {
  ReadImage* read;
  WriteImage* write;
  MakeOiioTexture* make_texture;
};

// Opened once, by whichever thread comes first, and never closed. Error: it is not there or cannot be opened.
const ImagesModule& images_module();

}  // namespace moire
