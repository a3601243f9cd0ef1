// A drawing in one image: its polygons, what is seen at points, and along lines.
#pragma once

#include <memory>
#include <mutex>
#include <optional>

#include <moire/frame.h>

#include "drawing/outlines.h"
#include "edges.h"

namespace cartoon {

class CartoonFrame final : public moire::Frame, private moire::Lines, private moire::Polygons, private moire::Artwork {
 public:
  // `placement`: from the drawing to the image.
  CartoonFrame(std::shared_ptr<const Outlines> outlines, const moire::Affine& placement, moire::ImageSize size,
               moire::Color background, moire::Blend blend);

  moire::ImageSize size() const override { return size_; }
  moire::Blend blend() const override { return blend_; }
  void trace(std::span<const moire::SamplePoint> points, std::span<moire::Hit> hits,
             moire::Counters& counters) const override;
  const moire::Lines* lines() const override { return this; }
  const moire::Polygons* polygons() const override { return this; }

 private:
  // Lines.
  void along(std::span<const moire::ImageLine> lines, const moire::Lookup* lookup, moire::Tally& pieces) const override;

  // Polygons.
  bool disjoint() const override { return false; }
  void stream(const moire::Rectangle& window, moire::PolygonSink& sink) const override;
  moire::Color background_color() const override { return background_; }
  const moire::Artwork* artwork() const override { return this; }

  // Artwork.
  std::uint64_t identity() const override { return outlines_->identity(); }
  moire::Affine placement() const override { return placement_; }
  void stream(moire::PolygonSink& sink) const override;

  // Made when it is first asked for: samplers that take polygons never do.
  const Edges& edges() const;

  std::shared_ptr<const Outlines> outlines_;
  moire::Affine placement_;
  moire::ImageSize size_;
  moire::Color background_;
  moire::Blend blend_;
  std::vector<moire::Point> points_;     // in the image, as outlines_->points()
  std::vector<moire::Hit> hits_;         // of each layer, and the background
  std::vector<moire::Rectangle> boxes_;  // around each layer, in the image
  mutable std::once_flag edges_once_;
  mutable std::optional<Edges> edges_;
};

}  // namespace cartoon
