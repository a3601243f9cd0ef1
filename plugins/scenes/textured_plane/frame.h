// The plane in one picture: what points see, places on the texture, exact averages.
#pragma once

#include <memory>
#include <optional>

#include <moire/frame.h>

#include "quadtree.h"
#include "strips.h"
#include "surroundings.h"
#include "texels.h"
#include "view.h"

namespace textured_plane {

class PlaneFrame final : public moire::Frame, private moire::Surface, private moire::Averages {
 public:
  // Requires: `texels` outlives this. Error: as check_reach().
  PlaneFrame(const Camera& camera, const Texels& texels, moire::Color sky, double tolerance);

  moire::ImageSize size() const override { return view_.size(); }
  void trace(std::span<const moire::SamplePoint> points, std::span<moire::Hit> hits,
             moire::Counters& counters) const override;
  const moire::Surface* surface() const override { return this; }
  const moire::Averages* averages() const override { return this; }

 private:
  // Surface.
  void locate(std::span<const moire::SamplePoint> points, std::span<moire::SurfacePoint> out,
              moire::Counters& counters) const override;
  const moire::Texture& texture() const override { return texels_.texture(); }

  // Averages.
  double integrate(const moire::Filter* filter, moire::PixelBlock& block) const override;

  // Calls near(k, u, v, fall) for the points that see the texture and other(k, hit) for the rest, and counts them.
  template <class Near, class Other>
  void look(std::span<const moire::SamplePoint> points, moire::Counters& counters, Near near, Other other) const;

  View view_;
  const Texels& texels_;
  Surroundings surroundings_;
  double tolerance_;
};

}  // namespace textured_plane
