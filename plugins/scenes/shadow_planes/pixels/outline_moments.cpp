#include "pixels/outline_moments.h"

#include <cmath>

namespace shadow_planes {

OutlineMoments moments_of(const Outline& outline) {
  // About the first corner, as a sum of triangles.
  const moire::Point o = outline[0];
  double twice = 0, x = 0, y = 0, xx = 0, xy = 0, yy = 0;
  for (std::size_t k = 2; k < outline.size(); ++k) {
    const double px = outline[k - 1].x - o.x, py = outline[k - 1].y - o.y;
    const double qx = outline[k].x - o.x, qy = outline[k].y - o.y;
    const double t = px * qy - qx * py;
    twice += t;
    x += t * (px + qx);
    y += t * (py + qy);
    xx += t * (px * px + px * qx + qx * qx);
    yy += t * (py * py + py * qy + qy * qy);
    xy += t * (2 * px * py + px * qy + qx * py + 2 * qx * qy);
  }
  OutlineMoments m;
  m.area = twice / 2;
  if (!(twice > 0)) return m;
  x /= 3 * twice, y /= 3 * twice;
  m.centroid = {o.x + x, o.y + y};
  xx = xx / (6 * twice) - x * x;
  xy = xy / (12 * twice) - x * y;
  yy = yy / (6 * twice) - y * y;
  if (!(xx > 0)) return m;
  m.xu = std::sqrt(xx);
  m.yu = xy / m.xu;
  const double rest = yy - m.yu * m.yu;
  if (!(rest > 1e-14 * yy)) return m;
  m.yv = std::sqrt(rest);
  // Of third order about the centroid: the mean over a triangle with a corner there, times its area.
  double uuu = 0, uuv = 0, uvv = 0, vvv = 0;
  const auto placed = [&](const moire::Point& p) {
    const double u = (p.x - m.centroid.x) / m.xu;
    return moire::Point{u, (p.y - m.centroid.y - m.yu * u) / m.yv};
  };
  double whole = 0;
  moire::Point p = placed(outline.back());
  for (const moire::Point& corner : outline) {
    const moire::Point q = placed(corner);
    const double t = p.x * q.y - q.x * p.y;
    whole += t;
    uuu += t * (p.x * p.x * p.x + p.x * p.x * q.x + p.x * q.x * q.x + q.x * q.x * q.x) * 3;
    vvv += t * (p.y * p.y * p.y + p.y * p.y * q.y + p.y * q.y * q.y + q.y * q.y * q.y) * 3;
    uuv += t * (3 * p.x * p.x * p.y + p.x * p.x * q.y + 2 * p.x * q.x * p.y + q.x * q.x * p.y + 2 * p.x * q.x * q.y +
                3 * q.x * q.x * q.y);
    uvv += t * (3 * p.y * p.y * p.x + p.y * p.y * q.x + 2 * p.y * q.y * p.x + q.y * q.y * p.x + 2 * p.y * q.y * q.x +
                3 * q.y * q.y * q.x);
    p = q;
  }
  const double scale = 1 / (30 * whole);
  m.cos1 = scale * (uuu + uvv);
  m.sin1 = scale * (uuv + vvv);
  m.cos3 = scale * (uuu - 3 * uvv);
  m.sin3 = scale * (3 * uuv - vvv);
  return m;
}

}  // namespace shadow_planes
