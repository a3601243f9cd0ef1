// One curve of a frame as an area.
#pragma once

#include <optional>
#include <utility>
#include <variant>

#include "exact/curves/annulus.h"
#include "exact/curves/slabs.h"
#include "exact/curves/stroke.h"

namespace area {

class Shape {
 public:
  explicit Shape(const moire::LineCurve& line);
  explicit Shape(const moire::CircleCurve& circle) : areas_(Annulus(circle)) {}

  bool is_empty() const {
    return std::visit([](const auto& shape) { return shape.is_empty(); }, areas_);
  }

  // Calls put(x, y, area) for the pixels of `clip` that it touches, the same to the bit whatever `clip` is.
  template <class Put>
  void areas(const moire::PixelArea& clip, Slabs& slabs, Put put) const {
    std::visit([&](const auto& shape) { of(shape, clip, slabs, put); }, areas_);
  }

  // Calls put(box) for boxes of the grid that together hold all pixels it touches; some may come twice.
  template <class Put>
  void boxes(int grid, const moire::PixelArea& boxes, Put put) const {
    std::visit([&](const auto& shape) { shape.boxes(grid, boxes, put); }, areas_);
  }

  // Makes it the next layer of `slabs`, as pixel (x, y) sees it.
  void cover(int x, int y, std::uint32_t layer, Slabs& slabs) const {
    std::visit([&](const auto& shape) { add(shape, x, y, layer, slabs); }, areas_);
  }

 private:
  // A line between two disks.
  struct Capsule {
    Stroke stroke;
    Annulus disks[2];

    bool is_empty() const { return disks[0].is_empty(); }
    template <class Put>
    void boxes(int grid, const moire::PixelArea& boxes, Put put) const {
      stroke.boxes(grid, boxes, put);
      for (const Annulus& disk : disks) disk.boxes(grid, boxes, put);
    }
  };

  template <class Put>
  static void of(const Stroke& stroke, const moire::PixelArea& clip, Slabs&, Put put) {
    stroke.areas(clip, put);
  }
  template <class Put>
  static void of(const Annulus& annulus, const moire::PixelArea& clip, Slabs&, Put put) {
    annulus.areas(clip, put);
  }
  template <class Put>
  static void of(const Capsule& capsule, const moire::PixelArea& clip, Slabs& slabs, Put put);

  static void add(const Stroke& stroke, int x, int y, std::uint32_t layer, Slabs& slabs);
  static void add(const Annulus& annulus, int x, int y, std::uint32_t layer, Slabs& slabs);
  static void add(const Capsule& capsule, int x, int y, std::uint32_t layer, Slabs& slabs);

  std::variant<Stroke, Annulus, Capsule> areas_;
};

// Where a disk may be, line and disks are one cover of several parts; elsewhere there is the line alone.
template <class Put>
void Shape::of(const Capsule& capsule, const moire::PixelArea& clip, Slabs& slabs, Put put) {
  const moire::PixelArea near[2] = {capsule.disks[0].bounds(clip), capsule.disks[1].bounds(clip)};
  const auto is_near = [&](int k, int x, int y) {
    return x >= near[k].x0 && x < near[k].x0 + near[k].width && y >= near[k].y0 && y < near[k].y0 + near[k].height;
  };
  capsule.stroke.areas(clip, [&](int x, int y, double area) {
    if (!is_near(0, x, y) && !is_near(1, x, y)) put(x, y, area);
  });
  for (int k : {0, 1}) {
    for (int y = near[k].y0; y < near[k].y0 + near[k].height; ++y) {
      for (int x = near[k].x0; x < near[k].x0 + near[k].width; ++x) {
        if (k == 1 && is_near(0, x, y)) continue;
        slabs.clear();
        add(capsule, x, y, 0, slabs);
        const double area = slabs.integrate(1)[0];
        if (area > 0) put(x, y, std::min(area, 1.0));
      }
    }
  }
}

}  // namespace area
