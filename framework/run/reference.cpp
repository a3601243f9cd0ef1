#include "run/reference.h"

#include <cmath>

#include <fmt/format.h>

#include <moire/error.h>

#include "metrics/picture.h"
#include "run/column_line.h"

namespace moire {

namespace {

// Settings that are not the table's defaults: "lines=32,layout=radial".
std::string changed_settings(std::span<const Parameter> table, const Settings& settings) {
  const Settings defaults(table);
  std::string text;
  for (const Parameter& parameter : table) {
    const Value& value = settings.values().find(parameter.name)->second;
    if (value == defaults.values().find(parameter.name)->second) continue;
    if (!text.empty()) text += ',';
    text += fmt::format("{}=", parameter.name);
    std::visit([&](const auto& v) { text += fmt::format("{}", v); }, value);
  }
  return text;
}

SamplerChoice with_effort(const Plugin& plugin, Questions answered, int effort, Trust& trust) {
  SamplerChoice choice{plugin.name, &plugin, Settings(plugin.parameters()), "nearest"};
  trust = plugin.sampler->reference(answered, effort, choice.settings);
  const std::string changed = changed_settings(plugin.parameters(), choice.settings);
  if (!changed.empty()) choice.name += "[" + changed + "]";
  return choice;
}

Value value_of(const Parameter& parameter, std::string_view text) {
  switch (parameter.type) {
    case Type::flag:
      return text == "true";
    case Type::integer:
      return std::int64_t{std::stoll(std::string(text))};
    case Type::real:
      return std::stod(std::string(text));
    default:
      return std::string(text);
  }
}

}  // namespace

ReferenceChoice best_reference(const Catalog& catalog, Questions answered) {
  std::optional<ReferenceChoice> best;
  Trust best_trust = Trust::none;
  for (const Plugin* plugin : catalog.all(Kind::sampler)) {
    if (!plugin->sampler->reference) continue;
    Trust trust = Trust::none;
    SamplerChoice full = with_effort(*plugin, answered, 2, trust);
    if (trust <= best_trust) continue;
    best_trust = trust;
    best = {std::move(full), with_effort(*plugin, answered, 1, trust), best_trust == Trust::exact};
  }
  if (!best) throw Error("reference: no sampler can serve as reference for this scene; name one in the experiment");
  return *best;
}

Settings exact_settings(const ScenePlugin& scene, Settings settings) {
  for (const Parameter& parameter : scene.parameters) {
    if (!parameter.exact.empty()) settings.set(parameter.name, value_of(parameter, parameter.exact));
  }
  return settings;
}

Reference make_reference(const ReferenceChoice& choice, const std::string& scene_note, const Frame& frame,
                         int frame_number, std::uint64_t seed, const Workers& workers) {
  Reference reference;
  reference.recipe = choice.sampler.name + (scene_note.empty() ? "" : "; " + scene_note);
  reference.picture = render_picture(Contender(choice.sampler), frame, frame_number, seed, workers);
  if (choice.is_exact) {
    reference.how = "exact: no sampling error";
  } else if (choice.half) {
    const Picture weaker = render_picture(Contender(*choice.half), frame, frame_number, seed, workers);
    reference.error = root_mean_square(differences(weaker, reference.picture, Space::linear));
    reference.how = fmt::format("rmse of {} against it: the reference, with twice as many, is nearer to the truth",
                                choice.half->name);
  } else {
    reference.error = std::nan("");
    reference.how = "unknown: the experiment names this reference";
  }
  return reference;
}

std::vector<MergedBlock> exact_fragments(Against against, const ReferenceChoice& choice, const Frame& frame,
                                         int frame_number, std::uint64_t seed, const Workers& workers) {
  std::vector<MergedBlock> result(workers.blocks(frame.size()));
  const auto keep = [&](std::size_t index, const PixelBlock& block) { result[index] = MergedBlock(block); };
  if (against == Against::column) {
    workers.render(ColumnLine(frame), frame.size(), true, keep);
  } else {
    const Contender contender(choice.sampler);
    workers.render(*contender.begin(frame, seed, frame_number), frame.size(), true, keep);
  }
  return result;
}

}  // namespace moire
