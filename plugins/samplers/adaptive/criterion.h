// Whether samples differ so much that more are taken between them.
#pragma once

#include <algorithm>

#include <moire/element.h>
#include <moire/settings.h>
#include <moire/tally.h>

namespace adaptive {

// What was seen at one point.
struct Sample {
  moire::Color color;
  moire::Element element = moire::background;
};

// How far samples differ.
class Range {
 public:
  void add(const Sample& sample) {
    if (is_empty_) {
      low_ = high_ = sample.color;
      element_ = sample.element;
      is_empty_ = false;
      return;
    }
    has_elements_ = has_elements_ || sample.element != element_;
    low_ = {std::min(low_.r, sample.color.r), std::min(low_.g, sample.color.g), std::min(low_.b, sample.color.b)};
    high_ = {std::max(high_.r, sample.color.r), std::max(high_.g, sample.color.g), std::max(high_.b, sample.color.b)};
  }

  moire::Color low() const { return low_; }
  moire::Color high() const { return high_; }
  bool has_elements() const { return has_elements_; }  // more than one

 private:
  bool is_empty_ = true, has_elements_ = false;
  moire::Element element_ = moire::background;
  moire::Color low_, high_;
};

class Criterion {
 public:
  static constexpr moire::Parameter parameters[] = {
      moire::parameter::choice(
          "criterion", "either", "color element either",
          "refined is what differs in colour, in elements or in one of them; equal colours of "
          "different elements hide edges from the first, textures spend all samples on the second"),
      moire::parameter::real("threshold", 8, 0, 255, "levels of 255",
                             "colours differ where a channel does by more, in sRGB"),
  };

  Criterion(const moire::Settings& settings, moire::Blend blend);

  bool fires(const Range& range) const {
    return (elements_ && range.has_elements()) ||
           (colors_ && range.low() != range.high() && differ(range.low(), range.high()));
  }

 private:
  bool differ(moire::Color low, moire::Color high) const;

  bool colors_, elements_;
  double threshold_;  // of 0..1
  moire::Blend blend_;
};

}  // namespace adaptive
