// Soft shadows as averages of hard ones, kept in a texture for each receiver.
#include <moire/plugin.h>

#include "light_points.h"
#include "radiance_textures.h"

namespace {

using namespace moire::parameter;

constexpr moire::Parameter parameters[] = {
    integer("n", 16, 1, 256, "points", "root of the number of hard shadows: n x n points of the light"),
    choice("pattern", "lattice", soft_shadows::patterns,
           "of the points of the light, the same for all texels: a regular grid bands where an occluder's edge is "
           "parallel to the light's"),
    integer("texels", 512, 1, 8192, "texels", "of each texture, along the longer side of the receiver"),
    choice("edges", "by_area", "by_area by_middle",
           "a hard shadow darkens a texel by the part it covers, or if it covers its middle"),
    choice("interpolation", "bilinear", "bilinear nearest", "how textures are looked up"),
    integer("pixel_points", 1, 1, 64, "points", "a side of the grid of points at which each pixel looks them up"),
};

class Textured final : public moire::Rendering {
 public:
  Textured(const moire::RenderRequest& request, std::vector<moire::LightPoint> lights, int texels,
           moire::ShadowEdges edges, soft_shadows::Interpolation interpolation, int pixel_points)
      : receivers_(*request.frame.receivers()),
        textures_(receivers_, std::move(lights), texels, edges),
        interpolation_(interpolation),
        side_(pixel_points) {}

  void render(moire::PixelBlock& block) const override {
    const auto each = static_cast<std::size_t>(side_) * static_cast<std::size_t>(side_);
    std::vector<moire::SamplePoint> points;
    std::vector<moire::ReceiverPoint> places(each * static_cast<std::size_t>(block.height));
    for (int x = block.x0; x < block.x0 + block.width; ++x) {
      points.clear();
      for (int y = block.y0; y < block.y0 + block.height; ++y) {
        for (int k = 0; k < side_ * side_; ++k) points.push_back({x + inside(k % side_), y + inside(k / side_)});
      }
      receivers_.locate(points, places, block.counters);
      const double weight = 1 / static_cast<double>(each);
      block.fill([&](auto add) {
        for (std::size_t k = 0; k < places.size(); ++k) {
          const moire::Hit hit = seen(places[k]);
          add(block.slot(x, block.y0 + static_cast<int>(k / each)), hit.element, weight, hit.color);
        }
      });
    }
  }

 private:
  double inside(int k) const { return (k + 0.5) / side_; }
  moire::Hit seen(const moire::ReceiverPoint& place) const {
    if (place.receiver == moire::ReceiverPoint::none) return place.hit;
    return receivers_.shaded(place.receiver, textures_.irradiance(place, interpolation_));
  }

  const moire::Receivers& receivers_;
  soft_shadows::RadianceTextures textures_;
  soft_shadows::Interpolation interpolation_;
  int side_;
};

class HeckbertHerf final : public moire::Sampler {
 public:
  explicit HeckbertHerf(const moire::Settings& settings)
      : n_(static_cast<std::uint32_t>(settings.integer("n"))),
        pattern_(soft_shadows::pattern_of(settings.text("pattern"))),
        texels_(static_cast<int>(settings.integer("texels"))),
        edges_(settings.text("edges") == "by_area" ? moire::ShadowEdges::by_area : moire::ShadowEdges::by_middle),
        interpolation_(settings.text("interpolation") == "nearest" ? soft_shadows::Interpolation::nearest
                                                                   : soft_shadows::Interpolation::bilinear),
        pixel_points_(static_cast<int>(settings.integer("pixel_points"))) {}

  std::unique_ptr<moire::Rendering> begin(const moire::RenderRequest& request) const override {
    const moire::Pixel key{.seed = request.seed};
    return std::make_unique<Textured>(request, soft_shadows::light_points(pattern_, n_, key), texels_, edges_,
                                      interpolation_, pixel_points_);
  }

 private:
  std::uint32_t n_;
  soft_shadows::Pattern pattern_;
  int texels_;
  moire::ShadowEdges edges_;
  soft_shadows::Interpolation interpolation_;
  int pixel_points_;
};

}  // namespace

MOIRE_SAMPLER(heckbert_herf, "1.0.0",
              (moire::SamplerPlugin{
                  .summary = "Averages of hard shadows, made once into a texture for each receiver.",
                  .source = "Heckbert, Herf 1997, CMU-CS-97-104; Jang 1997, \"Shadows\"",
                  .parameters = parameters,
                  .asks = [](const moire::Settings&) { return moire::Questions::receivers; },
                  .claims = {.deterministic = false},
                  .make = [](const moire::Settings& settings) -> std::unique_ptr<moire::Sampler> {
                    return std::make_unique<HeckbertHerf>(settings);
                  },
              }))
