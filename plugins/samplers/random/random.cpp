// Random sampling: points anywhere in the pixel, none knowing of the others. The yardstick of all that is stratified.
#include <moire/plugin.h>
#include <moire/reseed.h>

namespace {

using namespace moire::parameter;

constexpr moire::Parameter parameters[] = {
    integer("points", 16, 1, 65536, "points", "points of a pixel"),
    moire::Reseed::parameter,
};

class Random final : public moire::PointSampler {
 public:
  explicit Random(const moire::Settings& settings)
      : count_(static_cast<std::uint32_t>(settings.integer("points"))), reseed_(settings) {}

  void points(const moire::Pixel& pixel, moire::Points& out) const override {
    const moire::Pixel key = reseed_.key(pixel);
    for (std::uint32_t k = 0; k < count_; ++k) out.add(moire::random(key, k, 0), moire::random(key, k, 1));
  }

 private:
  std::uint32_t count_;
  moire::Reseed reseed_;
};

}  // namespace

MOIRE_SAMPLER(random, "1.0.0",
              (moire::SamplerPlugin{
                  .summary = "Points anywhere in each pixel, independent of one another.",
                  .source = "Metropolis, Ulam 1949, doi:10.1080/01621459.1949.10483310: the Monte Carlo method",
                  .parameters = parameters,
                  .claims = {.deterministic = false, .unbiased = true},
                  .make_points = [](const moire::Settings& settings) -> std::unique_ptr<moire::PointSampler> {
                    return std::make_unique<Random>(settings);
                  },
              }))
