#include "interleaved.h"

#include <chrono>

#include "run/speed.h"

namespace moire::benchmark {

double Timing::median() const { return quantile(ms, 0.5); }

std::vector<Timing> interleaved(const std::vector<Work>& works, int rounds) {
  std::vector<Timing> timings(works.size());
  for (const Work& work : works) work.run();
  for (int round = 0; round < rounds; ++round) {
    for (std::size_t turn = 0; turn < works.size(); ++turn) {
      const std::size_t k = (turn + static_cast<std::size_t>(round)) % works.size();
      const auto start = std::chrono::steady_clock::now();
      works[k].run();
      const std::chrono::duration<double, std::milli> spent = std::chrono::steady_clock::now() - start;
      timings[k].ms.push_back(spent.count());
    }
  }
  return timings;
}

Ratio ratio(const Timing& a, const Timing& b) {
  std::vector<double> ratios;
  for (std::size_t k = 0; k < a.ms.size(); ++k) ratios.push_back(a.ms[k] / b.ms[k]);
  return {quantile(ratios, 0.5), quantile(ratios, 0.25), quantile(ratios, 0.75)};
}

}  // namespace moire::benchmark
