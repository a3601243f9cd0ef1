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

constexpr const char* reference_lookup = "nearest";

SamplerChoice with_effort(const Plugin& plugin, Questions answered, int effort, Trust& trust) {
  SamplerChoice choice{plugin.name, &plugin, Settings(plugin.parameters()), reference_lookup};
  trust = plugin.sampler->reference(answered, effort, choice.settings);
  const std::string changed = changed_settings(plugin.parameters(), choice.settings);
  if (!changed.empty()) choice.name += "[" + changed + "]";
  return choice;
}

// What the plugin offers as a reference; `trust` none: nothing.
ReferenceChoice offered(const Plugin& plugin, Questions answered, Trust& trust) {
  trust = Trust::none;
  if (!plugin.sampler->reference) return {};
  SamplerChoice full = with_effort(plugin, answered, 2, trust);
  Trust half_trust = Trust::none;
  return {std::move(full), with_effort(plugin, answered, 1, half_trust), trust == Trust::exact};
}

// Whether such a scene answers all that the sampler asks.
bool fits(const SamplerChoice& sampler, Questions answered) {
  const Questions asked = sampler.plugin->sampler->asks(sampler.settings);
  return (asked & answered) == asked;
}

}  // namespace

ReferenceChoice best_reference(const Catalog& catalog, Questions answered) {
  std::optional<ReferenceChoice> best;
  Trust best_trust = Trust::none;
  for (const Plugin* plugin : catalog.all(Kind::sampler)) {
    Trust trust = Trust::none;
    ReferenceChoice choice = offered(*plugin, answered, trust);
    if (trust <= best_trust) continue;
    best_trust = trust;
    best = std::move(choice);
  }
  if (!best) throw Error("reference: no sampler can serve as reference for this scene; name one in the experiment");
  return *best;
}

ReferenceChoice named_reference(const SamplerChoice& named, Questions answered) {
  Trust trust = Trust::none;
  ReferenceChoice choice = offered(*named.plugin, answered, trust);
  const bool is_offered = trust != Trust::none && named.settings == choice.sampler.settings &&
                          named.lookup == choice.sampler.lookup && named.filter == choice.sampler.filter;
  if (!is_offered) return {named, {}, named.plugin->sampler->claims.exact};
  choice.sampler.name = named.name;
  return choice;
}

References choose_references(const std::optional<SamplerChoice>& named, const Catalog& catalog,
                             const SceneChoice& scene) {
  const ScenePlugin& plugin = *scene.plugin->scene;
  const Questions exact = plugin.answers(exact_settings(plugin, scene.settings)), own = plugin.answers(scene.settings);
  return {named ? named_reference(*named, exact) : best_reference(catalog, exact),
          named && fits(*named, own) ? named_reference(*named, own) : best_reference(catalog, own)};
}

std::string recipe_of(const ReferenceRequest& request) {
  return request.choice.sampler.name + (request.changes.empty() ? "" : "; " + request.changes);
}

Reference make_reference(const ReferenceRequest& request, const Frame& frame, const Workers& workers) {
  const ReferenceChoice& choice = request.choice;
  const auto picture = [&](const SamplerChoice& sampler) {
    return render_picture(Contender(sampler), frame, request.frame_number, request.seed, workers);
  };
  Reference reference{recipe_of(request), {}, 0, "", "computed now"};
  double bound = 0;
  reference.picture =
      render_picture(Contender(choice.sampler), frame, request.frame_number, request.seed, workers, &bound);
  if (choice.is_exact) {
    reference.error = exact_error + levels_of_full_scale * bound;
    reference.how =
        "exact: no sampling error; pixels are kept as floats, and two that are rounded differ by 2^-24 at most";
    if (bound > 0)
      reference.how += fmt::format("; no pixel of it is off by more than {:.2g} levels", levels_of_full_scale * bound);
  } else if (choice.half) {
    const Picture weaker = picture(*choice.half);
    reference.error = root_mean_square(differences(weaker, reference.picture, Space::linear));
    reference.how = fmt::format("rmse of {} against it: the reference, with twice as many, is nearer to the truth",
                                choice.half->name);
  } else {
    reference.error = std::nan("");
    reference.how = "unknown: the experiment names this reference";
  }
  return reference;
}

std::string trust_in(const Reference& reference, const ReferenceChoice& choice) {
  if (choice.is_exact) return "exact, no sampling error";
  if (!choice.half) return "named by the experiment, its own error is unknown";
  return fmt::format("its own error is about {:.2g} levels, the rmse of {} against it", reference.error,
                     choice.half->name);
}

std::vector<MergedBlock> exact_fragments(Against against, const ReferenceChoice& choice, const Frame& frame,
                                         int frame_number, std::uint64_t seed, const Workers& workers) {
  std::vector<MergedBlock> result(workers.blocks(frame.size()));
  const auto keep = [&](std::size_t index, const PixelBlock& block) { result[index] = MergedBlock(block); };
  if (against == Against::column) {
    workers.render(ColumnLine(frame), frame, true, keep);
  } else {
    const Contender contender(choice.sampler);
    workers.render(*contender.begin(frame, seed, frame_number), frame, true, keep);
  }
  return result;
}

}  // namespace moire
