#include "exact/curves/shape.h"

namespace area {

Shape::Shape(const moire::LineCurve& line) : areas_(Stroke(line)) {
  if (line.cap != moire::Cap::round) return;
  moire::LineCurve butt = line;
  butt.cap = moire::Cap::butt;
  areas_ = Capsule{Stroke(butt), {Annulus(line.from, line.width / 2), Annulus(line.to, line.width / 2)}};
}

void Shape::add(const Stroke& stroke, int x, int y, std::uint32_t layer, Slabs& slabs) {
  slabs.begin_cover(layer);
  for (const HalfPlane& side : stroke.sides(x, y)) slabs.half_plane(side);
}

void Shape::add(const Annulus& annulus, int x, int y, std::uint32_t layer, Slabs& slabs) {
  slabs.begin_cover(layer);
  slabs.disk(annulus.outer(x, y));
  if (annulus.has_hole()) slabs.hole(annulus.inner(x, y));
}

void Shape::add(const Capsule& capsule, int x, int y, std::uint32_t layer, Slabs& slabs) {
  if (!capsule.stroke.is_empty()) add(capsule.stroke, x, y, layer, slabs);
  for (const Annulus& disk : capsule.disks) add(disk, x, y, layer, slabs);
}

}  // namespace area
