// Where a run puts what it finds, as it finds it.
#pragma once

#include <string>

#include "metrics/metric.h"
#include "metrics/picture.h"
#include "run/results.h"

namespace moire {

class Sink {
 public:
  virtual ~Sink() = default;
  // A contender's image, or the reference's (sampler: reference_folder). Returns its PNG below the result folder.
  virtual std::filesystem::path picture(const std::string& scene, const std::string& sampler,
                                        const Picture& picture) = 0;
  virtual std::filesystem::path map(const std::string& scene, const std::string& sampler, ImageSize size,
                                    const Map& map) = 0;
  // A picture of how a method samples, of a kind such as "footprint".
  virtual std::filesystem::path drawing(const std::string& scene, const std::string& sampler, const std::string& kind,
                                        const Picture& picture) = 0;
  // All that is known so far; called after every job.
  virtual void save(const Results& results) = 0;
};

inline constexpr const char* reference_folder = "(reference)";

}  // namespace moire
