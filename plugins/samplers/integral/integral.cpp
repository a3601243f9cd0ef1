// The scene's own exact averages over pixels, under any filter that it knows them for.
#include <atomic>

#include <moire/plugin.h>

namespace {

class Integrated final : public moire::Rendering {
 public:
  explicit Integrated(const moire::RenderRequest& request)
      : averages_(*request.frame.averages()), filter_(request.filter) {}

  void render(moire::PixelBlock& block) const override {
    const double bound = averages_.integrate(filter_, block);
    // The largest of all blocks, in whatever order they come.
    double largest = bound_.load(std::memory_order_relaxed);
    while (bound > largest && !bound_.compare_exchange_weak(largest, bound, std::memory_order_relaxed)) {
    }
  }
  moire::Blocks blocks() const override { return averages_.blocks(); }
  double error_bound() const override { return bound_.load(std::memory_order_relaxed); }

 private:
  const moire::Averages& averages_;
  const moire::Filter* filter_;
  mutable std::atomic<double> bound_ = 0;
};

class Integral final : public moire::Sampler {
 public:
  std::unique_ptr<moire::Rendering> begin(const moire::RenderRequest& request) const override {
    return std::make_unique<Integrated>(request);
  }
};

}  // namespace

MOIRE_SAMPLER(integral, "1.0.0",
              (moire::SamplerPlugin{
                  .summary = "Exact averages over pixels, where the scene has closed forms or bounded quadratures.",
                  .source = "the scene's own: see its description",
                  .asks = [](const moire::Settings&) { return moire::Questions::averages; },
                  .claims = {.exact = true},
                  .reference =
                      [](moire::Questions answered, int, moire::Settings&) {
                        return (answered & moire::Questions::averages) != moire::Questions::none ? moire::Trust::exact
                                                                                                 : moire::Trust::none;
                      },
                  .takes_filters = true,
                  .make = [](const moire::Settings&) -> std::unique_ptr<moire::Sampler> {
                    return std::make_unique<Integral>();
                  },
              }))
