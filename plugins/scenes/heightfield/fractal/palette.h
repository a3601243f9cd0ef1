// Colours named by what they cover, and how to mix them.
#pragma once

#include <moire/color.h>

namespace heightfield {

// A colour as a paint program shows it, 0 .. 255 a channel; linear light by the square, which is close to the sRGB
// curve and has the same bits everywhere.
constexpr moire::Color paint(int r, int g, int b) {
  const auto light = [](int code) { return static_cast<float>(code * code) / 65025.0F; };
  return {light(r), light(g), light(b)};
}

inline moire::Color scaled(moire::Color color, double by) { return static_cast<float>(by) * color; }

inline moire::Color mix(moire::Color from, moire::Color to, double part_of_to) {
  return scaled(from, 1 - part_of_to) + scaled(to, part_of_to);
}

namespace palette {
inline constexpr moire::Color shallow = paint(64, 128, 134), deep = paint(18, 52, 82);
inline constexpr moire::Color sand = paint(212, 192, 148), wet_sand = paint(150, 132, 100);
inline constexpr moire::Color meadow = paint(98, 130, 58), dry_grass = paint(150, 148, 84),
                              alpine = paint(122, 128, 72);
inline constexpr moire::Color fir = paint(36, 66, 40), beech = paint(70, 104, 42), autumn = paint(136, 110, 44);
inline constexpr moire::Color forest_floor = paint(34, 42, 24);
inline constexpr moire::Color granite = paint(142, 138, 132), slate = paint(98, 95, 96), ochre = paint(168, 146, 118);
inline constexpr moire::Color scree = paint(158, 150, 140);
inline constexpr moire::Color snow = paint(244, 248, 254);
inline constexpr moire::Color stream = paint(60, 112, 136);
inline constexpr moire::Color soil = paint(112, 80, 54), furrow = paint(62, 42, 28);
inline constexpr moire::Color wheat = paint(220, 186, 98), stubble = paint(176, 140, 78);
inline constexpr moire::Color rapeseed = paint(232, 210, 50), rapeseed_row = paint(150, 158, 40);
inline constexpr moire::Color crop = paint(86, 140, 48), lavender = paint(128, 96, 168), vine = paint(58, 96, 36);
inline constexpr moire::Color hay = paint(142, 166, 82), mown = paint(98, 140, 60);
inline constexpr moire::Color hedge = paint(42, 74, 32), track = paint(206, 190, 154);
inline constexpr moire::Color road = paint(222, 214, 200), verge = paint(74, 108, 48);
inline constexpr moire::Color roof = paint(196, 88, 54), old_roof = paint(120, 66, 50), yard = paint(178, 168, 140);
}  // namespace palette

}  // namespace heightfield
