// Reading a pyramid at one level of detail: within a level and between two.
#pragma once

#include <cstring>
#include <limits>

#include <moire/texture.h>

#include "sampling/lookups/base_texels.h"
#include "sampling/lookups/fold.h"

namespace moire {

// Four floats that are computed with together: red, green, blue and nothing.
using Rgb = float __attribute__((vector_size(16)));

// a at 0, b at 1. Equal colours stay themselves, bit for bit.
inline Rgb between(Rgb a, Rgb b, float fraction) { return a + fraction * (b - a); }

// What is read within a level, and of which levels: of the two about the one asked for, or of the nearest.
enum class Within { bilinear, nearest };
enum class Across { two, nearest };

// The levels of a pyramid, of which one or two are read. Places are those of level 0, and become those of a level by
// the true ratio of their sizes.
class PyramidReader {
 public:
  // Requires: `level` in 0 .. the coarsest; `pyramid` outlives the reader.
  PyramidReader(const Pyramid& pyramid, Wrap wrap, double level, Across across = Across::two,
                Within within = Within::bilinear)
      : period_(pyramid.level(0).width, pyramid.level(0).height, wrap), within_(within) {
    const auto fine = static_cast<int>(across == Across::two ? level : level + 0.5);
    fine_ = {&pyramid.level(fine), fine};
    fraction_ = across == Across::two ? static_cast<float>(level - fine) : 0;
    coarse_ = fraction_ > 0 ? Read{&pyramid.level(fine + 1), fine + 1} : fine_;
  }

  // Requires: the place is finite.
  Rgb at(Pair place) const {
    const Pair folded = Fold(place, period_).folded();
    const Rgb fine = read(*fine_.level, folded);
    return fraction_ > 0 ? between(fine, read(*coarse_.level, folded), fraction_) : fine;
  }

  // The texels that at() reads there, with their shares times `share`.
  void name(Pair place, double share, BaseTexels& names) const {
    const Fold fold(place, period_);
    name(fine_, fold, share * (1 - static_cast<double>(fraction_)), names);
    name(coarse_, fold, share * static_cast<double>(fraction_), names);
  }

 private:
  struct Read {
    const Pyramid::Level* level;
    int number;
  };
  // The upper left of four texels, and how far between their middles the place is.
  struct Cell {
    Pair first, fraction;

    Cell(const Pyramid::Level& level, Pair folded) {
      const Pair place = folded * Pair{level.s_scale, level.t_scale} - 0.5;
      first = floor_of(place);
      fraction = place - first;
    }
  };

  static Pair nearest(const Pyramid::Level& level, Pair folded) {
    const Pair texel = floor_of(folded * Pair{level.s_scale, level.t_scale});
    const Pair last{level.width - 1.0, level.height - 1.0};
    return texel < last ? texel : last;
  }

  // `row`: the index of its first texel.
  static Rgb texel(const Pyramid::Level& level, int row, int column) {
    Rgb rgb;
    std::memcpy(&rgb, level.rgba.data() + 4 * (static_cast<std::ptrdiff_t>(row) + column), sizeof rgb);
    return rgb;
  }

  Rgb read(const Pyramid::Level& level, Pair folded) const {
    if (within_ == Within::nearest) {
      const Pair place = nearest(level, folded);
      return texel(level, static_cast<int>(place[1]) * level.width, static_cast<int>(place[0]));
    }
    const Cell cell(level, folded);
    // Across the border lies what the wrap puts there.
    const bool repeats = period_.wrap == Wrap::repeat;
    const int right = level.width - 1, bottom = level.height - 1;
    const auto i = static_cast<int>(cell.first[0]), j = static_cast<int>(cell.first[1]);
    const int left_column = i >= 0 ? i : repeats ? right : 0, right_column = i < right ? i + 1 : repeats ? 0 : right;
    const int upper_row = (j >= 0 ? j : repeats ? bottom : 0) * level.width;
    const int lower_row = (j < bottom ? j + 1 : repeats ? 0 : bottom) * level.width;
    const auto across = static_cast<float>(cell.fraction[0]), down = static_cast<float>(cell.fraction[1]);
    return between(between(texel(level, upper_row, left_column), texel(level, upper_row, right_column), across),
                   between(texel(level, lower_row, left_column), texel(level, lower_row, right_column), across), down);
  }

  void name(const Read& read, const Fold& fold, double share, BaseTexels& names) const {
    if (within_ == Within::nearest) {
      const Pair place = nearest(*read.level, fold.folded());
      names.add(read.number, fold, static_cast<std::int64_t>(place[0]), static_cast<std::int64_t>(place[1]), share);
      return;
    }
    const Cell cell(*read.level, fold.folded());
    const auto i = static_cast<std::int64_t>(cell.first[0]), j = static_cast<std::int64_t>(cell.first[1]);
    const double right = static_cast<float>(cell.fraction[0]), lower = static_cast<float>(cell.fraction[1]);
    names.add(read.number, fold, i, j, share * (1 - right) * (1 - lower));
    names.add(read.number, fold, i + 1, j, share * right * (1 - lower));
    names.add(read.number, fold, i, j + 1, share * (1 - right) * lower);
    names.add(read.number, fold, i + 1, j + 1, share * right * lower);
  }

  Fold::Period period_;
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
