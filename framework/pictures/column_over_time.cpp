// One image column over time: Cohen-Or 1997, section 5, Fig. 14. Smooth along time where a method does not flicker.
#include <fmt/format.h>

#include "pictures/over_time.h"
#include "pictures/registry.h"

namespace moire {

namespace {

using namespace parameter;

constexpr Parameter parameters[] = {
    integer("column", -1, -1, 16383, "", "the image column, from 0; -1: the middle one"),
};

class ColumnOverTime final : public PicturePass {
 public:
  ColumnOverTime(const Settings& settings, const Extent& extent)
      : column_(or_middle(settings.integer("column"), extent.image.width)),
        picture_{{extent.frames, extent.image.height},
                 std::vector<Color>(static_cast<std::size_t>(extent.frames) *
                                    static_cast<std::size_t>(extent.image.height))} {}

  Needs needs() const override { return {.columns = {column_, 1}, .every_frame = true, .of_reference = true}; }

  void see(const FrameView& view) override {
    for (int y = 0; y < picture_.size.height; ++y) {
      picture_.pixels[static_cast<std::size_t>(y) * static_cast<std::size_t>(picture_.size.width) +
                      static_cast<std::size_t>(view.frame)] = view.own.color(view.own.slot(column_, y));
    }
  }

  Drawing finish() const override {
    return {picture_, fmt::format("Column {} over {} frames, time from left to right", column_, picture_.size.width)};
  }

 private:
  int column_;
  Picture picture_;
};

}  // namespace

const PassDescription column_over_time_description{
    .name = "column_over_time",
    .summary = "One image column, frame beside frame.",
    .source = "Cohen-Or 1997, Fig. 14",
    .parameters = parameters,
    .problem = [](const Settings& settings, const Extent& extent) -> std::string {
      const std::string problem = over_time_problem(extent.frames);
      if (!problem.empty()) return problem;
      if (settings.integer("column") < extent.image.width) return {};
      return fmt::format("shows column {}; the image has columns 0 to {}", settings.integer("column"),
                         extent.image.width - 1);
    },
};

std::unique_ptr<PicturePass> make_column_over_time(const Settings& settings, const Extent& extent) {
  return std::make_unique<ColumnOverTime>(settings, extent);
}

}  // namespace moire
