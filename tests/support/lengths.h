// What whole lines see, by element.
#pragma once

#include <map>
#include <span>
#include <vector>

#include <catch2/catch_test_macros.hpp>

#include <moire/frame.h>

namespace moire::test {

using Lengths = std::vector<std::map<Element, double>>;  // of each stretch

inline Lengths along(const Frame& frame, const ImageLine& line, Counters* counters = nullptr) {
  Tally pieces(line.stretches(), true);
  frame.lines()->along(std::span(&line, 1), nullptr, pieces);
  Lengths lengths(line.stretches());
  for (std::size_t i = 0; i < line.stretches(); ++i) {
    pieces.for_each(i, [&](const Fragment& f) {
      CHECK(f.weight > 0);
      lengths[i][f.element] += f.weight;
    });
  }
  if (counters) *counters = pieces.counters;
  return lengths;
}

}  // namespace moire::test
