// Random numbers of tests.
#pragma once

#include <random>

namespace moire::test {

class Numbers {
 public:
  explicit Numbers(unsigned seed = 1) : generator_(seed) {}
  double between(double low, double high) { return std::uniform_real_distribution<double>(low, high)(generator_); }

 private:
  std::mt19937_64 generator_;
};

}  // namespace moire::test
