#include <cstdlib>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <moire/error.h>
#include <moire/image.h>

#include "app/commands.h"
#include "app/replaced.h"
#include "files/whole_file.h"
#include "run/contender.h"

namespace moire::app {

namespace {

// A folder that is gone when it is no longer needed.
class TemporaryFolder {
 public:
  TemporaryFolder() {
    std::string name = (std::filesystem::temp_directory_path() / "moire-XXXXXX").string();
    if (!mkdtemp(name.data())) throw Error(name + ": cannot be made");
    path_ = name;
  }
  ~TemporaryFolder() {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
  }
  TemporaryFolder(const TemporaryFolder&) = delete;
  const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

nlohmann::json scene_entry(const std::string& scene) {
  if (std::filesystem::path(scene).extension() != ".json") return scene;
  return {{"use", std::filesystem::absolute(scene).string()}};
}

// Messages speak of the command, not of the file that it wrote for a moment.
Experiment checked(const nlohmann::json& request, const Vocabulary& vocabulary, const Overrides& overrides) {
  const TemporaryFolder folder;
  const std::filesystem::path file = folder.path() / "experiment.json";
  write_whole_file(file, request.dump());
  try {
    return read_experiment(file, vocabulary, overrides);
  } catch (const Error& error) {
    throw Error(replaced(error.what(), file.string() + ":1: ", "render: "));
  }
}

// "scene.x=1" means the only scene of the experiment.
std::string as_set(const std::string& set) {
  for (const auto& [mine, list] : {std::pair{"scene.", "scenes[0]."}, {"sampler.", "samplers[0]."}}) {
    if (set.starts_with(mine)) return list + set.substr(std::string_view(mine).size());
  }
  throw Error("--set " + set +
              ": is neither of the scene nor of the sampler; write scene.NAME=VALUE or sampler.NAME=VALUE");
}

}  // namespace

// An experiment of one job, so that everything is checked and read as in any other.
int render(const Session& session, const RenderOptions& options) {
  const nlohmann::json request{{"question", "What does it look like?"},
                               {"image", {{"width", options.width}, {"height", options.height}}},
                               {"scenes", {scene_entry(options.scene)}},
                               {"samplers", {options.sampler}}};
  Overrides overrides;
  for (const std::string& set : options.sets) overrides.sets.push_back(as_set(set));
  const Experiment experiment = checked(request, session.vocabulary, overrides);

  return attempt([&] {
    const SceneChoice& choice = experiment.scenes.front();
    const auto scene = choice.plugin->scene->make(choice.settings);
    const auto frame = scene->frame(choice.settings, experiment.image);
    const Picture picture =
        render_picture(Contender(experiment.samplers.front()), *frame, 0, experiment.seed, Workers(options.threads));
    write_image(options.output, picture.size.width, picture.size.height, picture.pixels);
    fmt::print("{}: {} on {}\n", options.output.string(), experiment.samplers.front().name, choice.name);
    return done;
  });
}

}  // namespace moire::app
