// A scene without fault, of the name that a sampler has too.
#include <moire/plugin.h>

namespace {

class Nothing final : public moire::Frame {
 public:
  explicit Nothing(moire::ImageSize size) : size_(size) {}
  moire::ImageSize size() const override { return size_; }
  void trace(std::span<const moire::SamplePoint> points, std::span<moire::Hit> hits,
             moire::Counters& counters) const override {
    std::fill(hits.begin(), hits.end(), moire::Hit{});
    counters.queries += points.size();
  }

 private:
  moire::ImageSize size_;
};

class Empty final : public moire::Scene {
 public:
  std::unique_ptr<moire::Frame> frame(const moire::Settings&, moire::ImageSize size) const override {
    return std::make_unique<Nothing>(size);
  }
};

}  // namespace

MOIRE_SCENE(good, "0.1.0",
            (moire::ScenePlugin{
                .summary = "A scene without fault.",
                .source = "None",
                .make = [](const moire::Settings&) -> std::unique_ptr<moire::Scene> {
                  return std::make_unique<Empty>();
                },
            }))
