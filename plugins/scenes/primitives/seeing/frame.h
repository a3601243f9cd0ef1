// Curves in one image: what is seen at points and along lines, as polygons, and as they are.
#pragma once

#include <mutex>
#include <optional>
#include <vector>

#include <moire/frame.h>

#include "cells.h"
#include "world/primitives.h"

namespace primitives {

class PrimitivesFrame final : public moire::Frame,
                              private moire::Lines,
                              private moire::Polygons,
                              private moire::Curves {
 public:
  // Curves in the image, those in front last. tolerance: how far a chord may be from its arc, in pixels.
  PrimitivesFrame(std::vector<Curve> curves, moire::ImageSize size, moire::Color background, double tolerance);

  moire::ImageSize size() const override { return size_; }
  void trace(std::span<const moire::SamplePoint> points, std::span<moire::Hit> hits,
             moire::Counters& counters) const override;
  const moire::Lines* lines() const override { return this; }
  const moire::Polygons* polygons() const override { return this; }
  const moire::Curves* curves() const override { return this; }

 private:
  // Lines.
  void along(std::span<const moire::ImageLine> lines, const moire::Lookup* lookup, moire::Tally& pieces) const override;

  // Polygons.
  bool disjoint() const override { return false; }
  void stream(const moire::Rectangle& window, moire::PolygonSink& sink) const override;

  // Curves.
  void stream(moire::CurveSink& sink) const override;

  // Polygons and Curves.
  moire::Color background_color() const override { return background_; }

  // Made when it is first asked for: samplers that take polygons or curves never do.
  const Cells& cells() const;

  std::vector<Curve> curves_;
  moire::ImageSize size_;
  moire::Color background_;
  double tolerance_;
  std::vector<Shape> shapes_;     // of the curves that cover any area
  std::vector<moire::Hit> hits_;  // of each shape
  mutable std::once_flag cells_once_;
  mutable std::optional<Cells> cells_;
};

}  // namespace primitives
