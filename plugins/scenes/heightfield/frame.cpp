#include "frame.h"

#include <type_traits>
#include <vector>

#include "packet.h"

namespace heightfield {

namespace {

// Calls work(constant) with the walk chosen once, outside the loops.
template <class Work>
void with_walk(bool grid, Work work) {
  if (grid) {
    work(std::true_type{});
  } else {
    work(std::false_type{});
  }
}

// Fewer lines than these are followed as fast one by one.
constexpr std::size_t fewest_in_packets = 3;

}  // namespace

void HeightfieldFrame::trace(std::span<const moire::SamplePoint> points, std::span<moire::Hit> hits,
                             moire::Counters& counters) const {
  with_walk(look_.manner().grid, [&](auto grid) {
    look_.rays<grid()>(
        points, counters,
        [&](std::size_t k, const auto& walk, const Voxel& voxel, const Direction&, double) {
          hits[k] = {walk.element(voxel), color_of(*voxel.cell)};
        },
        [&](std::size_t k) {
          hits[k] = {moire::background, sky_};
        });
  });
}

void HeightfieldFrame::along(std::span<const moire::ImageLine> lines, const moire::Lookup* lookup,
                             moire::Tally& pieces) const {
  std::vector<std::size_t> first_slots;
  std::size_t slots = 0;
  for (const moire::ImageLine& line : lines) {
    first_slots.push_back(slots);
    slots += line.stretches();
  }

  std::vector<bool> followed(lines.size());
  const bool known = !lookup || lookup->kind() == moire::Lookup::Kind::linear_across;
  if (lines.size() >= fewest_in_packets && known && !pieces.recording() && packets_fit(look_)) {
    const Interpolation interpolation = lookup ? Interpolation::linear_across : Interpolation::nearest;
    follow_in_packets(look_, sky_, interpolation, lines, first_slots, pieces, followed);
  }
  for (std::size_t k = 0; k < lines.size(); ++k) {
    if (!followed[k]) follow(lines[k], first_slots[k], lookup, pieces);
  }
}

void HeightfieldFrame::follow(const moire::ImageLine& line, std::size_t first_slot, const moire::Lookup* lookup,
                              moire::Tally& pieces) const {
  with_walk(look_.manner().grid, [&](auto grid) {
    if (lookup) {
      look_.stretches<grid()>(
          line, first_slot, pieces.counters,
          [&](std::size_t slot, double weight, const auto& walk, const Voxel* voxel, const Direction& d,
              moire::Tally::Sum&) {
            if (!voxel) return pieces.add(slot, moire::background, weight, sky_);
            const double middle = (voxel->x0 + voxel->x1) / 2;
            lookup->deposit(look_.surface_point(walk, *voxel, middle, d), texture_, weight, pieces, slot);
          },
          [](std::size_t, const moire::Tally::Sum&) {});
      return;
    }
    pieces.fill([&](auto add) {
      look_.stretches<grid()>(
          line, first_slot, pieces.counters,
          [&](std::size_t slot, double weight, const auto& walk, const Voxel* voxel, const Direction&,
              moire::Tally::Sum& sum) {
            const moire::Color color = voxel ? color_of(*voxel->cell) : sky_;
            sum.add(weight, color);
            add.record(slot, voxel ? walk.element(*voxel) : moire::background, weight, color);
          },
          [&](std::size_t slot, const moire::Tally::Sum& sum) { add.sum(slot, sum); });
    });
  });
}

void HeightfieldFrame::locate(std::span<const moire::SamplePoint> points, std::span<moire::SurfacePoint> out,
                              moire::Counters& counters) const {
  with_walk(look_.manner().grid, [&](auto grid) {
    look_.rays<grid()>(
        points, counters,
        [&](std::size_t k, const auto& walk, const Voxel& voxel, const Direction& direction, double slope) {
          const double x = look_.meeting(voxel, slope);
          out[k] = look_.surface_point(walk, voxel, x, direction);
        },
        [&](std::size_t k) {
          out[k] = {.hit = {moire::background, sky_}};
        });
  });
}

}  // namespace heightfield
