// Reads an experiment: its tree, then each key, then what must fit together.
#include "config/experiment.h"

#include <algorithm>
#include <utility>

#include <fmt/format.h>

#include "config/choices.h"
#include "config/exact_settings.h"
#include "config/experiment_format.h"
#include "config/experiment_tree.h"
#include "config/frames_reader.h"
#include "config/naming.h"
#include "config/only.h"
#include "config/pass_choices.h"
#include "json/nearest_name.h"

namespace moire {
namespace {

class ExperimentReader {
 public:
  ExperimentReader(const ExperimentPlace& place, const Vocabulary& vocabulary, const JsonNode& root, Problems& problems)
      : vocabulary_(vocabulary), root_(root), problems_(problems), files_(place), options_(vocabulary) {
    experiment_.name = place.folder.filename().string();
  }

  void read() {
    refuse_unknown_keys();
    if (const JsonNode* question = required("question", "say in a sentence what it shall find out")) {
      experiment_.question = text_of(*question, format::question);
    }
    if (const JsonNode* image = required("image", "write such as \"image\": {\"width\": 400, \"height\": 400}")) {
      read_image_size(*image);
    }
    scenes_ = read_choices("scenes", Kind::scene);
    samplers_ = read_choices("samplers", Kind::sampler);
    read_reference();
    read_seed();
    read_keep_images();
    experiment_.frames = read_frames(root_.find("frames"), scenes_, reading_);
    metrics_ = read_passes(list("metrics"), root_.place,
                           {"metrics", "metric", vocabulary_.metrics, format::default_metric, true}, reading_);
    pictures_ = read_passes(list("pictures"), root_.place, {"pictures", "picture", vocabulary_.pictures}, reading_);
    refuse_impossible_scenes();
    refuse_mismatches();
    for (const auto* passes : {&metrics_, &pictures_}) refuse_passes(*passes);
    refuse_without_basis();
  }

  void keep_only(const std::string& only) { moire::keep_only(only, scenes_, samplers_, problems_); }

  Experiment finish() {
    for (const Choice& sampler : samplers_) experiment_.samplers.push_back(sampler_of(sampler));
    for (const Choice& scene : scenes_) {
      SceneChoice& choice = experiment_.scenes.emplace_back(scene_of(scene));
      for (const Choice& sampler : samplers_) {
        if (!sampler.if_it_fits) continue;
        std::string missing = missing_for(choice, sampler_of(sampler), vocabulary_);
        if (!missing.empty()) choice.without.emplace(sampler.name, std::move(missing));
      }
    }
    if (!reference_.empty()) experiment_.reference = sampler_of(reference_.front());
    for (const PassEntry& metric : metrics_) experiment_.metrics.push_back(metric.choice);
    for (const PassEntry& picture : pictures_) experiment_.pictures.push_back(picture.choice);
    experiment_.request = request();
    return std::move(experiment_);
  }

 private:
  void refuse_unknown_keys() {
    for (const JsonMember& member : root_.members) {
      const bool is_known =
          std::find(std::begin(format::keys), std::end(format::keys), member.key) != std::end(format::keys);
      if (is_known || member.key == "$schema") continue;
      problems_.add(member.place, member.key,
                    fmt::format("unknown key{} an experiment takes {}", did_you_mean(member.key, format::keys),
                                listed(format::keys)));
    }
  }

  const JsonNode* required(std::string_view key, std::string_view advice) {
    const JsonNode* node = root_.find(key);
    if (node == nullptr) problems_.add(root_.place, "", fmt::format("has no \"{}\"; {}", key, advice));
    return node;
  }

  std::string text_of(const JsonNode& node, const Parameter& parameter) {
    const auto cell = read_value(node, std::string(parameter.name), parameter, parameter.name, reading_);
    return cell ? std::get<std::string>(cell->value) : "";
  }

