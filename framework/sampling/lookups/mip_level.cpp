#include "sampling/lookups/mip_level.h"

#include <algorithm>
#include <bit>
#include <cstdint>
#include <limits>
#include <numbers>

namespace moire {

namespace {

// Of a normal number >= 1.
double log2_of(double x) {
  constexpr std::uint64_t mantissa_bits = (std::uint64_t{1} << 52) - 1, exponent_of_one = 1023;
  constexpr std::uint64_t root_of_two = std::bit_cast<std::uint64_t>(std::numbers::sqrt2) & mantissa_bits;
  const auto bits = std::bit_cast<std::uint64_t>(x);
  // x = m 2^e, m in sqrt(1/2) .. sqrt(2).
  const std::uint64_t up = (bits & mantissa_bits) > root_of_two ? 1 : 0;
  const auto e = static_cast<double>(static_cast<std::int64_t>((bits >> 52) + up) - 1023);
  const double m = std::bit_cast<double>((bits & mantissa_bits) | (exponent_of_one - up) << 52);
  // ln m = 2 artanh z; |z| < .1716, so that what the series leaves out is below 2 / ln 2 z^9 / 9 / (1 - z^2) = 5e-8.
  const double z = (m - 1) / (m + 1), zz = z * z;
  return e + 2 / std::numbers::ln2 * z * (1 + zz * (1.0 / 3 + zz * (1.0 / 5 + zz * (1.0 / 7))));
}

}  // namespace

double mip_level(double squared, double bias, int top) {
  if (!(squared <= std::numeric_limits<double>::max())) return top;
  const double level = squared > 1 ? log2_of(squared) / 2 : 0;
  return std::clamp(level + bias, 0.0, static_cast<double>(top));
}

}  // namespace moire
