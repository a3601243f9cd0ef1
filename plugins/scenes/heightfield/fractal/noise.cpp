// Lattice noise that has the same bits on every machine.
#include "noise.h"

#include <array>
#include <cmath>

namespace heightfield {
namespace {

// Sixteen directions a sixteenth of a turn apart, none along an axis.
constexpr double c0 = 0.98078528040323043, s0 = 0.19509032201612825, c1 = 0.83146961230254524, s1 = 0.55557023301960218;
constexpr std::array<Vector, 16> directions = {{{c0, s0},
                                                {c1, s1},
                                                {s1, c1},
                                                {s0, c0},
                                                {-s0, c0},
                                                {-s1, c1},
                                                {-c1, s1},
                                                {-c0, s0},
                                                {-c0, -s0},
                                                {-c1, -s1},
                                                {-s1, -c1},
                                                {-s0, -c0},
                                                {s0, -c0},
                                                {s1, -c1},
                                                {c1, -s1},
                                                {c0, -s0}}};

// Twice the frequency, turned by the angle of the 3-4-5 triangle.
Vector next_octave(Vector p) { return {1.6 * p.x - 1.2 * p.y + 17.3, 1.2 * p.x + 1.6 * p.y - 9.1}; }

// One of sixteen for each lattice point; cheaper than a whole hash.
std::size_t corner(std::uint64_t key, std::int64_t x, std::int64_t y) {
  std::uint64_t z =
      key + static_cast<std::uint64_t>(x) * 0x9e3779b97f4a7c15U + static_cast<std::uint64_t>(y) * 0xc2b2ae3d27d4eb4fU;
  z = (z ^ (z >> 29)) * 0xbf58476d1ce4e5b9U;
  return z >> 60;
}

struct Fade {
  double value, slope;
  explicit Fade(double t) : value(t * t * t * (t * (t * 6 - 15) + 10)), slope(30 * t * t * (t * (t - 2) + 1)) {}
};

}  // namespace

double length(Vector v) { return std::sqrt(dot(v, v)); }

double ramp(double from, double to, double value) {
  const double t = (value - from) / (to - from);
  if (t <= 0) return 0;
  if (t >= 1) return 1;
  return t * t * (3 - 2 * t);
}

Vector direction(std::uint64_t hash) {
  // The rational circle, over a quarter turn; two more bits choose the quarter.
  const double t = part(hash, 0), scale = 1 / (1 + t * t);
  const Vector quarter = {(1 - t * t) * scale, 2 * t * scale};
  const Vector half = (hash & 0x10000) ? quarter : Vector{-quarter.y, quarter.x};
  return (hash & 0x20000) ? half : -1 * half;
}

NoiseValue Noise::at(Vector p) const {
  const double fx = std::floor(p.x), fy = std::floor(p.y);
  const auto ix = static_cast<std::int64_t>(fx), iy = static_cast<std::int64_t>(fy);
  const double x = p.x - fx, y = p.y - fy;
  const auto gradient = [&](int i, int j) { return directions[corner(key_, ix + i, iy + j)]; };
  const Vector ga = gradient(0, 0), gb = gradient(1, 0), gc = gradient(0, 1), gd = gradient(1, 1);
  const double a = dot(ga, {x, y}), b = dot(gb, {x - 1, y}), c = dot(gc, {x, y - 1}), d = dot(gd, {x - 1, y - 1});
  const Fade u(x), v(y);
  const double across = a - b - c + d;
  constexpr double scale = 1.4142135623730951;  // the largest value of gradient noise in the plane is sqrt(1/2)
  NoiseValue result;
  result.value = scale * (a + u.value * (b - a) + v.value * (c - a) + u.value * v.value * across);
  const Vector mean = ga + u.value * (gb - ga) + v.value * (gc - ga) + u.value * v.value * (ga - gb - gc + gd);
  result.gradient = scale * (mean + Vector{u.slope * (b - a + v.value * across), v.slope * (c - a + u.value * across)});
  return result;
}

double Noise::sum(Vector p, int octaves) const {
  double total = 0, amplitude = 1, all = 0;
  for (int i = 0; i < octaves; ++i) {
    total += amplitude * at(p).value;
    all += amplitude;
    amplitude /= 2;
    p = next_octave(p);
  }
  return total / all * 1.5;
}

double Noise::ridges(Vector p, int octaves) const {
  double total = 0, amplitude = 1, all = 0;
  Vector slope;
  for (int i = 0; i < octaves; ++i) {
    const NoiseValue n = at(p);
    const double sign = n.value < 0 ? 1 : -1;
    const double crest = 1 + sign * n.value;
    slope = slope + amplitude * sign * n.gradient;
    total += amplitude * crest * crest / (1 + 0.5 * dot(slope, slope));
    all += amplitude;
    amplitude /= 2;
    p = next_octave(p);
  }
  return total / all;
}

}  // namespace heightfield
