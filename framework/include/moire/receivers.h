// Surfaces that an area light lights and others shadow, for methods that shade them before they are seen.
#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include <moire/geometry.h>
#include <moire/tally.h>
#include <moire/texture.h>

namespace moire {

// Where on which receiver an image point is: (s, t) in [0, 1] x [0, 1] of the parallelogram around the receiver.
struct ReceiverPoint {
  static constexpr std::uint32_t none = std::numeric_limits<std::uint32_t>::max();

  std::uint32_t receiver = none;
  double s = 0, t = 0;
  Hit hit = {};  // where no receiver is seen, this is
};

// Irradiance over the parallelogram around a receiver, in its cells: cell (i, j) lies from (i / columns, j / rows) to
// ((i + 1) / columns, (j + 1) / rows), and is cells[j * columns + i].
struct IrradianceMap {
  int columns = 0, rows = 0;
  std::vector<float> cells;
};

// How a hard shadow enters a map: by the part of each cell that it covers, or by whether it covers the cell's middle.
enum class ShadowEdges { by_area, by_middle };

class Receivers {
 public:
  virtual ~Receivers() = default;
  virtual std::uint32_t count() const = 0;
  // Lengths of the sides of the parallelogram around a receiver along s and t, in the scene's unit.
  struct Extent {
    double s, t;
  };
  virtual Extent extent(std::uint32_t receiver) const = 0;
  // What is seen at each point, and where. Requires: points.size() == out.size().
  virtual void locate(std::span<const SamplePoint> points, std::span<ReceiverPoint> out, Counters& counters) const = 0;
  // The light shrunk to each of these points in turn, with all of its power: adds the mean of the irradiances that
  // they bring to each cell's middle, where no occluder hides them. Safe from many threads, on different maps.
  virtual void add_hard_shadows(std::uint32_t receiver, std::span<const LightPoint> lights, ShadowEdges edges,
                                IrradianceMap& map) const = 0;
  // What is seen of a receiver under this irradiance, ambient light included; `element` is that of the receiver where
  // it is lit.
  virtual Hit shaded(std::uint32_t receiver, double irradiance) const = 0;
};

}  // namespace moire
