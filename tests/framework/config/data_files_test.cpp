#include "config/data_files.h"

#include <cstdlib>

#include <catch2/catch_test_macros.hpp>

#include "experiment_folder.h"

namespace moire::test {
namespace {

// MOIRE_DATA with this value, or unset, as long as this lives.
class DataVariable {
 public:
  explicit DataVariable(const char* value) {
    const char* const before = std::getenv("MOIRE_DATA");
    if (before) before_ = before;
    had_one_ = before != nullptr;
    set(value);
  }
  DataVariable(const DataVariable&) = delete;
  DataVariable& operator=(const DataVariable&) = delete;
  ~DataVariable() { set(had_one_ ? before_.c_str() : nullptr); }

 private:
  static void set(const char* value) {
    if (value) {
      setenv("MOIRE_DATA", value, 1);
    } else {
      unsetenv("MOIRE_DATA");
    }
  }
  std::string before_;
  bool had_one_ = false;
};

std::vector<std::string> scene_with(const std::string& height) {
  return {R"("scenes": {"type": "heightfield", "height": ")" + height + "\"}"};
}

std::string height_of(const ExperimentFolder& folder, const std::string& height) {
  return folder.read(experiment_with(scene_with(height))).scenes[0].settings.text("height");
}

TEST_CASE("data files lie in MOIRE_DATA, else in the project's data folder") {
  const ExperimentFolder folder;
  std::filesystem::create_directories(folder.path() / "elsewhere/terrain");
  std::filesystem::create_directories(folder.path() / "data/terrain");
  const std::string own = folder.file("data/terrain/a.png", "").string();
  {
    const DataVariable unset(nullptr);
    CHECK(height_of(folder, "data:terrain/a.png") == own);
  }
  const DataVariable set((folder.path() / "elsewhere").c_str());
  CHECK(height_of(folder, "data:terrain/a.png") == own);
  const std::string other = folder.file("elsewhere/terrain/a.png", "").string();
  CHECK(height_of(folder, "data:terrain/a.png") == other);
}

TEST_CASE("a data file that is not there says where it was looked for") {
  const ExperimentFolder folder;
  {
    const DataVariable unset(nullptr);
    CHECK(folder.problems_with(scene_with("data:a.png")) ==
          "edges/experiment.json:4: scenes[0].height: is \"data:a.png\", but there is no such file (looked in data; "
          "MOIRE_DATA is not set); MOIRE_DATA should point at the data folder");
    std::filesystem::remove(folder.path() / "configs");
    CHECK(folder.problems_with(scene_with("data:a.png")) ==
          "edges/experiment.json:4: scenes[0].height: is \"data:a.png\", but there is no such file (MOIRE_DATA is not "
          "set); MOIRE_DATA should point at the data folder");
    std::filesystem::create_directory(folder.path() / "configs");
  }
  const DataVariable set((folder.path() / "elsewhere").c_str());
  CHECK(folder.problems_with(scene_with("data:a.png")) ==
        "edges/experiment.json:4: scenes[0].height: is \"data:a.png\", but there is no such file (looked in elsewhere "
        "and data); MOIRE_DATA should point at the data folder");
}

TEST_CASE("other files lie beside the JSON file that names them") {
  const ExperimentFolder folder;
  const std::string beside = folder.file("configs/a.png", "").string();
  folder.file("configs/scene.json", R"({"type": "heightfield", "height": "a.png"})");
  const auto scenes = folder.read(experiment_with({R"("scenes": {"use": "configs/scene.json"})"})).scenes;
  CHECK(scenes[0].settings.text("height") == beside);
  CHECK(height_of(folder, "../configs/a.png") == beside);
  CHECK(height_of(folder, beside) == beside);
}

TEST_CASE("what is no file cannot be read") {
  const ExperimentFolder folder;
  CHECK(folder.problems_with(scene_with("a.png")) ==
        "edges/experiment.json:4: scenes[0].height: is \"a.png\", but there is no such file (looked for edges/a.png)");
  CHECK(folder.problems_with(scene_with("../data")) ==
        "edges/experiment.json:4: scenes[0].height: is \"../data\", a folder (looked for data)");
  CHECK(folder.problems_with(scene_with("/dev/null")) ==
        "edges/experiment.json:4: scenes[0].height: is \"/dev/null\", no regular file (looked for /dev/null)");
}

}  // namespace
}  // namespace moire::test
