#include "seeing/lit_receivers.h"

#include <algorithm>
#include <limits>

#include "hard/clip_to.h"
#include "hard/kernel.h"
#include "hard/shadow_raster.h"

namespace shadow_planes {

LitReceivers::LitReceivers(const World& world, const Occluders& occluders, const Shading& shading,
                           const FirstFaces& faces, Shade shade)
    : world_(world),
      occluders_(occluders),
      shading_(shading),
      faces_(faces),
      shade_(shade),
      receiver_of_(world.faces.size(), moire::ReceiverPoint::none) {
  for (std::uint32_t k = 0; k < world.faces.size(); ++k) {
    const Plane& side = shading.receiver(k).side;
    const bool is_lit = std::any_of(world.light.parts.begin(), world.light.parts.end(), [&](const Convex& part) {
      return std::any_of(part.begin(), part.end(), [&](const Vector& p) {
        return occluders.faces(side, {p.x, p.y, p.z, 1});
      });
    });
    if (!is_lit || world.faces[k].parts.empty()) continue;
    receiver_of_[k] = count();
    frames_.push_back(around(k, world));
  }
}

LitReceivers::RectangleAround LitReceivers::around(std::uint32_t face, const World& world) {
  const Face& f = world.faces[face];
  Vector longest;
  for (const Convex& part : f.parts) {
    for (std::size_t k = 0; k < part.size(); ++k) {
      const Vector edge = part[(k + 1) % part.size()] - part[k];
      if (dot(edge, edge) > dot(longest, longest)) longest = edge;
    }
  }
  const Vector along = (1 / length(longest)) * longest, down = cross(f.plane.normal, along);
  constexpr double infinity = std::numeric_limits<double>::infinity();
  double left = infinity, right = -infinity, top = infinity, bottom = -infinity;
  const Vector origin = f.parts[0][0];
  for (const Convex& part : f.parts) {
    for (const Vector& p : part) {
      const double x = dot(along, p - origin), y = dot(down, p - origin);
      left = std::min(left, x), right = std::max(right, x);
      top = std::min(top, y), bottom = std::max(bottom, y);
    }
  }
  return {face, origin + left * along + top * down, along, down, right - left, bottom - top};
}

void LitReceivers::locate(std::span<const moire::SamplePoint> points, std::span<moire::ReceiverPoint> out,
                          moire::Counters& counters) const {
  counters.queries += points.size();
  faces_.look(
      points,
      [&](std::size_t k, std::uint32_t face, const Vector& p) {
        ++counters.hits;
        out[k] = {};
        out[k].receiver = receiver_of_[face];
        if (out[k].receiver == moire::ReceiverPoint::none) {
          out[k].hit = {unlit(face), shading_.color(face, 0)};
          return;
        }
        const RectangleAround& frame = frames_[out[k].receiver];
        out[k].s = std::clamp(dot(frame.along, p - frame.corner) / frame.width, 0.0, 1.0);
        out[k].t = std::clamp(dot(frame.down, p - frame.corner) / frame.height, 0.0, 1.0);
      },
      [&](std::size_t k) {
        out[k] = {};
        out[k].hit = {moire::background, world_.sky};
      });
}

moire::Hit LitReceivers::shaded(std::uint32_t receiver, double irradiance) const {
  const std::uint32_t face = frames_[receiver].face;
  return {lit(face), shading_.color(face, irradiance)};
}

// Some light points at work on one map: row by row all of them, so that a row is read and written once.
class LitReceivers::Batch {
 public:
  Batch(const LitReceivers& receivers, const RectangleAround& frame, moire::ShadowEdges edges,
        const moire::IrradianceMap& map, std::size_t most)
      : receivers_(receivers),
        frame_(frame),
        receiver_(receivers.shading_.receiver(frame.face)),
        columns_(map.columns),
        rows_(map.rows),
        project_(Clip::both),
        whole_{{0, 0}, {0.0 + columns_, 0}, {0.0 + columns_, 0.0 + rows_}, {0, 0.0 + rows_}},
        lights_(most, Lit{{}, ShadowRaster(columns_, rows_, edges)}) {}