  void read_image_size(const JsonNode& image) {
    if (!image.is(JsonKind::object)) {
      return problems_.add(image.place, "image",
                           fmt::format("is {}; an image has a \"width\" and a \"height\"", shown(image)));
    }
    for (const Parameter& side : format::image) {
      if (image.find(side.name) == nullptr) {
        problems_.add(image.place, "image",
                      fmt::format("has no \"{}\"; an image has a \"width\" and a \"height\"", side.name));
      }
    }
    const auto cells = read_settings(image, "image", {"image", format::image, {}}, reading_);
    if (cells.empty()) return;
    const Settings size = settings_of(format::image, cells.front());
    experiment_.image = {static_cast<int>(size.integer("width")), static_cast<int>(size.integer("height"))};
  }

  // The list under this key; null if there is none, or something else (which is a problem).
  const JsonNode* list(std::string_view key) {
    const JsonNode* node = root_.find(key);
    if (node == nullptr || node->is(JsonKind::list)) return node;
    problems_.add(node->place, key, fmt::format("is {}; it takes a list of names or objects", shown(*node)));
    return &no_items_;
  }

  std::vector<Choice> read_choices(std::string_view key, Kind kind) {
    const JsonNode* entries =
        required(key, fmt::format("name one at least, such as \"{}\": [\"{}\"]", key, first_name(kind)));
    if (entries == nullptr) return {};
    entries = list(key);
    if (entries != &no_items_ && entries->items.empty())
      problems_.add(entries->place, key, "is an empty list; name one at least");
    std::vector<Choice> choices;
    const ChoiceContext context{vocabulary_, options_, reading_};
    for (std::size_t i = 0; i < entries->items.size(); ++i) {
      const JsonNode& entry = entries->items[i];
      if (kind == Kind::sampler && is_left_out(entry, item_path(key, i), context)) {
        leave_out(entry, item_path(key, i));
        continue;
      }
      const auto more = read_entry(entry, item_path(key, i), kind, true, context);
      choices.insert(choices.end(), more.begin(), more.end());
    }
    if (kind == Kind::sampler && !entries->items.empty() && experiment_.left_out.size() == entries->items.size())
      problems_.add(entries->place, key, "has none that is installed; name one at least that is");
    name_choices(choices, kind == Kind::scene ? "scene" : "sampler", problems_);
    return choices;
  }

  void leave_out(const JsonNode& entry, const std::string& path) {
    experiment_.left_out.push_back(
        fmt::format("{}: \"{}\" is left out: no such sampler is installed", path, entry.find("type")->text));
  }

  std::string first_name(Kind kind) const {
    const auto plugins = vocabulary_.catalog->all(kind);
    return plugins.empty() ? "" : plugins.front()->name;
  }

  void read_reference() {
    const JsonNode* node = root_.find("reference");
    if (node == nullptr || (node->is(JsonKind::text) && node->text == format::default_reference)) return;
    reference_ = read_entry(*node, "reference", Kind::sampler, false, {vocabulary_, options_, reading_});
    name_choices(reference_, "reference", problems_);
  }

  // A key of the experiment itself that holds one value.
  std::optional<Cell> read_own(const Parameter& parameter) {
    const JsonNode* node = root_.find(parameter.name);
    return node ? read_value(*node, std::string(parameter.name), parameter, parameter.name, reading_)
                : default_cell(parameter);
  }

  void read_seed() {
    if (const auto cell = read_own(format::seed))
      experiment_.seed = static_cast<std::uint64_t>(std::get<std::int64_t>(cell->value));
  }

  void read_keep_images() {
    if (const auto cell = read_own(format::keep_images)) experiment_.keep_images = std::get<bool>(cell->value);
  }

  void refuse_impossible_scenes() {
    for (const Choice& scene : scenes_) {
      const std::string problem = scene.plugin->scene->problem(settings_of(scene.table, scene.cells));
      if (!problem.empty())
        problems_.add(scene.place, scene.path, fmt::format("\"{}\" cannot be made: {}", scene.name, problem));
    }
  }

