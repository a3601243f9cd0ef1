// Experiments that nobody runs in a test can at least be read: names, settings, files, and pairs that fit.
#include <catch2/catch_test_macros.hpp>
#include <cstdlib>
#include <filesystem>
#include <string>

#include "config/experiment.h"
#include "files/whole_file.h"
#include "metrics/registry.h"
#include "pictures/registry.h"
#include "sampling/filters.h"
#include "sampling/lookups.h"
#include "support/plugins.h"

namespace moire {

TEST_CASE("every experiment of the tree is without a fault, and has a README beside it") {
  if (!std::getenv("MOIRE_DATA")) SKIP("MOIRE_DATA is not set; experiments name files of the data folder");
  const Vocabulary vocabulary{&test::catalog(), metric_descriptions(), lookups(), picture_descriptions(), filters()};
  std::size_t found = 0;
  for (const auto& entry : std::filesystem::directory_iterator(MOIRE_SOURCES "/experiments")) {
    CAPTURE(entry.path());
    CHECK_NOTHROW(read_experiment(entry.path(), vocabulary, {}));
    CHECK(std::filesystem::exists(entry.path() / "README.md"));
    ++found;
  }
  CHECK(found >= 7);
}

TEST_CASE("the README names every plugin, metric, picture and experiment") {
  const std::string readme = read_whole_file(MOIRE_SOURCES "/README.md");
  const auto check = [&](std::string_view name) {
    CAPTURE(name);
    CHECK(readme.find('`' + std::string(name) + '`') != std::string::npos);
  };
  for (const Kind kind : {Kind::scene, Kind::sampler}) {
    for (const Plugin* plugin : test::catalog().all(kind)) check(plugin->name);
  }
  for (const PassDescription* metric : metric_descriptions()) check(metric->name);
  for (const PassDescription* picture : picture_descriptions()) check(picture->name);
  for (const auto& entry : std::filesystem::directory_iterator(MOIRE_SOURCES "/experiments"))
    check("experiments/" + entry.path().filename().string());
}

}  // namespace moire
