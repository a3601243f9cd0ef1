#include "interleaved.h"

#include <ctime>

#include "run/speed.h"

namespace moire::benchmark {

namespace {

double milliseconds(Clock clock) {
  timespec now{};
  clock_gettime(clock == Clock::thread ? CLOCK_THREAD_CPUTIME_ID : CLOCK_MONOTONIC, &now);
  return 1e3 * static_cast<double>(now.tv_sec) + 1e-6 * static_cast<double>(now.tv_nsec);
}

}  // namespace

double Timing::median() const { return quantile(ms, 0.5); }

std::vector<Timing> interleaved(const std::vector<Work>& works, int rounds, Clock clock) {
  std::vector<Timing> timings(works.size());
  for (const Work& work : works) work.run();
  for (int round = 0; round < rounds; ++round) {
    for (std::size_t turn = 0; turn < works.size(); ++turn) {
      const std::size_t k = (turn + static_cast<std::size_t>(round)) % works.size();
      const double start = milliseconds(clock);
      works[k].run();
      timings[k].ms.push_back(milliseconds(clock) - start);
    }
  }
  return timings;
}

double once(const std::function<void()>& work) {
  const double start = milliseconds(Clock::thread);
  work();
  return milliseconds(Clock::thread) - start;
}

Ratio ratio(const Timing& a, const Timing& b) {
  std::vector<double> ratios;
  for (std::size_t k = 0; k < a.ms.size(); ++k) ratios.push_back(a.ms[k] / b.ms[k]);
  return {quantile(ratios, 0.5), quantile(ratios, 0.25), quantile(ratios, 0.75)};
}

}  // namespace moire::benchmark
