#include "world/kinds.h"

#include <array>

#include <moire/turn.h>

#include "world/faces.h"

namespace shadow_planes {

namespace {

constexpr moire::Color chalk{0.8F, 0.8F, 0.78F}, brick{0.62F, 0.2F, 0.12F}, moss{0.2F, 0.45F, 0.16F},
    slate{0.22F, 0.33F, 0.55F}, straw{0.75F, 0.6F, 0.25F};

Face painted(const std::vector<Vector>& corners, moire::Color color) {
  Face face = face_of(corners);
  face.reflectance = color;
  return face;
}

// A horizontal rectangle about a middle, turned about the upright, then raised by `rise` per unit along its first side.
// Its normal points up.
std::vector<Vector> board(const Vector& middle, double width, double depth, double turned_deg, double rise = 0) {
  const moire::Turn turn = moire::turn_of(turned_deg);
  std::vector<Vector> corners;
  constexpr std::array<std::array<double, 2>, 4> signs{{{-1, -1}, {1, -1}, {1, 1}, {-1, 1}}};
  for (const auto& [across, along] : signs) {
    const double x = across * width / 2, y = along * depth / 2;
    corners.push_back(middle + Vector{turn.cosine * x - turn.sine * y, turn.sine * x + turn.cosine * y, rise * x});
  }
  return corners;
}

std::vector<Vector> reversed(std::vector<Vector> corners) { return {corners.rbegin(), corners.rend()}; }

// An upright rectangle over the line from a to b, both of one height.
std::vector<Vector> upright(const Vector& a, const Vector& b, double height) {
  const Vector up{0, 0, height};
  return {a, b, b + up, a + up};
}

Source measured() {
  Source source;
  source.faces.push_back(painted(board({0, 0, 0}, 6, 6, 0), chalk));
  source.light.corners = reversed(board({0, 0, 4}, 1, 1, 17));
  source.light.towards = Vector{0.45, 0.3, 1};
  return source;
}

Source tilted() {
  Source source = measured();
  source.faces.push_back(painted(board({0.3, -0.2, 1.4}, 1.6, 1.2, 35, 0.5), brick));
  return source;
}

Source parallel() {
  Source source = measured();
  source.faces.push_back(painted(board({0.2, 0.1, 1.5}, 1.4, 1.1, 17), brick));
  return source;
}

Source three() {
  Source source = measured();
  source.faces.push_back(painted(board({-1, 0.6, 1.2}, 1.1, 0.8, 20, 0.3), brick));
  source.faces.push_back(painted(board({0.9, 0.8, 1.7}, 0.7, 0.9, -30, -0.4), moss));
  source.faces.push_back(painted(board({0.3, -1, 0.8}, 1.3, 0.6, 65, 0.2), slate));
  return source;
}

Source wall() {
  Source source = measured();
  source.faces.push_back(painted(upright({-1.3, 0.7, 0}, {0.6, 1.2, 0}, 1.1), brick));
  source.faces.push_back(painted(board({0.2, -0.5, 1.3}, 1.2, 0.9, 28, 0.25), moss));
  source.faces.push_back(painted(board({0.6, -0.8, 1.9}, 0.9, 0.9, -12, -0.2), slate));
  return source;
}

Source slats() {
  Source source = measured();
  for (int k = 0; k < 8; ++k)
    source.faces.push_back(painted(board({0.32 * (k - 3.5), 0.05 * k, 1.2}, 0.14, 2.4, 9, 0.6), straw));
  return source;
}

// Several receivers: floor, two walls, a table, a board that leans on a wall, a screen with a notch, a window frame of
// slats before the light.
Source room() {
  Source source;
  std::vector<Face>& faces = source.faces;
  faces.push_back(painted(board({0, 0, 0}, 6, 6, 0), chalk));
  faces.push_back(painted(upright({3, 3, 0}, {-3, 3, 0}, 3.2), chalk));
  faces.push_back(painted(upright({-3, 3, 0}, {-3, -3, 0}, 3.2), slate));
  // A table of four legs.
  faces.push_back(painted(board({-0.7, 0.4, 0.9}, 1.8, 1.2, 12), brick));
  const std::vector<Vector> corners = board({-0.7, 0.4, 0}, 1.6, 1, 12);
  for (const Vector& p : corners) {
    faces.push_back(painted(upright(p - Vector{0.06, 0, 0}, p + Vector{0.06, 0, 0}, 0.9), brick));
    faces.push_back(painted(upright(p - Vector{0, 0.06, 0}, p + Vector{0, 0.06, 0}, 0.9), brick));
  }
  // An arrow above it, a board against the wall behind.
  std::vector<Vector> arrow{{-1.3, 0.1, 0},  {-0.5, 0.1, 0}, {-0.5, -0.15, 0}, {0, 0.3, 0},
                            {-0.5, 0.75, 0}, {-0.5, 0.5, 0}, {-1.3, 0.5, 0}};
  for (Vector& p : arrow) p.z = 1.475 + 0.25 * p.y;
  faces.push_back(painted(arrow, straw));
  faces.push_back(painted({{1, 1.6, 0}, {2.2, 1.6, 0}, {2.2, 3, 2}, {1, 3, 2}}, moss));
  // A screen with a notch.
  faces.push_back(painted({{0.9, -1.2, 0},
                           {2.1, -0.4, 0},
                           {2.1, -0.4, 1.2},
                           {1.7, -2.0 / 3, 1.2},
                           {1.5, -0.8, 0.5},
                           {1.3, -14.0 / 15, 1.2},
                           {0.9, -1.2, 1.2}},
                          slate));
  source.light.corners = reversed(board({1.2, -1.4, 3.8}, 1, 1, 17));
  source.light.towards = Vector{0.8, -0.9, 1.6};
  return source;
}

}  // namespace

Source kind_of_name(std::string_view name) {
  if (name == "tilted") return tilted();
  if (name == "parallel") return parallel();
  if (name == "three") return three();
  if (name == "wall") return wall();
  if (name == "slats") return slats();
  return room();
}

}  // namespace shadow_planes
