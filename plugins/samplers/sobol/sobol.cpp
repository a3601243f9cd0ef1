// The first two dimensions of Sobol's sequence, scrambled by Owen's nested permutations, new ones in every pixel: of
// N = 2^k points every box of area 1 / N whose sides are powers of two has exactly one.
//
// The permutations are those of a hash that carries only upward, on the digits in reverse (Laine, Karras 2011,
// doi:10.1111/j.1467-8659.2011.01942.x; Burley 2020, "Practical Hash-based Owen Scrambling", JCGT 9(4)), in the form
// whose avalanche Vegdahl 2021 measured as best ("Building a Better LK Hash", psychopath.io).
#include <moire/plugin.h>
#include <moire/reseed.h>

namespace {

using namespace moire::parameter;

constexpr moire::Parameter parameters[] = {
    integer("points", 16, 1, 65536, "points", "points of a pixel; powers of two are best, others are not stratified"),
    moire::Reseed::parameter,
};

// Of 32 binary digits after the point, in reverse: the first is bit 0.
constexpr std::uint32_t reversed(std::uint32_t x) {
  x = (x & 0x55555555U) << 1 | (x >> 1 & 0x55555555U);
  x = (x & 0x33333333U) << 2 | (x >> 2 & 0x33333333U);
  x = (x & 0x0f0f0f0fU) << 4 | (x >> 4 & 0x0f0f0f0fU);
  x = (x & 0x00ff00ffU) << 8 | (x >> 8 & 0x00ff00ffU);
  return x << 16 | x >> 16;
}

// Each bit is kept or turned, as the seed and the bits below it decide: every step is of that kind, since products
// with even numbers reach upward only and an odd factor keeps the lowest bit of whatever it multiplies.
constexpr std::uint32_t permuted(std::uint32_t x, std::uint32_t seed) {
  x ^= x * 0x3d20adeaU;
  x += seed;
  x *= seed >> 16 | 1U;
  x ^= x * 0x05526c56U;
  x ^= x * 0x53a22864U;
  return x;
}

// The middle of the interval of 2^-32 that these digits, in reverse, leave open.
constexpr double number(std::uint32_t digits) { return (reversed(digits) + 0.5) * 0x1p-32; }

// The second dimension in reverse, of the primitive polynomial x + 1: its matrix is Pascal's triangle modulo 2.
constexpr std::uint32_t second(std::uint32_t index) {
  std::uint32_t result = 0;
  for (std::uint32_t column = 1; index != 0; index >>= 1, column ^= column << 1) {
    if ((index & 1) != 0) result ^= column;
  }
  return result;
}

class Sobol final : public moire::PointSampler {
 public:
  explicit Sobol(const moire::Settings& settings)
      : count_(static_cast<std::uint32_t>(settings.integer("points"))), reseed_(settings) {}

  void points(const moire::Pixel& pixel, moire::Points& out) const override {
    const moire::Pixel key = reseed_.key(pixel);
    const auto seed = [&](std::uint32_t dimension) {
      return static_cast<std::uint32_t>(moire::random(key, 0, dimension) * 0x1p32);
    };
    const std::uint32_t across = seed(0), down = seed(1);
    for (std::uint32_t k = 0; k < count_; ++k) {
      out.add(number(permuted(k, across)), number(permuted(second(k), down)));
    }
  }

 private:
  std::uint32_t count_;
  moire::Reseed reseed_;
};

}  // namespace

MOIRE_SAMPLER(sobol, "1.0.0",
              (moire::SamplerPlugin{
                  .summary = "Points of Sobol's sequence, scrambled anew in each pixel; powers of two are best.",
                  .source = "Sobol 1967, doi:10.1016/0041-5553(67)90144-9; Owen 1995; Burley 2020; Vegdahl 2021",
                  .parameters = parameters,
                  .claims = {.deterministic = false, .unbiased = true},
                  .make_points = [](const moire::Settings& settings) -> std::unique_ptr<moire::PointSampler> {
                    return std::make_unique<Sobol>(settings);
                  },
              }))
