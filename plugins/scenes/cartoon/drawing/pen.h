// Draws one layer of a drawing after another.
#pragma once

#include "drawing.h"

namespace cartoon {

class Pen {
 public:
  explicit Pen(Drawing& drawing) : drawing_(drawing) {}

  // What is drawn from now on goes through this map.
  void set_transform(const moire::Affine& transform) { transform_ = transform; }
  const moire::Affine& transform() const { return transform_; }

  // Error (all of these): a place beyond largest_coordinate, before the map or after it.
  void move_to(moire::Point p);
  void line_to(moire::Point p);
  void quadratic_to(moire::Point control, moire::Point p);
  void cubic_to(moire::Point control1, moire::Point control2, moire::Point p);
  // An arc of the ellipse with these radii, its x axis turned by `angle_deg`: the longer way round or the shorter one,
  // with rising angles (clockwise, as y grows downward) or falling ones. Radii too small are enlarged, and without
  // radii it is a line (SVG 1.1, appendix F.6). Error: also, an angle that is no such number.
  void arc_to(double rx, double ry, double angle_deg, bool large, bool rising, moire::Point p);
  // Back to where the contour began; what follows begins there.
  void close();

  void ellipse(moire::Point center, double rx, double ry);

  moire::Point at() const { return at_; }

  // Whether anything was drawn since the last layer.
  bool has_drawn() const { return drawing_.verbs.size() > first_verb_; }
  // Makes a layer of what was drawn since the last one.
  void finish(Rgb color, moire::FillRule rule);
  // Forgets what was drawn since the last layer.
  void discard();

 private:
  void begin(Verb verb);
  void put(moire::Point p);
  void put_arc(moire::Point center, moire::Point u, moire::Point v, double a, double b, moire::Point end);

  Drawing& drawing_;
  moire::Affine transform_;
  moire::Point at_, start_;
  bool open_ = false;  // a contour was begun and not closed
  std::size_t first_verb_ = 0, first_point_ = 0;
};

}  // namespace cartoon
