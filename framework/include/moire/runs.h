// For scenes that find what a line sees as runs along it.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>

#include <moire/frame.h>

namespace moire {

// Deposits runs as Lines::along() asks for them. find(line, begin, end) gives a range of runs from distance `begin` of
// the line to `end`, one after another without gaps, each with a `begin` and an `end`, valid until the next call; with
// begin < end. hit(run): what is seen there. Counts a query a stretch, and its hits that are no background.
template <class Find, class HitOf>
void deposit_runs(std::span<const ImageLine> lines, Tally& pieces, Find find, HitOf hit_of) {
  std::size_t first_slot = 0;
  std::uint64_t queries = 0, hits = 0;
  pieces.fill([&](auto add) {
    for (const ImageLine& line : lines) {
      if (line.stretches() > 0 && line.cuts.front() < line.cuts.back()) {
        const auto runs = find(line, line.cuts.front(), line.cuts.back());
        auto run = runs.begin();
        for (std::size_t i = 0; i < line.stretches(); ++i) {
          const double begin = line.cuts[i], end = line.cuts[i + 1];
          if (!(begin < end)) continue;
          ++queries;
          while (run->end <= begin) ++run;
          for (auto part = run; part != runs.end() && part->begin < end; ++part) {
            const Hit hit = hit_of(*part);
            add(first_slot + i, hit.element, std::min(part->end, end) - std::max(part->begin, begin), hit.color);
            hits += hit.element != background ? 1 : 0;
          }
        }
      }
      first_slot += line.stretches();
    }
  });
  pieces.counters.queries += queries;
  pieces.counters.hits += hits;
}

}  // namespace moire