  void begin() { count_ = 0; }
  // Requires: the light falls on the receiver's side.
  void add(const Homogeneous& light) {
    Lit& lit = lights_[count_++];
    const Vector from_corner = Vector{light.x, light.y, light.z} - frame_.corner;
    lit.place = {dot(frame_.along, from_corner), dot(frame_.down, from_corner), receiver_.side.of(light)};
    lit.shadows.clear();
    for (const std::uint32_t by : receiver_.occluders) {
      if (receivers_.occluders_.is_edge_on(by, light)) continue;
      for (const Convex& occluder : receivers_.occluders_.parts(by)) add_shadow(occluder, light, lit.shadows);
    }
    lit.shadows.sort();
  }

  // `weight`: of each light point.
  void add_to(moire::IrradianceMap& map, double weight) {
    for (int j = 0; j < rows_; ++j) {
      float* const cells = map.cells.data() + static_cast<std::size_t>(j) * static_cast<std::size_t>(columns_);
      for (std::size_t k = 0; k < count_; ++k) add_row(lights_[k], j, weight, cells);
    }
  }

 private:
  struct Lit {
    Vector place;  // along the row, down, above the plane
    ShadowRaster shadows;
  };

  void add_shadow(const Convex& occluder, const Homogeneous& light, ShadowRaster& shadows) {
    seen_.clear();
    for (const Homogeneous& p : project_(occluder, receiver_.side, light)) {
      const Vector from_corner = Vector{p.x, p.y, p.z} - p.w * frame_.corner;
      seen_.push_back({dot(frame_.along, from_corner) * (columns_ / frame_.width),
                       dot(frame_.down, from_corner) * (rows_ / frame_.height), p.w});
    }
    shadow_ = clip_to_(seen_, whole_);
    if (shadow_.size() < 3) return;
    if (doubled_area(shadow_) < 0) std::reverse(shadow_.begin(), shadow_.end());
    shadows.add(shadow_);
  }

  void add_row(Lit& lit, int j, double weight, float* cells) {
    const Vector& normal = receivers_.world_.light.plane.normal;
    const double step = frame_.width / columns_;
    const double x0 = 0.5 * step - lit.place.x, y = (j + 0.5) * (frame_.height / rows_) - lit.place.y;
    const double above = lit.place.z;
    // With Shade::flat only its sign counts.
    const double power = weight * receivers_.shading_.light().area() * above;
    const double sent = power * (dot(normal, frame_.down) * y - above * dot(normal, receiver_.side.normal));
    const KernelRow row{static_cast<float>(x0), static_cast<float>(step), static_cast<float>(above * above + y * y),
                        static_cast<float>(sent), static_cast<float>(power * dot(normal, frame_.along))};
    if (receivers_.shade_ == Shade::flat) {
      lit.shadows.row(j, [&](int begin, int end, double part) {
        add_flat(row, begin, end, static_cast<float>(weight * part), cells);
      });
    } else {
      lit.shadows.row(
          j, [&](int begin, int end, double part) { add_kernel(row, begin, end, static_cast<float>(part), cells); });
    }
  }

  const LitReceivers& receivers_;
  const RectangleAround& frame_;
  const Receiver& receiver_;
  int columns_, rows_;
  ShadowProjector project_;
  ClipTo clip_to_;
  Outline whole_, shadow_;
  std::vector<moire::Pole> seen_;
  std::vector<Lit> lights_;
  std::size_t count_ = 0;
};

void LitReceivers::add_hard_shadows(std::uint32_t receiver, std::span<const moire::LightPoint> lights,
                                    moire::ShadowEdges edges, moire::IrradianceMap& map) const {
  constexpr std::size_t most = 32;
  const RectangleAround& frame = frames_[receiver];
  Batch batch(*this, frame, edges, map, std::min(most, lights.size()));
  for (std::size_t first = 0; first < lights.size(); first += most) {
    batch.begin();
    for (const moire::LightPoint& p : lights.subspan(first, std::min(most, lights.size() - first))) {
      const Homogeneous light = shading_.light().at(static_cast<double>(p.u), static_cast<double>(p.v));
      if (occluders_.faces(shading_.receiver(frame.face).side, light)) batch.add(light);
    }
    batch.add_to(map, 1 / static_cast<double>(lights.size()));
  }
}

}  // namespace shadow_planes
