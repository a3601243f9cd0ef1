// The sum of all light of a picture, frame by frame.
#pragma once

#include <vector>

#include "metrics/temporal_metric.h"

namespace moire {

class Energy final : public TemporalMetric {
 public:
  explicit Energy(ImageSize image) : columns_{0, image.width} {}

  Needs needs() const override {
    return {.columns = columns_, .every_frame = true, .reference = true, .of_reference = true};
  }
  void see(const FrameView& view) override;
  std::vector<Measurement> finish() const override;

 private:
  Columns columns_;
  std::vector<double> own_, reference_;  // mean light of each frame
};

}  // namespace moire
