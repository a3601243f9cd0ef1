// Reading a pyramid at one level of detail: within a level and between two.
#pragma once

#include <cstring>
#include <limits>

#include <moire/texture.h>

#include "sampling/lookups/base_texels.h"
#include "sampling/lookups/fold.h"
#include "sampling/lookups/interpolation.h"

namespace moire {

// Four floats that are computed with together: red, green, blue and nothing.
using Rgb = float __attribute__((vector_size(16)));

// a at 0, b at 1. Equal colours stay themselves, bit for bit.
inline Rgb between(Rgb a, Rgb b, float fraction) { return a + fraction * (b - a); }

// What is read within a level, and of which levels: of the two about the one asked for, or of the nearest.
enum class Within { bilinear, nearest };
enum class Across { two, nearest };

// The levels of Texture::pyramid(), of which one or two are read. Coordinates are those of level 0, and become those of
// a level by the true ratio of their sizes.
class PyramidReader {
 public:
  // Requires: `level` in 0 .. the coarsest; `pyramid` outlives the reader.
  PyramidReader(const Pyramid& pyramid, Wrap wrap, double level, Across across = Across::two, Within within = Within::bilinear)
      : columns_(pyramid.level(0).width, wrap), rows_(pyramid.level(0).height, wrap), within_(within) {
    const auto fine = static_cast<int>(across == Across::two ? level : level + 0.5);
    fine_ = {&pyramid.level(fine), fine};
    fraction_ = across == Across::two ? static_cast<float>(level - fine) : 0;
    coarse_ = fraction_ > 0 ? Read{&pyramid.level(fine + 1), fine + 1} : fine_;
  }

  // Requires: (s, t) is finite.
  Rgb at(double s, double t) const {
    const double column = Fold(s, columns_).folded(), row = Fold(t, rows_).folded();
    const Rgb fine = read(*fine_.level, column, row);
    return fraction_ > 0 ? between(fine, read(*coarse_.level, column, row), fraction_) : fine;
  }

  // The texels that at() reads there, with their shares times `share`.
  void name(double s, double t, double share, BaseTexels& names) const {
    const Fold column(s, columns_), row(t, rows_);
    name(fine_, column, row, share * (1 - static_cast<double>(fraction_)), names);
    name(coarse_, column, row, share * static_cast<double>(fraction_), names);
  }

 private:
  struct Read {
    const Pyramid::Level* level;
    int number;
  };
  // Two texels that stand side by side as their places go on, and how far between their middles it is.
  struct Pair {
    std::size_t first, second;
    float fraction;
  };

  static Rgb texel(const Pyramid::Level& level, std::size_t row, std::size_t column) {
    Rgb rgb;
    std::memcpy(&rgb, level.rgba.data() + 4 * (row * static_cast<std::size_t>(level.width) + column), sizeof rgb);
    return rgb;
  }

  // Of `size` texels, across the border the texel that the wrap puts there.
  Pair pair(double folded, double scale, int size) const {
    const Between place(folded * scale);
    const std::int64_t last = size - 1;
    const bool repeats = columns_.wrap == Wrap::repeat;
    const std::int64_t before = repeats ? last : 0, behind = repeats ? 0 : last;
    return {static_cast<std::size_t>(place.first < 0 ? before : place.first),
            static_cast<std::size_t>(place.first >= last ? behind : place.first + 1),
            static_cast<float>(place.fraction)};
  }
  static std::int64_t nearest(double folded, double scale, int size) {
    return std::min<std::int64_t>(texel_at(folded * scale), size - 1);
  }

  Rgb read(const Pyramid::Level& level, double s, double t) const {
    if (within_ == Within::nearest) {
      return texel(level, static_cast<std::size_t>(nearest(t, level.t_scale, level.height)),
                   static_cast<std::size_t>(nearest(s, level.s_scale, level.width)));
    }
    const Pair column = pair(s, level.s_scale, level.width), row = pair(t, level.t_scale, level.height);
    return between(
        between(texel(level, row.first, column.first), texel(level, row.first, column.second), column.fraction),
        between(texel(level, row.second, column.first), texel(level, row.second, column.second), column.fraction),
        row.fraction);
  }

  void name(const Read& read, const Fold& s, const Fold& t, double share, BaseTexels& names) const {
    const Pyramid::Level& level = *read.level;
    if (within_ == Within::nearest) {
      names.add(read.number, s, nearest(s.folded(), level.s_scale, level.width), t,
                nearest(t.folded(), level.t_scale, level.height), share);
      return;
    }
    const Between column(s.folded() * level.s_scale), row(t.folded() * level.t_scale);
    const double right = static_cast<float>(column.fraction), lower = static_cast<float>(row.fraction);
    names.add(read.number, s, column.first, t, row.first, share * (1 - right) * (1 - lower));
    names.add(read.number, s, column.first + 1, t, row.first, share * right * (1 - lower));
    names.add(read.number, s, column.first, t, row.first + 1, share * (1 - right) * lower);
    names.add(read.number, s, column.first + 1, t, row.first + 1, share * right * lower);
  }

  Fold::Axis columns_, rows_;
  Read fine_, coarse_;
  float fraction_;
  Within within_;
};

// Deposits what was read around a point; name(names) adds the texels it came from, asked where the tally records.
template <class Name>
void deposit_read(Rgb color, double weight, const Texture& texture, Tally& tally, std::size_t slot, Name&& name) {
  tally.fill([&](auto add) {
    add.sum(slot, {weight, weight * static_cast<double>(color[0]), weight * static_cast<double>(color[1]),
                   weight * static_cast<double>(color[2])});
    if (!tally.recording()) return;
    BaseTexels names(texture);
    name(names);
    names.for_each(
        [&](Element element, double share, Color texel) { add.record(slot, element, weight * share, texel); });
  });
}

// What cannot be looked up, at a place that is none: no number, of what the scene says is there.
inline bool deposit_nowhere(const SurfacePoint& point, double weight, Tally& tally, std::size_t slot) {
  if (std::isfinite(point.s) && std::isfinite(point.t)) return false;
  constexpr float none = std::numeric_limits<float>::quiet_NaN();
  tally.add(slot, point.hit.element, weight, {none, none, none});
  return true;
}

}  // namespace moire
