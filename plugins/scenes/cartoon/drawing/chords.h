// Chords of curves.
//
// Between two points of a curve P(t), h apart in t, the chord is nowhere farther from the curve than h^2 / 8 times the
// largest |P''| (the error of linear interpolation). So a curve over [0, 1] takes ceil(sqrt(max |P''| / (8 tolerance)))
// chords of equal h. |P''| is, at most,
//   quadratic: 2 |p0 - 2 p1 + p2|, everywhere the same;
//   cubic:     6 max(|p0 - 2 p1 + p2|, |p1 - 2 p2 + p3|), as it is linear between its ends;
//   arc:       (b - a)^2 times the larger of the ellipse's half axes.
#pragma once

#include <cstddef>

#include "drawing.h"

namespace cartoon {

// How many chords the part of an outline takes that begins at `from`. Requires: verb is no move.
double chords_of(Verb verb, moire::Point from, const moire::Point* p, double tolerance);

// Calls put(point) for the end of each of `count` chords, the curve's own end last. A curve and the same one drawn
// backward give the same points to the bit.
template <class Put>
void put_chords(Verb verb, moire::Point from, const moire::Point* p, std::size_t count, Put put);

// The point of a curve at k of n parts of its way.
moire::Point point_at(Verb verb, moire::Point from, const moire::Point* p, std::size_t k, std::size_t n);

template <class Put>
void put_chords(Verb verb, moire::Point from, const moire::Point* p, std::size_t count, Put put) {
  for (std::size_t k = 1; k < count; ++k) put(point_at(verb, from, p, k, count));
  put(p[points_of(verb) - 1]);
}

}  // namespace cartoon
