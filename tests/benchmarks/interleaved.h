// Timing of pieces of work against each other: in turn, in one process, compared round by round.
#pragma once

#include <functional>
#include <string>
#include <vector>

namespace moire::benchmark {

// One piece of work and what it is called.
struct Work {
  std::string name;
  std::function<void()> run;
};

struct Timing {
  std::vector<double> ms;  // of every round
  double median() const;
};

// What is counted: the time of the calling thread alone, or the time that passes.
enum class Clock { thread, wall };

// A warm-up, then `rounds` rounds in which every piece runs once; who begins changes from round to round.
std::vector<Timing> interleaved(const std::vector<Work>& works, int rounds, Clock clock = Clock::thread);

// Milliseconds of the calling thread, for work too long to be run again.
double once(const std::function<void()>& work);

// The median over rounds of a's time over b's, and the quartiles of that ratio.
struct Ratio {
  double median, low, high;
};
Ratio ratio(const Timing& a, const Timing& b);

}  // namespace moire::benchmark
