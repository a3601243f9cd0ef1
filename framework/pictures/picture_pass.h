// A picture of how a method samples.
#pragma once

#include <string>

#include "metrics/frame_pass.h"
#include "metrics/picture.h"

namespace moire {

// A finished picture and what it shows, in a sentence or two.
struct Drawing {
  Picture picture;
  std::string caption;
};

class PicturePass : public FramePass {
 public:
  // After the last frame. Error: the picture would be too large.
  virtual Drawing finish() const = 0;
};

}  // namespace moire
