// Jittered sampling: a grid whose points are moved within their cells at random, which turns alias into noise.
#include <moire/jitter.h>
#include <moire/plugin.h>
#include <moire/reseed.h>

namespace {

using namespace moire::parameter;

constexpr moire::Parameter parameters[] = {
    integer("n", 4, 1, 256, "points", "points of a grid's side"),
    real("amount", 1, 0, 1, "cells",
         "range of the moves each way; 0: a regular grid, of whose alias any less than 1 "
         "keeps a part"),
    moire::Reseed::parameter,
};

class Jittered final : public moire::PointSampler {
 public:
  explicit Jittered(const moire::Settings& settings)
      : n_(settings.integer("n")), amount_(settings.real("amount")), reseed_(settings) {}

  void points(const moire::Pixel& pixel, moire::Points& out) const override {
    const moire::Pixel key = reseed_.key(pixel);
    for (std::int64_t i = 0; i < n_; ++i) {
      for (std::int64_t j = 0; j < n_; ++j) {
        const auto sample = static_cast<std::uint32_t>(i * n_ + j);
        out.add_moved({moire::jittered(i, n_, 0, 0), moire::jittered(j, n_, 0, 0)},
                      moire::jittered(i, n_, amount_, moire::random(key, sample, 0)),
                      moire::jittered(j, n_, amount_, moire::random(key, sample, 1)));
      }
    }
  }
  bool same_in_every_pixel() const override { return amount_ == 0; }
  std::optional<moire::Spacing> spacing() const override {
    const double apart = 1.0 / static_cast<double>(n_);
    return moire::Spacing{apart, apart};
  }

 private:
  std::int64_t n_;
  double amount_;
  moire::Reseed reseed_;
};

}  // namespace

MOIRE_SAMPLER(jittered, "1.0.0",
              (moire::SamplerPlugin{
                  .summary = "n x n points, each moved at random within its own cell of a grid.",
                  .source = "Cook 1986, doi:10.1145/7529.8927: jitter; Maddock, section 7.2",
                  .parameters = parameters,
                  .claims = {.deterministic = false, .unbiased = true},
                  .make_points = [](const moire::Settings& settings) -> std::unique_ptr<moire::PointSampler> {
                    return std::make_unique<Jittered>(settings);
                  },
              }))
