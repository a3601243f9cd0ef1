// Whether a sampler can run on a scene, and a pass over it: if the scene answers all that they and the lookup ask.
#include <algorithm>
#include <utility>

#include <fmt/format.h>

#include "config/exact_settings.h"
#include "config/experiment.h"
#include "json/nearest_name.h"

namespace moire {
namespace {

Questions without(Questions all, Questions known) {
  return static_cast<Questions>(static_cast<std::uint32_t>(all) & ~static_cast<std::uint32_t>(known));
}

std::string in_words(Questions questions) {
  constexpr std::pair<Questions, std::string_view> all[] = {
      {Questions::points, "points"},
      {Questions::lines, "lines"},
      {Questions::radial_lines, "lines through a common point"},
      {Questions::polygons, "polygons"},
      {Questions::surface, "places on a texture"},
      {Questions::curves, "lines and circles with their ends"},
      {Questions::averages, "exact averages over pixels"},
      {Questions::filtered_averages, "exact averages under filters"},
      {Questions::spectrum, "known frequencies"}};
  std::vector<std::string_view> words;
  for (const auto& [question, name] : all) {
    if ((questions & question) != Questions::none) words.push_back(name);
  }
  return fmt::format("{}", fmt::join(words, " and "));
}

// Null in RenderRequest.
constexpr std::string_view box = "box";

Questions asked(const SamplerChoice& sampler, const Vocabulary& vocabulary) {
  const bool is_nearest = sampler.lookup == vocabulary.lookups.front().name;
  const Questions own = sampler.plugin->sampler->asks(sampler.settings);
  const bool scene_filters = sampler.filter != box && (own & Questions::averages) != Questions::none;
  return own | (is_nearest ? Questions::none : Questions::surface) |
         (scene_filters ? Questions::filtered_averages : Questions::none);
}

// What would do: other settings of the scene, or the known scenes that answer this with their default settings.
std::string advice_on(Questions questions, const SceneChoice& scene, const Vocabulary& vocabulary) {
  const ScenePlugin& own = *scene.plugin->scene;
  if (without(questions, own.answers(exact_settings(own, scene.settings))) == Questions::none)
    return "it does with " + exact_note(own, scene.settings);
  std::vector<std::string_view> names;
  for (const Plugin* plugin : vocabulary.catalog->all(Kind::scene)) {
    const Questions answers = plugin->scene->answers(Settings(plugin->parameters()));
    if (without(questions, answers) == Questions::none) names.push_back(plugin->name);
  }
  return names.empty() ? "no known scene does" : "scenes that do: " + listed(names);
}

// Who asks for what, and why if that is not plain from the name.
std::string refusal(std::string_view who, Questions missing, std::string_view why, const SceneChoice& scene,
                    const std::string& advice) {
  return fmt::format("\"{}\" asks for {}{}, which scene \"{}\" ({}) does not have; {}", who, in_words(missing), why,
                     scene.name, scene.plugin->name, advice);
}

Questions missing_in(const SceneChoice& scene, Questions questions) {
  return without(questions, scene.plugin->scene->answers(scene.settings));
}

}  // namespace

std::string mismatch(const SceneChoice& scene, const SamplerChoice& sampler, const Vocabulary& vocabulary) {
  const Questions questions = asked(sampler, vocabulary), missing = missing_in(scene, questions);
  if (missing == Questions::none) return "";
  const Questions own = sampler.plugin->sampler->asks(sampler.settings);
  const bool is_for_lookup = without(missing & Questions::surface, own) != Questions::none;
  return refusal(sampler.name, missing, is_for_lookup ? fmt::format(" (for its lookup, {})", sampler.lookup) : "",
                 scene, advice_on(questions, scene, vocabulary));
}

std::string mismatch(const SceneChoice& scene, const PassDescription& pass, const Settings& settings,
                     const Vocabulary& vocabulary) {
  const Questions questions = pass.asks(settings), missing = missing_in(scene, questions);
  if (missing == Questions::none) return "";
  return refusal(pass.name, missing, "", scene, advice_on(questions, scene, vocabulary));
}

}  // namespace moire
