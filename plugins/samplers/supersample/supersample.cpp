// Regular supersampling: SS_n of Cohen-Or 1997 (n points above one another), or an n x n grid.
//
// The paper spaces the n rays of a pixel by equal heights above the voxel that the first one hits, and lets them keep
// its slope; here they are equally spaced in the image, each with its own slope.
#include <algorithm>

#include <moire/plugin.h>

namespace {

using namespace moire::parameter;

constexpr moire::Parameter parameters[] = {
    integer("n", 4, 1, 256, "points", "points of a column, or of a grid's side"),
    choice("layout", "column", "column grid", "n points above one another, or n x n"),
    choice("rays", "centre", "centre lower_edge", "a point lies in the middle of its row, or on its lower edge"),
};

class Supersample final : public moire::PointSampler {
 public:
  explicit Supersample(const moire::Settings& settings)
      : rows_(settings.integer("n")),
        columns_(settings.text("layout") == "grid" ? rows_ : 1),
        down_(settings.text("rays") == "centre" ? 0.5 : 1) {}

  // Each point stands for a cell of equal size and lies in its middle, or in that of its lower edge.
  void points(const moire::Pixel&, moire::Points& out) const override {
    for (std::int64_t i = 0; i < columns_; ++i) {
      for (std::int64_t j = 0; j < rows_; ++j) {
        out.add((static_cast<double>(i) + 0.5) / static_cast<double>(columns_),
                std::min((static_cast<double>(j) + down_) / static_cast<double>(rows_), moire::lower_edge));
      }
    }
  }
  bool same_in_every_pixel() const override { return true; }
  std::optional<moire::Spacing> spacing() const override {
    return moire::Spacing{1.0 / static_cast<double>(columns_), 1.0 / static_cast<double>(rows_)};
  }

 private:
  std::int64_t rows_, columns_;
  double down_;  // of a cell, from its upper edge
};

}  // namespace

MOIRE_SAMPLER(supersample, "1.0.0",
              (moire::SamplerPlugin{
                  .summary = "n points above one another in each pixel, or n x n, equally weighted.",
                  .source = "Cohen-Or 1997, section 4.2: SS_n",
                  .parameters = parameters,
                  .reference =
                      [](moire::Questions, int effort, moire::Settings& settings) {
                        settings.set("layout", std::string("grid"));
                        settings.set("n", std::int64_t{16} * effort);
                        return moire::Trust::many_points;
                      },
                  .make_points = [](const moire::Settings& settings) -> std::unique_ptr<moire::PointSampler> {
                    return std::make_unique<Supersample>(settings);
                  },
              }))
