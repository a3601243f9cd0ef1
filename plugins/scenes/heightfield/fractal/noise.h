// Lattice noise that has the same bits on every machine: integer hashes, and of floating point only + - * / sqrt floor.
#pragma once

#include <cstdint>

#include <moire/random.h>

namespace heightfield {

struct Vector {
  double x = 0, y = 0;

  friend Vector operator+(Vector a, Vector b) { return {a.x + b.x, a.y + b.y}; }
  friend Vector operator-(Vector a, Vector b) { return {a.x - b.x, a.y - b.y}; }
  friend Vector operator*(double f, Vector v) { return {f * v.x, f * v.y}; }
};

inline double dot(Vector a, Vector b) { return a.x * b.x + a.y * b.y; }
double length(Vector v);

// 0 up to `from`, 1 from `to` on, a smooth step between. `to` may be less than `from`: then the step goes down.
double ramp(double from, double to, double value);

// 64 bits for one lattice point.
inline std::uint64_t hashed(std::uint64_t key, std::int64_t x, std::int64_t y) {
  return moire::mixed(key + static_cast<std::uint64_t>(x) * 0x9e3779b97f4a7c15U +
                      static_cast<std::uint64_t>(y) * 0xc2b2ae3d27d4eb4fU);
}

// The part of a hash that starts at `bit`, 16 bits long, as a number in [0, 1).
constexpr double part(std::uint64_t hash, int bit) { return static_cast<double>((hash >> bit) & 0xffff) * 0x1p-16; }

// A random direction, unit length.
Vector direction(std::uint64_t hash);

struct NoiseValue {
  double value = 0;  // within -1 .. 1, mostly within -0.6 .. 0.6
  Vector gradient;
};

// Gradient noise on the unit lattice, after Perlin ("An Image Synthesizer", 1985, doi:10.1145/325165.325247, with the
// quintic fade of "Improving Noise", 2002, doi:10.1145/566654.566636).
class Noise {
 public:
  // Each `purpose` has noise of its own.
  Noise(std::uint64_t seed, std::uint64_t purpose)
      : key_(moire::mixed(seed * 0x9e3779b97f4a7c15U + moire::mixed(purpose + 1))) {}

  NoiseValue at(Vector p) const;
  double operator()(Vector p) const { return at(p).value; }

  // White noise in [0, 1), one number a lattice point.
  double white(int x, int y) const { return part(hashed(key_, x, y), 20); }

  // Octaves of halved amplitude and doubled frequency, each turned so that their lattices do not line up.
  double sum(Vector p, int octaves) const;

  // The same with valleys that cut: each octave folded at zero and damped where the slope summed so far is steep, which
  // keeps ridges rough and slopes and hollows smooth as erosion does (Musgrave, Kolb, Mace 1989,
  // doi:10.1145/74333.74337; damping by the gradient after de Carpentier, Bidarra,
  // "Interactive GPU-based procedural heightfield brushes", Foundations of Digital Games 2009, pages 55-62).
  // Within 0 .. 1.
  double ridges(Vector p, int octaves) const;

  std::uint64_t key() const { return key_; }

 private:
  std::uint64_t key_;
};

}  // namespace heightfield
