// What one pixel is made of: its fragments from bottom to top in the order of deposit, each as high as its weight; at
// one instant, or over time. Cohen-Or 1997, sections 4.1 and 5, Fig. 13.
#include <algorithm>

#include <fmt/format.h>

#include "pictures/over_time.h"
#include "pictures/registry.h"

namespace moire {

namespace {

using namespace parameter;

constexpr int side = 200;  // of the enlarged pixel, in pixels of the picture

constexpr Parameter parameters[] = {
    integer("x", -1, -1, 16383, "", "the pixel's column, from 0; -1: the middle one"),
    integer("y", -1, -1, 16383, "", "the pixel's row, from 0 at the top; -1: the middle one"),
    choice("over", "still", "still time", "one frame, or a strip for each of them from left to right"),
};

class EnlargedPixel final : public PicturePass {
 public:
  EnlargedPixel(const Settings& settings, const Extent& extent)
      : x_(or_middle(settings.integer("x"), extent.image.width)),
        y_(or_middle(settings.integer("y"), extent.image.height)),
        over_time_(settings.text("over") == "time"),
        picture_{{over_time_ ? extent.frames : side, side}, {}} {
    picture_.pixels.resize(static_cast<std::size_t>(picture_.size.width) * side);
  }

  Needs needs() const override { return {.columns = {x_, 1}, .every_frame = over_time_, .fragments = true}; }

  void see(const FrameView& view) override {
    const std::size_t slot = view.own.slot(x_, y_);
    double sum = 0;
    view.own.for_each(slot, [&](const Fragment& f) { sum += f.weight; });
    double reached = 0;
    int row = 0;  // from the bottom
    fragments_ = 0;
    view.own.for_each(slot, [&](const Fragment& f) {
      ++fragments_;
      reached += f.weight;
      for (; row < side && (row + 0.5) * sum < reached * side; ++row) fill(view.frame, row, view.own.light(f.color));
    });
  }

  Drawing finish() const override {
    const std::string pixel = fmt::format("Pixel ({}, {})", x_, y_);
    return {picture_, over_time_ ? fmt::format("{} over {} frames, time from left to right", pixel, picture_.size.width)
                                 : fmt::format("{}: {} fragment{}", pixel, fragments_, fragments_ == 1 ? "" : "s")};
  }

 private:
  void fill(int frame, int row, Color color) {
    const auto begin = static_cast<std::size_t>(side - 1 - row) * static_cast<std::size_t>(picture_.size.width);
    if (over_time_) {
      picture_.pixels[begin + static_cast<std::size_t>(frame)] = color;
    } else {
      std::fill_n(picture_.pixels.begin() + static_cast<std::ptrdiff_t>(begin), side, color);
    }
  }

  int x_, y_;
  bool over_time_;
  Picture picture_;
  std::size_t fragments_ = 0;
};

}  // namespace

const PassDescription enlarged_pixel_description{
    .name = "enlarged_pixel",
    .summary = "The fragments of one pixel, bottom to top, each as high as its weight; also over time.",
    .source = "Cohen-Or 1997, Fig. 13",
    .parameters = parameters,
    .problem = [](const Settings& settings, const Extent& extent) -> std::string {
      const auto [width, height] = extent.image;
      if (settings.integer("x") >= width || settings.integer("y") >= height) {
        return fmt::format("shows pixel ({}, {}); the image has columns 0 to {} and rows 0 to {}",
                           or_middle(settings.integer("x"), width), or_middle(settings.integer("y"), height), width - 1,
                           height - 1);
      }
      return settings.text("over") == "time" ? over_time_problem(extent.frames) : "";
    },
};

std::unique_ptr<PicturePass> make_enlarged_pixel(const Settings& settings, const Extent& extent) {
  return std::make_unique<EnlargedPixel>(settings, extent);
}

}  // namespace moire
