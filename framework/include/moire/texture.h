// Textures and the lookups that turn a place on one into colour.
#pragma once

#include <algorithm>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include <moire/color.h>
#include <moire/element.h>
#include <moire/pyramid.h>
#include <moire/tally.h>

namespace moire {

// What is seen at a point.
struct Hit {
  Element element = background;
  Color color;
};

// How a texture goes on beyond its border.
enum class Wrap { mirror, repeat, clamp };

// Maps any index to 0 .. size - 1. Requires: size > 0.
constexpr std::int64_t wrapped(std::int64_t index, std::int64_t size, Wrap wrap) {
  if (wrap == Wrap::clamp) return std::clamp<std::int64_t>(index, 0, size - 1);
  const std::int64_t period = wrap == Wrap::mirror ? 2 * size : size;
  index %= period;
  if (index < 0) index += period;
  return index < size ? index : period - 1 - index;
}

class OiioTexture;

// A resident pyramid of texels, level 0 the finest. Texel (i, j) of level l covers [i, i + 1) x [j, j + 1) times
// 2^l in texture coordinates (s, t), whose unit is a texel of level 0. Colours stay with whoever made the texture:
// a level views them with a stride, so that they may lie interleaved with other data.
class Texture {
 public:
  struct Level {
    const float* rgb;    // red of texel (0, 0); green and blue follow
    std::size_t stride;  // floats from one texel to the next
    int width, height;   // texels; rows follow each other
  };

  Texture(std::vector<Level> levels, Wrap wrap);

  int levels() const { return static_cast<int>(levels_.size()); }
  const Level& level(int l) const { return levels_[static_cast<std::size_t>(l)]; }
  Wrap wrap() const { return wrap_; }
  // Of level 0, made when it is first asked for, from whatever thread. Copies share it.
  const Pyramid& pyramid() const;
  // The same in OpenImageIO's hands, likewise. Error: its module cannot be opened.
  const OiioTexture& oiio() const;

  Hit texel(int l, std::int64_t i, std::int64_t j) const {
    const Level& level = levels_[static_cast<std::size_t>(l)];
    const auto row = static_cast<std::size_t>(wrapped(j, level.height, wrap_));
    const auto column = static_cast<std::size_t>(wrapped(i, level.width, wrap_));
    const float* c = level.rgb + (row * static_cast<std::size_t>(level.width) + column) * level.stride;
    return {texel_element(l, i, j), {c[0], c[1], c[2]}};
  }

 private:
  struct Lazy;
  std::vector<Level> levels_;
  Wrap wrap_;
  std::shared_ptr<Lazy> lazy_;
};

// A point seen on a surface, with its place on the texture and how that place moves with the image point.
struct SurfacePoint {
  Hit hit;                                           // what nearest sampling sees
  bool textured = false;                             // false: the rest means nothing, the colour is the hit's
  int level = 0;                                     // the texture level that the scene shows here
  double s = 0, t = 0;                               // texture coordinates, texels of level 0
  float ds_dx = 0, dt_dx = 0, ds_dy = 0, dt_dy = 0;  // per pixel of the image
};

// What a lookup filters a texture over: as much of a pixel as each sample stands for, or always a whole pixel.
enum class Footprint { sample, pixel };

// How a place on a texture becomes fragments: several texels, whose weights sum to `weight`.
class Lookup {
 public:
  // Lookups that a scene may do itself, together with its own work: with the same fragments.
  enum class Kind {
    other,
    linear_across,  // Cohen-Or 1997, eq. 4: two texels, along the axis that moves faster as the image point goes aside
  };
  virtual Kind kind() const { return Kind::other; }
  virtual Footprint footprint() const { return Footprint::sample; }

  virtual ~Lookup() = default;
  virtual void deposit(const SurfacePoint& point, const Texture& texture, double weight, Tally& tally,
                       std::size_t slot) const = 0;
};

}  // namespace moire
