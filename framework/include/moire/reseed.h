// Whether random numbers change from frame to frame: what all samplers that draw some let their users choose.
#pragma once

#include <moire/random.h>
#include <moire/settings.h>

namespace moire {

class Reseed {
 public:
  // A row of the sampler's table.
  static constexpr Parameter parameter = parameter::choice(
      "reseed", "never", "never frame",
      "random numbers stay with their pixel, or are new in every frame, which flickers even where nothing moves");

  explicit Reseed(const Settings& settings) : every_frame_(settings.text(parameter.name) == "frame") {}

  // What to key random numbers by.
  Pixel key(Pixel pixel) const {
    if (!every_frame_) pixel.frame = 0;
    return pixel;
  }

 private:
  bool every_frame_;
};

}  // namespace moire
