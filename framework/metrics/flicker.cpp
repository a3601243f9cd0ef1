// How much pixels change from frame to frame: Cohen-Or 1997, section 7, Table 6.
#include "metrics/flicker.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "metrics/registry.h"

namespace moire {

namespace {

using namespace parameter;

constexpr Parameter parameters[] = {
    choice("of", "column", "column image", "the pixels that are watched: one image column, or all"),
    integer("column", -1, -1, 16383, "", "the column, from 0; -1: the middle one"),
};

constexpr std::string_view share_meaning =
    "share of pixels and pairs of consecutive frames; change: the largest of the channels, in 8-bit sRGB codes";

// Not judged: what moves changes, and the reference does so too.
constexpr Quantity share(std::string_view name, bool is_main = false) {
  return {.name = name, .unit = "", .meaning = share_meaning, .is_judged = false, .is_main = is_main};
}

constexpr Quantity quantities[] = {
    share("flicker.changed_by_0"),
    share("flicker.changed_by_1"),
    share("flicker.changed_by_2"),
    share("flicker.changed_by_3"),
    share("flicker.changed_by_4"),
    share("flicker.changed_by_5"),
    share("flicker.changed_by_6_up", true),
    {.name = "flicker.mean",
     .unit = "codes",
     .meaning = "mean change; the motion itself counts too",
     .is_judged = false},
    {.name = "flicker.excess",
     .unit = "codes",
     .meaning = "mean over pixels and pairs of frames of |dI - dR|, dI the change of the pixel and dR that of the "
                "reference, signed, the largest of the channels: change that the scene does not make",
     .is_main = true},
    {.name = "flicker.excess_unrounded",
     .unit = "codes",
     .meaning =
         "the same from codes that are not rounded to whole ones: without what a screen's rounding adds, even to "
         "an exact picture's slow changes"},
};

constexpr std::size_t shares_apart = 6;  // changes by 0 to 5

}  // namespace

Flicker::Flicker(const Settings& settings, ImageSize image)
    : columns_(settings.text("of") == "image" ? Columns{0, image.width}
                                              : Columns{or_middle(settings.integer("column"), image.width), 1}) {}

void Flicker::see(const FrameView& view) {
  std::vector<Shown> own = shown(view.own), reference = shown(*view.reference);
  for (std::size_t k = 0; k < last_.size(); ++k) {
    int change = 0, excess = 0;
    double unrounded = 0;
    for (std::size_t c = 0; c < 3; ++c) {
      const int own_change = own[k].codes[c] - last_[k].codes[c];
      change = std::max(change, std::abs(own_change));
      excess = std::max(excess, std::abs(own_change - (reference[k].codes[c] - last_reference_[k].codes[c])));
      unrounded = std::max(unrounded, std::abs(own[k].unrounded[c] - last_[k].unrounded[c] -
                                               (reference[k].unrounded[c] - last_reference_[k].unrounded[c])));
    }
    ++histogram_[static_cast<std::size_t>(change)];
    excess_ += static_cast<std::uint64_t>(excess);
    excess_unrounded_ += unrounded;
  }
  last_ = std::move(own);
  last_reference_ = std::move(reference);
}

std::vector<Flicker::Shown> Flicker::shown(const PixelBlock& block) {
  std::vector<Shown> result(block.slots());
  for (std::size_t slot = 0; slot < result.size(); ++slot) {
    const Color color = block.color(slot);
    const float channels[] = {color.r, color.g, color.b};
    for (std::size_t c = 0; c < 3; ++c) {
      has_nan_ = has_nan_ || std::isnan(channels[c]);
      if (std::isnan(channels[c])) continue;
      result[slot].codes[c] = srgb_code(channels[c]);
      result[slot].unrounded[c] = 255 * linear_to_srgb(std::clamp(channels[c], 0.0F, 1.0F));
    }
  }
  return result;
}

std::vector<Measurement> Flicker::finish() const {
  std::uint64_t count = 0, sum = 0;
  for (std::size_t change = 0; change < histogram_.size(); ++change) {
    count += histogram_[change];
    sum += change * histogram_[change];
  }
  // A pixel that is not a number has no code, and what was counted without it is no answer.
  const double all = has_nan_ ? std::nan("") : static_cast<double>(count);
  std::vector<Measurement> result;
  double rest = all;
  for (std::size_t k = 0; k < shares_apart; ++k) {
    result.push_back({quantities[k].name, static_cast<double>(histogram_[k]) / all});
    rest -= static_cast<double>(histogram_[k]);
  }
  result.push_back({"flicker.changed_by_6_up", rest / all});
  result.push_back({"flicker.mean", static_cast<double>(sum) / all});
  result.push_back({"flicker.excess", static_cast<double>(excess_) / all});
  result.push_back({"flicker.excess_unrounded", excess_unrounded_ / all});
  return result;
}

const PassDescription flicker_description{
    .name = "flicker",
    .summary = "How much pixels change from frame to frame, and how much more than the exact sequence does.",
    .source = "Cohen-Or 1997, section 7, Table 6: the histogram; the excess is ours",
    .parameters = parameters,
    .quantities = quantities,
    .problem = [](const Settings& settings, const Extent& extent) -> std::string {
      if (extent.frames < 2) return "compares consecutive frames; give \"frames\" a \"count\" of 2 or more";
      if (settings.text("of") == "column" && settings.integer("column") >= extent.image.width) {
        return fmt::format("watches column {}; the image has columns 0 to {}", settings.integer("column"),
                           extent.image.width - 1);
      }
      return {};
    },
};

std::unique_ptr<TemporalMetric> make_flicker(const Settings& settings, ImageSize image) {
  return std::make_unique<Flicker>(settings, image);
}

}  // namespace moire
