// How much pixels change from frame to frame.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include <moire/settings.h>

#include "metrics/temporal_metric.h"

namespace moire {

class Flicker final : public TemporalMetric {
 public:
  Flicker(const Settings& settings, ImageSize image);

  Needs needs() const override {
    return {.columns = columns_, .every_frame = true, .reference = true, .of_reference = true};
  }
  void see(const FrameView& view) override;
  std::vector<Measurement> finish() const override;

 private:
  // A pixel on an 8-bit sRGB screen.
  struct Shown {
    std::array<int, 3> codes;
    std::array<double, 3> unrounded;
  };
  std::vector<Shown> shown(const PixelBlock& block);

  Columns columns_;
  std::vector<Shown> last_, last_reference_;
  std::array<std::uint64_t, 256> histogram_{};
  std::uint64_t excess_ = 0;
  double excess_unrounded_ = 0;
  bool has_nan_ = false;  // in a pixel of the contender or of the reference
};

}  // namespace moire
