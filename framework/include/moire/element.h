// Elements: the smallest things of a scene that have an identity of their own.
#pragma once

#include <cstdint>

namespace moire {

using Element = std::uint64_t;

// What no element covers, such as the sky.
inline constexpr Element background = 0;

// The element of texel (i, j) of a pyramid's `level` (0 is the finest). i and j are not wrapped: a mirrored or
// repeated copy is another element. Requires: level in 0..62, i and j in -2^28 .. 2^28 - 1. Never `background`.
constexpr Element texel_element(int level, std::int64_t i, std::int64_t j) {
  constexpr std::uint64_t mask = (std::uint64_t{1} << 29) - 1;
  return static_cast<Element>(level + 1) << 58 | (static_cast<std::uint64_t>(i) & mask) << 29 |
         (static_cast<std::uint64_t>(j) & mask);
}

struct TexelIndex {
  int level;
  std::int64_t i, j;
};

// The inverse of texel_element.
constexpr TexelIndex texel_index(Element element) {
  constexpr auto signed_29 = [](std::uint64_t bits) { return static_cast<std::int64_t>(bits << 35) >> 35; };
  return {static_cast<int>(element >> 58) - 1, signed_29(element >> 29), signed_29(element)};
}

}  // namespace moire
