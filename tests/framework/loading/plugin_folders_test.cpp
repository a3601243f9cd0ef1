// Where plugins are looked for, in which order, and who is told of a missing folder.
#include <catch2/catch_test_macros.hpp>
#include <cstdlib>
#include <optional>

#include "loading/catalog.h"
#include "message_of.h"
#include "temporary_folder.h"

using moire::test::message_of;
using moire::test::TemporaryFolder;

namespace {

namespace fs = std::filesystem;

// Sets MOIRE_PLUGIN_PATH for one test.
class PluginPath {
 public:
  explicit PluginPath(const std::string& value) {
    if (const char* const old = std::getenv(variable)) before_ = old;
    setenv(variable, value.c_str(), 1);
  }
  PluginPath(const PluginPath&) = delete;
  PluginPath& operator=(const PluginPath&) = delete;
  ~PluginPath() {
    if (before_) {
      setenv(variable, before_->c_str(), 1);
    } else {
      unsetenv(variable);
    }
  }

 private:
  static constexpr char variable[] = "MOIRE_PLUGIN_PATH";
  std::optional<std::string> before_;
};

fs::path beside_program() { return fs::canonical("/proc/self/exe").parent_path() / "../lib/moire/plugins"; }

}  // namespace

TEST_CASE("plugins are looked for beside the program, in MOIRE_PLUGIN_PATH, then in the folders given") {
  const TemporaryFolder a, b, c;
  const PluginPath path(a.path().string() + "::" + b.path().string() + ":");
  const auto folders = moire::plugin_folders(std::vector{c.path()});
  REQUIRE(folders.size() == 4);
  CHECK(fs::equivalent(folders[0], beside_program()));
  CHECK(folders[1] == a.path());
  CHECK(folders[2] == b.path());
  CHECK(folders[3] == c.path());
}

TEST_CASE("a folder named twice is looked in once") {
  const TemporaryFolder folder;
  const PluginPath path(beside_program().string());
  const auto folders = moire::plugin_folders(std::vector{folder.path(), folder.path() / "."});
  REQUIRE(folders.size() == 2);
  CHECK(fs::equivalent(folders[0], beside_program()));
  CHECK(folders[1] == folder.path());
}

TEST_CASE("missing folders are errors that say who named them") {
  const PluginPath path("/no/such/folder");
  CHECK(message_of([] { moire::plugin_folders(std::vector<fs::path>{"none"}); }) ==
        "MOIRE_PLUGIN_PATH: is no folder (\"/no/such/folder\"); name one that has plugins in it\n"
        "--plugins: is no folder (\"none\"); name one that has plugins in it");
}
