// Places in the image. Pixel (x, y) is the square [x, x + 1) x [y, y + 1); y grows downward.
#pragma once

namespace moire {

struct ImageSize {
  int width = 0, height = 0;
  friend bool operator==(const ImageSize&, const ImageSize&) = default;
};

// A point of the image in pixels. It may lie outside the image by a filter's radius.
struct Point {
  double x = 0, y = 0;
  friend bool operator==(const Point&, const Point&) = default;
};

// A point of an area light: (u, v) in [0, 1) x [0, 1), where equal areas stand for equal areas of the light.
struct LightPoint {
  float u = 0.5F, v = 0.5F;
};

// A point of the image and, for scenes with an area light, a point of the light.
struct SamplePoint {
  double x = 0, y = 0;
  float u = 0.5F, v = 0.5F;
};

struct Rectangle {
  double x0 = 0, y0 = 0, x1 = 0, y1 = 0;
};

// An affine map: (x, y) goes to (xx x + xy y + x0, yx x + yy y + y0).
struct Affine {
  double xx = 1, xy = 0, x0 = 0, yx = 0, yy = 1, y0 = 0;

  Point operator()(Point p) const { return {xx * p.x + xy * p.y + x0, yx * p.x + yy * p.y + y0}; }
  double determinant() const { return xx * yy - xy * yx; }
  friend bool operator==(const Affine&, const Affine&) = default;
};

// First `first`, then `second`.
inline Affine then(const Affine& first, const Affine& second) {
  const Point origin = second({first.x0, first.y0});
  return {second.xx * first.xx + second.xy * first.yx, second.xx * first.xy + second.xy * first.yy, origin.x,
          second.yx * first.xx + second.yy * first.yx, second.yx * first.xy + second.yy * first.yy, origin.y};
}

// A point in homogeneous image coordinates: (x / w, y / w), or the direction (x, y) where w is 0.
struct Pole {
  double x = 0, y = 0, w = 0;
};

}  // namespace moire
