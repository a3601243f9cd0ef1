// The texture: an image in linear light, or the two by two cells of a checkerboard.
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include <moire/settings.h>
#include <moire/texture.h>

#include "blocks.h"
#include "line_sums.h"

namespace textured_plane {

// Immutable. What exact averages need is made when it is first asked for, from whatever thread.
class Texels {
 public:
  // Requires: width * height colours.
  Texels(const std::vector<moire::Color>& colors, int width, int height, moire::Wrap wrap);
  ~Texels();

  int width() const { return texture_.level(0).width; }
  int height() const { return texture_.level(0).height; }
  moire::Wrap wrap() const { return texture_.wrap(); }
  const moire::Texture& texture() const { return texture_; }
  moire::Color mean() const { return mean_; }

  // Of rows (lines run along s) or of columns. Requires: not clamped.
  const LineSums& rows() const;
  const LineSums& columns() const;
  const Blocks& blocks() const;

 private:
  struct Lazy;
  std::vector<float> rgba_;  // four floats a texel, the last one 0
  moire::Texture texture_;
  moire::Color mean_;
  std::unique_ptr<Lazy> lazy_;
};

// Error: the file cannot be read, or has a colour that is not a number.
std::unique_ptr<Texels> load_texels(const moire::Settings& settings);
// Units a texel.
double texel_size(const moire::Settings& settings);

}  // namespace textured_plane
