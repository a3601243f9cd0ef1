// The visible runs of an image line, held to single rays of the brute force.
#pragma once

#include <algorithm>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "plugins/heightfield/brute_force.h"

namespace moire::test {

inline constexpr double nearby = 1e-6;  // pixels

// The runs of one stretch, from its begin to its end in the order in which they lie there.
struct Run {
  Element element;
  double begin, end;  // pixels from the line's begin
};

// What the scene deposits for one line, in its own colours.
inline void follow(const Frame& frame, const ImageLine& line, Tally& pieces) {
  frame.lines()->along({&line, 1}, nullptr, pieces);
}

inline std::vector<Run> runs_of(const Tally& pieces, std::size_t slot, double begin, double end, bool rises) {
  std::vector<Run> runs;
  double at = rises ? begin : end;
  pieces.for_each(slot, [&](const Fragment& f) {
    const double next = rises ? at + f.weight : at - f.weight;
    runs.push_back({f.element, std::min(at, next), std::max(at, next)});
    at = next;
  });
  return runs;
}

// Where along the line a run's content can be asked for: just inside its ends, and in its middle.
inline std::vector<double> probes(const Run& run) {
  const double length = run.end - run.begin;
  if (length < 4 * nearby) return {};
  return {run.begin + nearby, (run.begin + run.end) / 2, run.end - nearby};
}

inline bool contains(const std::vector<Element>& elements, Element element) {
  return std::find(elements.begin(), elements.end(), element) != elements.end();
}

struct Verdict {
  std::string first_wrong;
  int runs = 0;
};

// Judges runs by rays: ray_at(place) is the ray of a place on the line.
template <class RayAt>
void judge(const Map& map, const View& view, const std::vector<Run>& runs, RayAt ray_at, Verdict& verdict,
           SeenBy* seen_by_ray = seen_by) {
  for (const Run& run : runs) {
    ++verdict.runs;
    for (const double place : probes(run)) {
      const std::vector<Element> seen = seen_by_ray(map, view, ray_at(place));
      if (contains(seen, run.element) || !verdict.first_wrong.empty()) continue;
      verdict.first_wrong = fmt::format("element {:x} from {} to {}; a ray at {} sees {:x}", run.element, run.begin,
                                        run.end, place, seen.front());
    }
  }
}

}  // namespace moire::test
