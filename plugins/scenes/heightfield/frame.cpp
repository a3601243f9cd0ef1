#include "frame.h"

#include <type_traits>
#include <vector>

#include "packet.h"

namespace heightfield {

namespace {

template <class Work>
void with_constant(bool value, Work work) {
  if (value) {
    work(std::true_type{});
  } else {
    work(std::false_type{});
  }
}

// Calls work(constant) with the model chosen once, outside the loops.
template <class Work>
void with_model(const Model& model, Work work) {
  with_constant(model.grid, [&](auto grid) {
    with_constant(model.azimuth == Azimuth::column, [&](auto column) {
      with_constant(model.face == Face::near, [&](auto near) {
        work(std::integral_constant<Model, Model{.grid = grid(),
                                                 .azimuth = column() ? Azimuth::column : Azimuth::pixel,
                                                 .face = near() ? Face::near : Face::box}>{});
      });
    });
  });
}

// The distance that stands for what is seen of a voxel: that of its top's middle, or of its wall.
template <Face face>
double middle_of(const Voxel& voxel) {
  return face == Face::box ? (voxel.x0 + voxel.x1) / 2 : voxel.x0;
}
// Fewer lines than these are followed as fast one by one.
constexpr std::size_t fewest_in_packets = 3;

}  // namespace

void HeightfieldFrame::trace(std::span<const moire::SamplePoint> points, std::span<moire::Hit> hits,
                             moire::Counters& counters) const {
  with_model(look_.manner().model, [&](auto model) {
    look_.rays<model()>(
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
  if (look_.manner().weights == Weights::height) return follow_by_height(line, first_slot, lookup, pieces);
  with_model(look_.manner().model, [&](auto model) {
    if (lookup) {
      look_.stretches<model()>(
          line, first_slot, pieces.counters,
          [&](std::size_t slot, Run run, const auto& walk, const Voxel* voxel, const Direction& d, moire::Tally::Sum&) {
            if (!voxel) return pieces.add(slot, moire::background, run.length, sky_);
            const double x = middle_of<model().face>(*voxel);
            lookup->deposit(look_.surface_point<model().face>(walk, *voxel, x, d), texture_, run.length, pieces, slot);
          },
          [](std::size_t, const moire::Tally::Sum&) {});
      return;
    }
    pieces.fill([&](auto add) {
      look_.stretches<model()>(
          line, first_slot, pieces.counters,
          [&](std::size_t slot, Run run, const auto& walk, const Voxel* voxel, const Direction&,
              moire::Tally::Sum& sum) {
            const moire::Color color = voxel ? color_of(*voxel->cell) : sky_;
            sum.add(run.length, color);
            add.record(slot, voxel ? walk.element(*voxel) : moire::background, run.length, color);
          },
          [&](std::size_t slot, const moire::Tally::Sum& sum) { add.sum(slot, sum); });
    });
  });
}

void HeightfieldFrame::follow_by_height(const moire::ImageLine& line, std::size_t first_slot,
                                        const moire::Lookup* lookup, moire::Tally& pieces) const {
  struct Seen {
    Run run;
    moire::SurfacePoint point;
  };
  std::vector<Seen> seen;  // of the terrain, in one stretch
  double length = 0, rise = 0, sky = 0;
  with_model(look_.manner().model, [&](auto model) {
    look_.stretches<model(), Weights::height>(
        line, first_slot, pieces.counters,
        [&](std::size_t, Run run, const auto& walk, const Voxel* voxel, const Direction& d, moire::Tally::Sum&) {
          if (!voxel) {
            sky += run.length;
            return;
          }
          seen.push_back({run, look_.surface_point<model().face>(walk, *voxel, middle_of<model().face>(*voxel), d)});
          length += run.length;
          rise += run.rise;
        },
        [&](std::size_t slot, const moire::Tally::Sum&) {
          for (const Seen& part : seen) {
            // Nothing rises where the eye is within the ground: there one voxel is all that is seen.
            const double weight = rise > 0 ? part.run.rise / rise * length : part.run.length;
            if (!(weight > 0)) continue;
            if (lookup) {
              lookup->deposit(part.point, texture_, weight, pieces, slot);
            } else {
              pieces.add(slot, part.point.hit.element, weight, part.point.hit.color);
            }
          }
          if (sky > 0) pieces.add(slot, moire::background, sky, sky_);
          seen.clear();
          length = rise = sky = 0;
        });
  });
}

void HeightfieldFrame::locate(std::span<const moire::SamplePoint> points, std::span<moire::SurfacePoint> out,
                              moire::Counters& counters) const {
  with_model(look_.manner().model, [&](auto model) {
    look_.rays<model()>(
        points, counters,
        [&](std::size_t k, const auto& walk, const Voxel& voxel, const Direction& direction, double slope) {
          const double x = look_.meeting<model().face>(voxel, slope);
          out[k] = look_.surface_point<model().face>(walk, voxel, x, direction);
        },
        [&](std::size_t k) {
          out[k] = {.hit = {moire::background, sky_}};
        });
  });
}

}  // namespace heightfield
