// A metric of an animation.
#pragma once

#include <vector>

#include "metrics/frame_pass.h"
#include "metrics/metric.h"

namespace moire {

class TemporalMetric : public FramePass {
 public:
  // After the last frame.
  virtual std::vector<Measurement> finish() const = 0;
};

}  // namespace moire
