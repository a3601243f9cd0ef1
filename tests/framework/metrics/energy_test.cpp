#include "metrics/energy.h"

#include <catch2/catch_approx.hpp>
#include <catch2/catch_test_macros.hpp>
#include <cmath>

#include "metrics/registry.h"

namespace moire::test {
namespace {

constexpr ImageSize size{4, 3};

PixelBlock grey(float light) {
  PixelBlock block({0, 0, size.width, size.height}, false);
  for (std::size_t slot = 0; slot < block.slots(); ++slot) block.add(slot, 1, 1, {light, light, light});
  return block;
}

std::map<std::string, double> energy(const std::vector<PixelBlock>& own, const std::vector<PixelBlock>& reference) {
  const auto metric = make_energy(Settings(), size);
  for (std::size_t k = 0; k < own.size(); ++k) metric->see({static_cast<int>(k), own[k], &reference[k], nullptr});
  std::map<std::string, double> values;
  for (const Measurement& m : metric->finish()) values[std::string(m.quantity)] = m.value;
  return values;
}

}  // namespace

TEST_CASE("energy is the light of all pixels, its swing over time and its distance from the reference's") {
  PixelBlock half = grey(0);
  for (int y = 0; y < size.height; ++y) {
    for (int x = 0; x < size.width / 2; ++x) half.add(half.slot(x, y), 1, 1, {2, 2, 2});  // averages with the 0: 1
  }
  const auto values = energy({grey(0.25F), half, grey(0.75F)}, {grey(0.5F), grey(0.5F), grey(0.5F)});
  CHECK(values.at("energy.mean") == Catch::Approx(0.5));
  CHECK(values.at("energy.swing") == Catch::Approx((0.75 - 0.25) / 0.5));
  CHECK(values.at("energy.error") == Catch::Approx(0.25 / 0.5));
}

TEST_CASE("energy of what is not a number is not a number") {
  const auto values = energy({grey(0.5F), grey(std::nanf(""))}, {grey(0.5F), grey(0.5F)});
  CHECK(std::isnan(values.at("energy.mean")));
  CHECK(std::isnan(values.at("energy.error")));
}

}  // namespace moire::test
