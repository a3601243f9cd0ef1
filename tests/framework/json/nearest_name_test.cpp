#include "json/nearest_name.h"

#include <catch2/catch_test_macros.hpp>

namespace moire {
namespace {

constexpr std::string_view known[] = {"area", "bilinear", "point", "supersample"};

TEST_CASE("a slip of one letter, or two neighbours swapped, finds the name that was meant") {
  for (std::string_view slip : {"pont", "pointt", "paint", "piont"}) CHECK(nearest_name(slip, known) == "point");
}

TEST_CASE("long names may be off by more letters than short ones") {
  CHECK(nearest_name("supersampling", known) == "supersample");
  CHECK(nearest_name("are", known) == "area");
  CHECK(nearest_name("pt", known) == std::nullopt);
}

TEST_CASE("nothing is near to nothing, and a very long name is near to none") {
  CHECK(nearest_name("", known) == std::nullopt);
  CHECK(nearest_name("point", {}) == std::nullopt);
  CHECK(nearest_name(std::string(1000000, 'p'), known) == std::nullopt);
}

TEST_CASE("of two names equally near the first is named") {
  constexpr std::string_view twins[] = {"cat", "bat"};
  CHECK(nearest_name("rat", twins) == "cat");
}

TEST_CASE("the question is put only where there is a name to ask for") {
  CHECK(did_you_mean("pont", known) == "; did you mean \"point\"?");
  CHECK(did_you_mean("quincunx", known) == ";");
}

}  // namespace
}  // namespace moire
