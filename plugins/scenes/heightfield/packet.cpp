#include "packet.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "packet_lanes.h"

namespace heightfield {

namespace {

// Places of voxels are counted in 32 bits, and beyond this distance a texel's border can not be told from its inside.
constexpr double farthest = 1 << 22;

// True where linear_across takes neighbours along the axis that the walk does not step along. Decided by rounding
// errors, it is left to the lookup itself.
bool steps_along_other_axis(const Camera& camera, bool swapped) {
  const double s = std::abs(camera.right().x), t = std::abs(camera.right().y);
  if (std::abs(s - t) <= 1e-6 * (s + t)) return false;
  return (s > t) == swapped;
}

}  // namespace

bool packets_fit(const Look& look) {
  const View& view = look.view();
  const Manner& manner = look.manner();
  const double reach = view.far / std::min(view.spacing_x, view.spacing_y);
  return manner.model == Model{.grid = false} && manner.weights == Weights::area && manner.side_by_side &&
         manner.resume && manner.retrace == 0 && view.z > view.voxels->highest() && view.voxels->colors_are_finite() &&
         std::max(std::abs(view.x), std::abs(view.y)) + reach < farthest;
}

void follow_in_packets(const Look& look, moire::Color sky, Interpolation interpolation,
                       std::span<const moire::ImageLine> lines, std::span<const std::size_t> first_slots,
                       moire::Tally& pieces, std::vector<bool>& followed) {
  const moire::ImageLine& first = lines.front();
  if (first.stretches() == 0 || first.from.x != first.to.x || first.to.y >= first.from.y) return;
  const bool gaps =
      std::adjacent_find(first.cuts.begin(), first.cuts.end(), std::greater_equal<>()) != first.cuts.end();
  if (gaps) return;
  const Camera& camera = look.camera();
  const double middle = (first.cuts[0] + first.cuts[1]) / 2;
  const Direction step = look.course_of<Azimuth::pixel>(first.from, first.to).step;

  struct Group {
    Plane octant;
    std::vector<PacketLine> lines;
  };
  std::vector<Group> groups;
  for (std::size_t k = 0; k < lines.size(); ++k) {
    const auto& [from, to, cuts] = lines[k];
    if (from.x != to.x || from.y != first.from.y || to.y != first.to.y || cuts.data() != first.cuts.data() ||
        cuts.size() != first.cuts.size()) {
      continue;
    }
    const Look::Course course = look.course_of<Azimuth::pixel>(from, to);
    if (course.turning > cuts.front() && course.turning < cuts.back()) continue;
    const Plane plane = course.in_one_plane ? course.near_side : plane_of(course.start + middle * step);
    if (interpolation == Interpolation::linear_across && !steps_along_other_axis(camera, plane.swapped)) continue;
    auto group =
        std::find_if(groups.begin(), groups.end(), [&](const Group& g) { return g.octant.same_octant(plane); });
    if (group == groups.end()) group = groups.insert(group, {plane, {}});
    group->lines.push_back({k, first_slots[k], course.start, course.ahead, course.in_one_plane});
  }
  for (Group& group : groups) {
    follow({look.view(), group.octant, step, first.cuts, sky, interpolation}, group.lines, pieces);
    for (const PacketLine& line : group.lines) followed[line.index] = line.fits;
  }
}

}  // namespace heightfield
