// Passes over chosen columns of an animation's frames: what metrics over time and pictures are made from. They see one
// frame at a time and keep only what they need of it.
#pragma once

#include "metrics/merged.h"

namespace moire {

// Image columns x0 .. x0 + width - 1.
struct Columns {
  int x0 = 0, width = 0;
  friend bool operator==(const Columns&, const Columns&) = default;
};

// What a pass is to be shown.
struct Needs {
  Columns columns;
  bool every_frame = false;  // else the still only
  bool fragments = false;
  bool reference = false;     // the reference's colours
  bool exact = false;         // the exact fragments of the frame as the contender sees it
  bool of_reference = false;  // the pass is run on the reference too, as if it were a contender, without fragments
};

// One frame, as far as it was asked for. All blocks are of the same columns.
struct FrameView {
  int frame;
  const PixelBlock& own;
  const PixelBlock* reference;
  const MergedBlock* exact;
};

class FramePass {
 public:
  virtual ~FramePass() = default;
  virtual Needs needs() const = 0;
  // Called for one frame after another, in their order.
  virtual void see(const FrameView& view) = 0;
};

// The column or row meant by a setting, of `size` in all; -1 stands for the middle one.
constexpr int or_middle(std::int64_t setting, int size) { return setting < 0 ? size / 2 : static_cast<int>(setting); }

}  // namespace moire
