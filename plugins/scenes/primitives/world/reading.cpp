#include "reading.h"

namespace primitives {

namespace {

using moire::DocumentValue;

constexpr double largest_spin = 1e6;  // degrees

moire::Point read_pair(const DocumentValue& value, std::string_view meaning) {
  if (value.size() != 2) value.refuse(std::string("is no pair of numbers; ").append(meaning));
  return {value[0].number(-largest_length, largest_length), value[1].number(-largest_length, largest_length)};
}

moire::Point read_point(const DocumentValue& value) { return read_pair(value, "a point is [x, y]"); }

// Of lines and circles alike.
template <class Of>
void read_look(const DocumentValue& value, const Style& style, Of& curve) {
  curve.color = value.has("color") ? value["color"].color() : style.color;
  curve.width = value.has("width") ? value["width"].number(0, largest_length) : style.width;
}

moire::LineCurve read_line(const DocumentValue& value, const Style& style) {
  value.allow_only({"type", "from", "to", "width", "cap", "color", "velocity", "spin_deg"});
  moire::LineCurve line;
  line.from = read_point(value["from"]);
  line.to = read_point(value["to"]);
  read_look(value, style, line);
  line.cap = value.has("cap") ? moire::Cap(value["cap"].choice({"butt", "square", "round"})) : style.cap;
  return line;
}

moire::CircleCurve read_circle(const DocumentValue& value, const Style& style) {
  value.allow_only({"type", "center", "radius", "width", "color", "velocity"});
  moire::CircleCurve circle;
  circle.center = read_point(value["center"]);
  circle.radius = value["radius"].number(0, largest_length);
  read_look(value, style, circle);
  return circle;
}

Primitive read_primitive(const DocumentValue& value, const Style& style) {
  Primitive primitive;
  if (value["type"].choice({"line", "circle"}) == 0) {
    primitive.curve = read_line(value, style);
  } else {
    primitive.curve = read_circle(value, style);
  }
  if (value.has("velocity")) primitive.motion.velocity = read_pair(value["velocity"], "a velocity is [dx, dy]");
  if (value.has("spin_deg")) primitive.motion.spin_deg = value["spin_deg"].number(-largest_spin, largest_spin);
  return primitive;
}

}  // namespace

Picture read_picture(const moire::Document& document, const Style& style) {
  const DocumentValue root = document.root();
  root.allow_only({"background", "primitives"});
  Picture picture;
  if (root.has("background")) picture.background = root["background"].color();
  const DocumentValue list = root["primitives"];
  for (std::size_t k = 0; k < list.size(); ++k) picture.primitives.push_back(read_primitive(list[k], style));
  return picture;
}

}  // namespace primitives
