// A face as a receiver of light, by the points of the image that show it.
#pragma once

#include <memory>
#include <vector>

#include "pixels/segment_index.h"

namespace shadow_planes {

class SeenFace {
 public:
  // `size`: of the picture, at least. The camera is not in the face's plane.
  SeenFace(const World& world, std::uint32_t face, const Camera& camera, moire::ImageSize size);

  std::uint32_t face() const { return face_; }
  const Illumination& illumination() const { return *illumination_; }
  const SegmentIndex& segments() const { return segments_; }
  // Where casters stand on it, in the image.
  const std::vector<moire::Point>& contacts() const { return contacts_; }

  // Of what the image shows at p. Requires: the ray through it meets the face's plane ahead.
  Vector point(moire::Point p) const {
    const Vector ray = camera_.ray(p);
    return camera_.eye - (height_ / dot(illumination_->side().normal, ray)) * ray;
  }

 private:
  std::uint32_t face_;
  Camera camera_;
  std::unique_ptr<const Illumination> illumination_;
  double height_;  // of the eye above the face
  SegmentIndex segments_;
  std::vector<moire::Point> contacts_;
};

}  // namespace shadow_planes
