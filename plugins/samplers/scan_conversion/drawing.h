// The curves of a frame, kept for its blocks.
#pragma once

#include <vector>

#include <moire/frame.h>

#include "pixels.h"

namespace scan_conversion {

// A line, or a circle.
struct Stroke {
  moire::Element element;
  moire::Color color;
  bool is_circle;
  moire::Point from, to;  // of a line
  moire::Point center;    // of a circle
  double radius;
};

class Drawing {
 public:
  explicit Drawing(const moire::Curves& curves);

  // From back to front, without those that no pixel can show.
  const std::vector<Stroke>& strokes() const { return strokes_; }
  moire::Color background() const { return background_; }

  // Calls visit(index) for the strokes that may light pixels of the area, from back to front.
  template <class Visit>
  void for_each_near(const moire::PixelArea& area, Visit visit) const {
    const auto right = static_cast<float>(area.x0 + area.width), lower = static_cast<float>(area.y0 + area.height);
    const auto left = static_cast<float>(area.x0), upper = static_cast<float>(area.y0);
    for (std::size_t k = 0; k < boxes_.size(); ++k) {
      const Box& box = boxes_[k];
      if (box.x0 < right && box.x1 > left && box.y0 < lower && box.y1 > upper) visit(static_cast<std::uint32_t>(k));
    }
  }

 private:
  struct Box {
    float x0, y0, x1, y1;
  };

  std::vector<Stroke> strokes_;
  std::vector<Box> boxes_;
  moire::Color background_;
};

}  // namespace scan_conversion
