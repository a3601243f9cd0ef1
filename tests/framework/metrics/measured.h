// The numbers of a pass by name.
#pragma once

#include <map>
#include <string>

#include "metrics/metric.h"

namespace moire::test {

inline std::map<std::string, double> measured(Metric& metric, const Picture& picture, const Picture& reference,
                                              const Counters& counters = {}) {
  std::map<std::string, double> values;
  for (const Measurement& m : metric.finish({picture, reference, counters})) values[std::string(m.quantity)] = m.value;
  return values;
}

}  // namespace moire::test