  void refuse_mismatches() {
    for (const Choice& scene : scenes_) {
      SceneChoice choice = scene_of(scene);
      for (const Choice& sampler : samplers_) refuse_mismatch(choice, sampler);
      // References see the exact scene.
      choice.settings = exact_settings(*choice.plugin->scene, choice.settings);
      for (const Choice& reference : reference_) refuse_mismatch(choice, reference);
    }
  }

  void refuse_mismatch(const SceneChoice& scene, const Choice& sampler) {
    if (sampler.if_it_fits) return;
    const std::string problem = mismatch(scene, sampler_of(sampler), vocabulary_);
    if (!problem.empty()) problems_.add(sampler.place, sampler.path, problem);
  }

  void refuse_passes(const std::vector<PassEntry>& passes) {
    for (const PassEntry& pass : passes) {
      const std::string problem =
          pass.description->problem(pass.choice.settings, {experiment_.image, experiment_.frames.count});
      const bool has_image = experiment_.image.width > 0;  // else that was said already
      if (has_image && !problem.empty()) problems_.add(pass.place, pass.path, problem);
      for (const Choice& scene : scenes_) {
        const std::string misfit = mismatch(scene_of(scene), *pass.description, pass.choice.settings, vocabulary_);
        if (!misfit.empty()) problems_.add(pass.place, pass.path, misfit);
      }
    }
  }

  void refuse_without_basis() {
    for (const PassEntry& pass : metrics_) {
      for (std::string_view basis : pass.description->basis) {
        if (std::any_of(metrics_.begin(), metrics_.end(), [&](const auto& m) { return m.choice.name == basis; }))
          continue;
        problems_.add(pass.place, pass.path,
                      fmt::format("works on the numbers of \"{}\", which is not among the metrics; add it", basis));
      }
    }
  }

  nlohmann::ordered_json request() const {
    nlohmann::ordered_json result = {
        {"question", experiment_.question},
        {"image", {{"width", experiment_.image.width}, {"height", experiment_.image.height}}},
        {"scenes", nlohmann::ordered_json::array()},
        {"samplers", nlohmann::ordered_json::array()},
        {"reference", format::default_reference},
        {"seed", experiment_.seed},
        {"frames", written(experiment_.frames)},
        {"metrics", nlohmann::ordered_json::array()},
        {"pictures", nlohmann::ordered_json::array()},
        {format::keep_images.name, experiment_.keep_images}};
    for (const Choice& scene : scenes_) result["scenes"].push_back(written(scene));
    for (const Choice& sampler : samplers_) result["samplers"].push_back(written(sampler));
    if (!reference_.empty()) result["reference"] = written(reference_.front());
    for (const PassEntry& metric : metrics_) result["metrics"].push_back(metric.written);
    for (const PassEntry& picture : pictures_) result["pictures"].push_back(picture.written);
    return result;
  }

  const Vocabulary& vocabulary_;
  const JsonNode& root_;
  Problems& problems_;
  DataFiles files_;
  format::OptionNames options_;
  Reading reading_{files_, problems_};
  JsonNode no_items_;
  std::vector<Choice> scenes_, samplers_, reference_;  // of the last: none for the default, or one
  std::vector<PassEntry> metrics_, pictures_;
  Experiment experiment_;
};

}  // namespace

Experiment read_experiment(const std::filesystem::path& path, const Vocabulary& vocabulary,
                           const Overrides& overrides) {
  const ExperimentPlace place = find_experiment(path);
  Problems problems;
  const JsonNode root = read_experiment_tree(place, overrides.sets, problems);
  ExperimentReader reader(place, vocabulary, root, problems);
  reader.read();
  problems.throw_if_any();  // before choosing from what might be incomplete
  reader.keep_only(overrides.only);
  problems.throw_if_any();
  return reader.finish();
}

}  // namespace moire
